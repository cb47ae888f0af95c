#include "core/base/error.h"

namespace farol {

const char* errorCodeName(ErrorCode code) {
    switch (code) {
    case ErrorCode::InvalidArgument:
        return "invalid_argument";
    case ErrorCode::NotFound:
        return "not_found";
    case ErrorCode::UnsupportedFormat:
        return "unsupported_format";
    case ErrorCode::Corrupt:
        return "corrupt";
    case ErrorCode::Io:
        return "io";
    case ErrorCode::NoSpace:
        return "no_space";
    case ErrorCode::Unavailable:
        return "unavailable";
    case ErrorCode::Conflict:
        return "conflict";
    case ErrorCode::Internal:
        return "internal";
    }
    return "internal";
}

std::string Error::text() const {
    return context.empty() ? message : context + ": " + message;
}

} // namespace farol
