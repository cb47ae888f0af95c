// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/speech/espeak_engine/espeak_plugin.h"

#include "ui/speech/espeak_engine/espeak_engine.h"

QTextToSpeechEngine* EspeakPlugin::createTextToSpeechEngine(const QVariantMap& parameters, QObject* parent,
                                                            QString* errorString) const {
    auto engine = std::make_unique<farol::espeak::EspeakEngine>(parameters, parent);
    if (engine->state() == QTextToSpeech::Error && errorString != nullptr)
        *errorString = engine->errorString();
    return engine.release();
}
