#pragma once
// A landmark being taught: what it is, its views, and what is known of how well it will be found. Slow things
// are worked out in the background; every step is kept on disk. GUI thread.

#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/library_check.h"
#include "core/recognition/library_edit.h"
#include "core/recognition/training.h"
#include "core/recognition/view_coach.h"
#include "ui/convert/background.h"
#include "ui/training/teach_draft.h"

#include <QObject>
#include <QTimer>

#include <atomic>
#include <memory>
#include <optional>

namespace farol::ui {

class TeachSession : public QObject {
    Q_OBJECT

public:
    using Library = std::shared_ptr<const recognition::LandmarkLibrary>;

    explicit TeachSession(const QString& draftFolder, QObject* parent = nullptr);
    ~TeachSession() override; ///< what is being worked out is given up

    std::optional<TeachDraft> unfinished() const { return m_store.load(); }
    void forgetUnfinished() { m_store.clear(); }

    /// The views of the draft are trained anew, in the background.
    void begin(Library library, TeachDraft draft);
    void end(bool keepDraft);

    void setWhat(const QString& name, const QString& id, Kind kind, double widthM, double heightM);
    void setStep(int step);
    /// The answers come as signals; a newer question replaces one that is not answered yet.
    void judge(const cv::Mat& image, const std::optional<Quad>& outline);
    void lookForOutline(const cv::Mat& image);
    void tryOn(const cv::Mat& image);
    void addView(const std::string& bytes, const Quad& outline);
    void removeView(std::size_t index); ///< of the draft

    const TeachDraft& draft() const { return m_draft; }
    /// With all its views, also those it had before; null: none yet.
    const recognition::Template* trained() const { return m_trained ? &*m_trained : nullptr; }
    std::size_t oldViews() const { return m_old ? m_old->views.size() : 0; }
    const std::optional<recognition::TemplateCheck>& health() const { return m_health; }
    bool checking() const { return m_checking; }
    bool training() const { return m_training; }
    bool settled() const { return !m_training && !m_checking && !m_judging && !m_finding && !m_trying; }
    recognition::Advice next() const;
    /// Empty: the name can be used.
    QString nameProblem() const;
    /// What adds it to the library, or changes it there.
    std::function<Result<recognition::LibraryStep>(const recognition::LandmarkLibrary&)> finished() const;

Q_SIGNALS:
    void changed(); ///< views, health, what it is
    void viewAdded();
    void judged(const farol::recognition::PictureQuality& quality);
    void outlineFound(const std::optional<farol::Quad>& outline);
    void tried(const farol::recognition::DetectorResult& result);
    void refused(const QString& message);
    void unkept(const QString& message); ///< the draft could not be written

private:
    recognition::TrainingRequest request() const;
    void keep();
    void train(std::optional<DraftView> fresh);
    void trained(Result<recognition::Template> result, std::optional<DraftView> fresh);
    void checkHealth();
    void startJudging();
    void startTrying();
    std::shared_ptr<recognition::LandmarkLibrary> combined() const;

    DraftStore m_store;
    Library m_library;
    TeachDraft m_draft;
    std::optional<recognition::Template> m_old, m_trained;
    std::optional<recognition::TemplateCheck> m_health;
    std::shared_ptr<recognition::LandmarkRecogniser> m_recogniser; ///< of combined(), made when wanted
    struct Question {
        cv::Mat image;
        std::optional<Quad> outline;
    };
    std::optional<Question> m_toJudge;
    std::optional<cv::Mat> m_toTry;
    bool m_judging = false, m_trying = false, m_finding = false, m_training = false, m_checking = false;
    bool m_active = false;
    std::uint64_t m_serial = 0;      ///< of the session that counts
    std::uint64_t m_checkSerial = 0; ///< of the check that counts
    std::shared_ptr<std::atomic<bool>> m_stop;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
