#pragma once
// A voice that keeps what it is given.

#include "ui/speech/speech_output.h"

#include <QStringList>
#include <QTest>

namespace farol::test {

/// A voice that speaks until told that it has finished.
class RecordingOutput : public ui::SpeechOutput {
public:
    void say(const QString& text) override {
        said << text;
        if (!broken.isEmpty()) {
            Q_EMIT failed(broken);
            return;
        }
        m_speaking = true;
    }
    void stop() override {
        ++stops;
        m_speaking = false;
    }
    bool speaking() const override { return m_speaking; }
    QString description() const override { return QStringLiteral("recording"); }
    void finish() {
        QVERIFY(m_speaking);
        m_speaking = false;
        Q_EMIT finished();
    }

    QStringList said;
    QString broken; ///< a message: every text fails with it
    int stops = 0;

private:
    bool m_speaking = false;
};

} // namespace farol::test
