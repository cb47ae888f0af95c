// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/speech/espeak_engine/espeak_library.h"

#include <QString>

namespace farol::espeak {

/// Whole or not at all. Empty when it worked, else why not.
QString writeWav(const QString& path, const Sound& sound);

} // namespace farol::espeak
