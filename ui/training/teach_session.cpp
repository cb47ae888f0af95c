#include "ui/training/teach_session.h"

#include "core/recognition/training.h"
#include "ui/convert/convert.h"
#include "ui/models/core_words.h"

#include <algorithm>
#include <utility>

namespace farol::ui {

using recognition::LandmarkLibrary;
using recognition::Template;

TeachSession::TeachSession(const QString& draftFolder, QObject* parent)
    : QObject(parent),
      m_store(draftFolder),
      m_stop(std::make_shared<std::atomic<bool>>(false)),
      m_background(this) {}

TeachSession::~TeachSession() {
    m_stop->store(true);
}

void TeachSession::begin(Library library, TeachDraft draft) {
    end(true);
    m_active = true;
    m_library = std::move(library);
    m_draft = std::move(draft);
    m_old.reset();
    if (m_draft.extends) {
        const Template* known = m_library->find(TemplateId(toUtf8(m_draft.id)));
        if (known != nullptr)
            m_old = *known;
        else
            m_draft.extends = false; // it was deleted meanwhile: its new views become a template of their own
    }
    m_trained = m_old;
    keep();
    if (!m_draft.views.empty())
        train(std::nullopt);
    else if (m_trained)
        checkHealth();
    Q_EMIT changed();
}

void TeachSession::end(bool keepDraft) {
    ++m_serial;
    ++m_checkSerial;
    m_stop->store(true);
    m_active = m_judging = m_trying = m_finding = m_training = m_checking = false;
    m_toJudge.reset();
    m_toTry.reset();
    m_trained.reset();
    m_old.reset();
    m_health.reset();
    m_recogniser.reset();
    m_library.reset();
    if (!keepDraft) m_store.clear();
}

void TeachSession::keep() {
    if (!m_active || !m_draft.worthKeeping()) return;
    if (auto done = m_store.save(m_draft); !done) Q_EMIT unkept(CoreWords::problem(done.error()));
}

recognition::TrainingRequest TeachSession::request() const {
    recognition::TrainingRequest request;
    request.id = TemplateId(toUtf8(m_draft.id));
    request.kind = m_draft.kind;
    request.name = toUtf8(m_draft.name);
    if (m_draft.widthM > 0.0) request.widthM = m_draft.widthM;
    if (m_draft.heightM > 0.0) request.heightM = m_draft.heightM;
    return request;
}

void TeachSession::setWhat(const QString& name, const QString& id, Kind kind, double widthM, double heightM) {
    const bool otherSort = (kind == Kind::Place) != (m_draft.kind == Kind::Place);
    m_draft.name = name;
    m_draft.id = id;
    m_draft.kind = kind;
    m_draft.widthM = widthM;
    m_draft.heightM = heightM;
    keep();
    if (m_trained) {
        const recognition::TrainingRequest now = request();
        m_trained->id = now.id;
        m_trained->name = now.name;
        m_trained->kind = now.kind;
        m_trained->widthM = now.widthM;
        m_trained->heightM = now.heightM;
        m_recogniser.reset();
        if (otherSort)
            train(std::nullopt);
        else
            checkHealth();
    }
    Q_EMIT changed();
}

void TeachSession::setStep(int step) {
    m_draft.step = step;
    keep();
}

QString TeachSession::nameProblem() const {
    if (m_draft.name.trimmed().isEmpty()) return tr("Give it a name first.");
    if (m_draft.id.isEmpty()) return tr("Say what maps shall call it: letters and digits.");
    if (!m_draft.extends && m_library && m_library->find(TemplateId(toUtf8(m_draft.id))) != nullptr)
        return tr("“%1” is in the library already. Choose another name, or add views to that one.")
            .arg(m_draft.id);
    return {};
}

void TeachSession::judge(const cv::Mat& image, const std::optional<Quad>& outline) {
    m_toJudge = Question{image, outline};
    if (!m_judging) startJudging();
}

void TeachSession::startJudging() {
    if (!m_toJudge) return;
    const Question question = *std::exchange(m_toJudge, std::nullopt);
    m_judging = true;
    m_background.run(
        [question, kind = m_draft.kind, extractor = m_library->extractor] {
            return recognition::judgePicture(question.image, kind, question.outline, extractor);
        },
        [this, serial = m_serial](recognition::PictureQuality quality) {
            if (serial != m_serial) return;
            m_judging = false;
            Q_EMIT judged(quality);
            startJudging();
        });
}

void TeachSession::lookForOutline(const cv::Mat& image) {
    if (m_finding) return;
    m_finding = true;
    m_background.run(
        [image, library = m_library, known = m_trained] {
            return recognition::findOutline(image, *library, known ? &*known : nullptr);
        },
        [this, serial = m_serial](std::optional<Quad> outline) {
            if (serial != m_serial) return;
            m_finding = false;
            Q_EMIT outlineFound(outline);
        });
}

std::shared_ptr<LandmarkLibrary> TeachSession::combined() const {
    auto all = std::make_shared<LandmarkLibrary>(*m_library);
    if (!m_trained) return all;
    for (Template& entry : all->templates) {
        if (entry.id != m_trained->id) continue;
        entry = *m_trained;
        return all;
    }
    all->templates.push_back(*m_trained);
    return all;
}

void TeachSession::tryOn(const cv::Mat& image) {
    m_toTry = image;
    if (!m_trying) startTrying();
}

void TeachSession::startTrying() {
    if (!m_toTry || !m_trained) return;
    const cv::Mat image = *std::exchange(m_toTry, std::nullopt);
    m_trying = true;
    struct Answer {
        std::shared_ptr<recognition::LandmarkRecogniser> recogniser;
        recognition::DetectorResult result;
    };
    // The library is copied here: the trained template may change while the job runs.
    const auto library = m_recogniser ? nullptr : combined();
    m_background.run(
        [image, library, recogniser = m_recogniser]() mutable {
            if (!recogniser) recogniser = std::make_shared<recognition::LandmarkRecogniser>(library);
            recognition::DetectorResult result = recogniser->recognise(image);
            return Answer{std::move(recogniser), std::move(result)};
        },
        [this, serial = m_serial, check = m_checkSerial](Answer answer) {
            if (serial != m_serial) return;
            m_trying = false;
            if (check == m_checkSerial) m_recogniser = std::move(answer.recogniser);
            Q_EMIT tried(answer.result);
            startTrying();
        });
}

void TeachSession::addView(const std::string& bytes, const Quad& outline) {
    if (m_training) return;
    train(DraftView{bytes, outline});
}

void TeachSession::removeView(std::size_t index) {
    if (m_training || index >= m_draft.views.size()) return;
    m_draft.views.erase(m_draft.views.begin() + static_cast<std::ptrdiff_t>(index));
    keep();
    if (m_draft.views.empty()) {
        m_trained = m_old;
        m_recogniser.reset();
        checkHealth();
        Q_EMIT changed();
    } else {
        train(std::nullopt);
    }
}

void TeachSession::train(std::optional<DraftView> fresh) {
    m_training = true;
    std::vector<DraftView> views = m_draft.views;
    std::optional<Template> from = m_old;
    if (fresh && m_trained && m_trained->views.size() == oldViews() + views.size()) {
        from = m_trained; // what is there stays: only the new one is trained
        views.clear();
    }
    if (fresh) views.push_back(*fresh);
    m_background.run(
        [views = std::move(views), from = std::move(from), request = request(),
         extractor = m_library->extractor]() mutable -> Result<Template> {
            LandmarkLibrary scratch;
            scratch.extractor = extractor;
            // A draft can have no name yet, which training asks for.
            if (request.id.empty()) request.id = TemplateId("unnamed");
            if (from) {
                from->id = request.id;
                from->kind = request.kind;
                scratch.templates.push_back(std::move(*from));
            }
            for (const DraftView& view : views)
                if (auto added = recognition::addView(scratch, request, view.bytes, view.outline); !added)
                    return added.error();
            return std::move(scratch.templates.front());
        },
        [this, serial = m_serial, fresh = std::move(fresh)](Result<Template> result) {
            if (serial == m_serial) trained(std::move(result), fresh);
        });
    Q_EMIT changed();
}

void TeachSession::trained(Result<Template> result, std::optional<DraftView> fresh) {
    m_training = false;
    if (!result) {
        Q_EMIT changed();
        return void(Q_EMIT refused(CoreWords::problem({result.error().code, result.error().message, {}})));
    }
    m_trained = std::move(*result);
    m_trained->id = TemplateId(toUtf8(m_draft.id));
    if (fresh) m_draft.views.push_back(std::move(*fresh));
    m_recogniser.reset();
    keep();
    checkHealth();
    Q_EMIT changed();
    if (fresh) Q_EMIT viewAdded();
}

void TeachSession::checkHealth() {
    m_stop->store(true);
    m_stop = std::make_shared<std::atomic<bool>>(false);
    const std::uint64_t check = ++m_checkSerial;
    m_health.reset();
    m_checking = m_trained.has_value() && !m_trained->id.empty();
    if (!m_checking) return;
    m_background.run([library = combined(), id = m_trained->id,
                      stop = m_stop] { return recognition::checkTemplate(*library, id, {}, stop.get()); },
                     [this, check](std::optional<recognition::TemplateCheck> health) {
                         if (check != m_checkSerial) return;
                         m_checking = false;
                         m_health = std::move(health);
                         Q_EMIT changed();
                     });
}

recognition::Advice TeachSession::next() const {
    return recognition::nextView(m_trained ? m_trained->views : std::vector<recognition::View>(),
                                 m_draft.kind);
}

std::function<Result<recognition::LibraryStep>(const LandmarkLibrary&)> TeachSession::finished() const {
    return [entry = m_trained,
            extends = m_draft.extends](const LandmarkLibrary& library) -> Result<recognition::LibraryStep> {
        if (!entry) return Error{ErrorCode::InvalidArgument, toUtf8(tr("there is no view yet")), ""};
        if (!extends) return recognition::insertion(library, *entry);
        for (std::size_t i = 0; i < library.templates.size(); ++i)
            if (library.templates[i].id == entry->id) return recognition::change(library, i, *entry);
        return recognition::insertion(library, *entry);
    };
}

} // namespace farol::ui
