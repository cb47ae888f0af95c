// The one place where a key's question becomes a question to the walk.

#include "ui/kiosk/kiosk.h"

namespace farol::ui {

void Kiosk::answer(KioskQuestion question) {
    switch (question) {
    case KioskQuestion::WhereAmI:
        return m_walk.ask(guidance::Question::WhereAmI);
    case KioskQuestion::AroundMe:
        return m_walk.ask(guidance::Question::AroundMe);
    case KioskQuestion::Next:
        return m_walk.ask(guidance::Question::Next);
    case KioskQuestion::Remaining:
        return m_walk.ask(guidance::Question::Remaining);
    case KioskQuestion::Repeat:
        return m_walk.ask(guidance::Question::Repeat);
    case KioskQuestion::Preview:
        return m_walk.ask(guidance::Question::Preview);
    }
}

} // namespace farol::ui
