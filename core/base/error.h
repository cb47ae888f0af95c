#pragma once
// Errors outside our control (files, devices, input) travel as values. Exceptions of OpenCV, GDAL and SQLite
// are caught at the adapter and become one of these; our own mistakes are assertions.

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace farol {

enum class ErrorCode {
    InvalidArgument,   // a value or an option is out of its range
    NotFound,          // a file, layer, region or template that was named does not exist
    UnsupportedFormat, // the file is of another kind, or of a later version than this program
    Corrupt,           // the file is of the right kind but damaged or incomplete
    Io,                // reading or writing failed
    NoSpace,           // the disk is full
    Unavailable,       // a device, engine or connection is not there now
    Conflict,          // two things do not fit together, such as a library and another extractor
    Internal,          // a library failed in a way it does not explain
};

/// The stable, lower-case name of a code, as it stands in JSON.
const char* errorCodeName(ErrorCode code);

/// What is wrong, where, and what to do: `message` is one English sentence for people, `context` names the
/// file, layer, feature or option ("corridor.gpkg, layer regions, feature 12").
struct Error {
    ErrorCode code = ErrorCode::Internal;
    std::string message;
    std::string context;

    /// "context: message", or the message alone.
    std::string text() const;
};

/// A value or an Error. Checked access only: `value()` on an error is our own mistake and asserts.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}     // NOLINT: converts on purpose
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {} // NOLINT: converts on purpose

    bool ok() const { return m_state.index() == 0; }
    explicit operator bool() const { return ok(); }
    T& value() & {
        assert(ok());
        return std::get<0>(m_state);
    }
    const T& value() const& {
        assert(ok());
        return std::get<0>(m_state);
    }
    T&& value() && {
        assert(ok());
        return std::get<0>(std::move(m_state));
    }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    const Error& error() const {
        assert(!ok());
        return std::get<1>(m_state);
    }

private:
    std::variant<T, Error> m_state;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : m_error(std::move(error)) {} // NOLINT: converts on purpose

    bool ok() const { return !m_error.has_value(); }
    explicit operator bool() const { return ok(); }
    const Error& error() const {
        assert(!ok());
        return *m_error;
    }

private:
    std::optional<Error> m_error;
};

} // namespace farol
