#pragma once
// What the kiosk said, when and why, as JSON lines: for tests that use it as a blind user does, by its keys
// and its words alone, and for those who look into a complaint.
//   {"type":"key","at":5123.004,"key":"Down"}
//   {"type":"utterance","at":5123.009,"state":"speaking","text":"…","cause":"key","key":"Down","age_ms":5}
//   {"type":"utterance","at":5130.100,"state":"speaking","text":"…","cause":"act","cue":12,"frame":301,"age_ms":140}
//   {"type":"truth","at":5131.000,"region":"r12"}
// `at` are seconds of the machine's monotonic clock. `age_ms` runs from the key, or from the picture behind a
// cue (in the walk's time). Causes: "key" (the program's own answer), "program" (its own news), else the
// kind of the cue; "asked" is true, and `key` is there, when the cue answers a key. "truth" is where a
// simulated user really is, in ids of the map.

#include "ui/kiosk/kiosk_keys.h"
#include "ui/speech/speech_queue.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonObject>
#include <QString>

namespace farol::ui {

class UtteranceLog {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::UtteranceLog)

public:
    /// `file` empty: nothing is written. One that is there is continued, as after a crash.
    explicit UtteranceLog(const QString& file);
    /// Why nothing is written although it was wanted; for those who help.
    const QString& trouble() const { return m_trouble; }

    void setNow(double time); ///< the walk's clock
    void writeKey(const KioskKey& key);
    void writeHold(); ///< the Escape key was held down
    void writeTruth(const RegionId& region);
    void endKey() { m_inKey = false; }
    void write(const Utterance& utterance);

private:
    void begin(const QString& key);
    void tellCause(const Utterance& utterance, double at, QJsonObject& line) const;
    void writeLine(const QJsonObject& object);

    QFile m_file;
    QString m_trouble, m_key;
    double m_keyAt = 0.0, m_now = 0.0, m_nowAt = 0.0;
    bool m_inKey = false;
};

} // namespace farol::ui
