#include "ui/kiosk/utterance_log.h"

#include <QJsonDocument>
#include <QKeySequence>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace farol::ui {

namespace {

double clockNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double rounded(double value, double per) {
    return std::round(value * per) / per;
}

QString nameOf(UtteranceState state) {
    switch (state) {
    case UtteranceState::Waiting:
        return QStringLiteral("waiting");
    case UtteranceState::Speaking:
        return QStringLiteral("speaking");
    case UtteranceState::Spoken:
        return QStringLiteral("spoken");
    case UtteranceState::Interrupted:
        return QStringLiteral("interrupted");
    case UtteranceState::Expired:
        return QStringLiteral("expired");
    case UtteranceState::Shown:
        break;
    }
    return QStringLiteral("shown");
}

} // namespace

UtteranceLog::UtteranceLog(const QString& file) : m_file(file) {
    if (file.isEmpty() || m_file.open(QIODevice::WriteOnly | QIODevice::Append)) return;
    m_trouble =
        tr("What is said cannot be written to %1: %2. Choose another file.").arg(file, m_file.errorString());
}

void UtteranceLog::setNow(double time) {
    m_now = time;
    m_nowAt = clockNow();
}

void UtteranceLog::writeKey(const KioskKey& key) {
    const QString name = QKeySequence(key.key).toString(QKeySequence::PortableText);
    begin(key.keypad ? QStringLiteral("Num+") + name : name);
}

void UtteranceLog::writeHold() {
    begin(QStringLiteral("Esc held"));
}

void UtteranceLog::writeTruth(const RegionId& region) {
    writeLine({{QStringLiteral("type"), QStringLiteral("truth")},
               {QStringLiteral("at"), clockNow()},
               {QStringLiteral("region"), QString::fromStdString(region.value)}});
}

void UtteranceLog::begin(const QString& key) {
    m_key = key;
    m_keyAt = clockNow();
    m_inKey = true;
    writeLine({{QStringLiteral("type"), QStringLiteral("key")},
               {QStringLiteral("at"), m_keyAt},
               {QStringLiteral("key"), key}});
}

void UtteranceLog::write(const Utterance& utterance) {
    if (!m_file.isOpen()) return;
    const double at = clockNow();
    const guidance::Cue& cue = utterance.cue;
    QJsonObject line{{QStringLiteral("type"), QStringLiteral("utterance")},
                     {QStringLiteral("at"), at},
                     {QStringLiteral("state"), nameOf(utterance.state)},
                     {QStringLiteral("text"), utterance.text}};
    const bool begins = utterance.state == UtteranceState::Waiting ||
                        utterance.state == UtteranceState::Speaking ||
                        utterance.state == UtteranceState::Shown;
    if (!utterance.own) line[QStringLiteral("cue")] = static_cast<qint64>(cue.id);
    if (begins) tellCause(utterance, at, line);
    writeLine(line);
}

void UtteranceLog::tellCause(const Utterance& utterance, double at, QJsonObject& line) const {
    const guidance::Cue& cue = utterance.cue;
    const bool answers = utterance.own ? m_inKey : cue.asked;
    if (answers && !m_key.isEmpty()) line[QStringLiteral("key")] = m_key;
    if (utterance.own) {
        line[QStringLiteral("cause")] = answers ? QStringLiteral("key") : QStringLiteral("program");
        if (answers) line[QStringLiteral("age_ms")] = rounded(1000.0 * (at - m_keyAt), 10.0);
        return;
    }
    line[QStringLiteral("cause")] = QString::fromStdString(guidance::cueKindName(cue.kind));
    line[QStringLiteral("frame")] = static_cast<qint64>(cue.frame);
    if (cue.asked) line[QStringLiteral("asked")] = true;
    const double sinceStep = m_nowAt > 0.0 ? at - m_nowAt : 0.0;
    line[QStringLiteral("age_ms")] = rounded(1000.0 * std::max(0.0, m_now + sinceStep - cue.time), 10.0);
}

void UtteranceLog::writeLine(const QJsonObject& object) {
    if (!m_file.isOpen()) return;
    const QByteArray line = QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
    const bool written = m_file.write(line) == line.size() && m_file.flush(); // somebody may be following it
    if (written || !m_trouble.isEmpty()) return;
    m_trouble = tr("What is said cannot be written to %1: %2. Choose another file.")
                    .arg(m_file.fileName(), m_file.errorString());
}

} // namespace farol::ui
