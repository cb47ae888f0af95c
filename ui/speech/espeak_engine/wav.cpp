// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/speech/espeak_engine/wav.h"

#include <QDataStream>
#include <QSaveFile>

namespace farol::espeak {

QString writeWav(const QString& path, const Sound& sound) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return path + QStringLiteral(": ") + file.errorString();
    QDataStream out(&file);
    out.setByteOrder(QDataStream::LittleEndian);
    const auto bytes = static_cast<quint32>(sound.samples.size());
    const auto rate = static_cast<quint32>(sound.sampleRate);
    out.writeRawData("RIFF", 4);
    out << quint32(36 + bytes);
    out.writeRawData("WAVEfmt ", 8);
    out << quint32(16) << quint16(1) << quint16(1) << rate << quint32(rate * 2) << quint16(2) << quint16(16);
    out.writeRawData("data", 4);
    out << bytes;
    out.writeRawData(sound.samples.constData(), static_cast<int>(sound.samples.size()));
    if (out.status() != QDataStream::Ok || !file.flush() || !file.commit())
        return path + QStringLiteral(": ") + file.errorString();
    return {};
}

} // namespace farol::espeak
