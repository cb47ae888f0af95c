#include "ui/kiosk/chimes.h"

#include <QAudioFormat>
#include <QAudioSink>
#include <QBuffer>
#include <QMediaDevices>
#include <QThread>

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::ui {

namespace {

constexpr int kRate = 48000;
constexpr double kToneSeconds = 0.12;
constexpr double kEdgeSeconds = 0.01; // without soft edges a tone clicks
constexpr double kLoudness = 0.25;    // below the voice
constexpr double kPi = 3.14159265358979323846;
/// A program that ends does not wait longer for a sound device that hangs.
constexpr unsigned long kFarewellMs = 1000;

/// Lives in the thread; one sound replaces the other.
class Player : public QObject {
public:
    void play(Sound sound) {
        QAudioFormat format;
        format.setSampleRate(kRate);
        format.setChannelCount(1);
        format.setSampleFormat(QAudioFormat::Int16);
        const QAudioDevice device = QMediaDevices::defaultAudioOutput();
        m_sink.reset();
        if (device.isNull() || !device.isFormatSupported(format)) return;
        m_buffer.close();
        m_buffer.setData(chimeSamples(sound));
        m_buffer.open(QIODevice::ReadOnly);
        m_sink = std::make_unique<QAudioSink>(device, format);
        m_sink->start(&m_buffer);
    }

private:
    QBuffer m_buffer{this};
    std::unique_ptr<QAudioSink> m_sink;
};

class ThreadedChimes : public Chimes {
public:
    ~ThreadedChimes() override {
        if (!m_thread) return;
        m_thread->quit();
        if (m_thread->wait(kFarewellMs)) delete m_thread;
    }

    void play(Sound sound) override {
        if (!m_thread) {
            m_thread = new QThread;
            m_thread->setObjectName(QStringLiteral("chimes"));
            m_player = new Player;
            m_player->moveToThread(m_thread);
            connect(m_thread, &QThread::finished, m_player, &QObject::deleteLater);
            m_thread->start();
        }
        QMetaObject::invokeMethod(m_player, [player = m_player, sound] { player->play(sound); });
    }

private:
    QThread* m_thread = nullptr;
    Player* m_player = nullptr; ///< lives in m_thread
};

} // namespace

QByteArray chimeSamples(Sound sound) {
    const std::array<double, 2> tones =
        sound == Sound::Fix ? std::array<double, 2>{660.0, 990.0} : std::array<double, 2>{440.0, 294.0};
    const int length = static_cast<int>(kToneSeconds * kRate);
    QByteArray samples;
    samples.reserve(static_cast<qsizetype>(tones.size()) * length * 2);
    for (const double tone : tones) {
        for (int i = 0; i < length; ++i) {
            const double seconds = static_cast<double>(i) / kRate;
            const double edge =
                std::min({1.0, seconds / kEdgeSeconds, (kToneSeconds - seconds) / kEdgeSeconds});
            const double value = kLoudness * edge * std::sin(2.0 * kPi * tone * seconds);
            const auto sample = static_cast<qint16>(std::lround(value * 32767.0));
            samples.append(reinterpret_cast<const char*>(&sample), sizeof sample);
        }
    }
    return samples;
}

std::unique_ptr<Chimes> makeChimes() {
    return std::make_unique<ThreadedChimes>();
}

} // namespace farol::ui
