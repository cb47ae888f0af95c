#include "ui/speech/phrasebook.h"
namespace farol::ui {
QString Phrasebook::sentence(const guidance::Cue& /*cue*/) const { return {}; }
} // namespace farol::ui
