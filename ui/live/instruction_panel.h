#pragma once
// What is to be done next, in large letters, and whether the voice works.

#include "core/session/percept.h"
#include "ui/speech/speech_queue.h"

#include <QFrame>

#include <memory>
#include <optional>

class QLabel;

namespace farol::ui {

class InstructionPanel : public QFrame {
    Q_OBJECT

public:
    explicit InstructionPanel(QWidget* parent = nullptr);

    void setBuilding(std::shared_ptr<const building::Building> building);
    void show(const std::shared_ptr<const session::Snapshot>& snapshot); ///< null: nothing yet
    void note(const Utterance& utterance);
    void setVoice(const QString& status, bool trouble);
    /// A sentence of the program itself, such as "The walk has ended"; until the next utterance.
    void setNotice(const QString& text);
    QString sentence() const;
    QString way() const;
    QString voiceText() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    QString progressText() const;
    bool outdated() const; ///< what was said last no longer holds

    std::shared_ptr<const building::Building> m_building;
    std::shared_ptr<const session::Snapshot> m_snapshot;
    QString m_said;
    std::optional<guidance::Cue> m_saidCue;
    QString m_voiceStatus;
    bool m_voiceTrouble = false;
    QLabel* m_sentence;
    QLabel* m_way;
    QLabel* m_voice;
};

} // namespace farol::ui
