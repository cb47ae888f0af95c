#pragma once
// The assistant's word where the user is: it counts at once, and for as long as the walk agrees and knows no
// better. When the pictures soon speak for another place after all, that is told too.

#include "core/localisation/localiser.h"

#include <optional>

namespace farol::ui {

class ToldPlace {
public:
    /// `region` empty: the place shown is wrong, and not known.
    void tell(const std::optional<RegionId>& region);
    void clear() { m_state = State::None; }
    /// Each fix of the walk, in order.
    void heard(const localisation::Fix& fix);

    /// The fix to be shown instead of the walk's own.
    bool holds() const { return m_state == State::Waiting || m_state == State::Agreed; }
    bool overruled() const { return m_state == State::Overruled; }
    const std::optional<RegionId>& region() const { return m_region; }
    /// The walk's own while it agrees (it may know the spot), else the bare word.
    localisation::Fix shown(const localisation::Fix& fix, const building::Building& building) const;

private:
    enum class State { None, Waiting, Agreed, Overruled };

    State m_state = State::None;
    std::optional<RegionId> m_region;
    std::optional<double> m_since; ///< time of the first fix after it was told
    int m_before = 0;              ///< fixes that were on their way when it was told, so far
};

} // namespace farol::ui
