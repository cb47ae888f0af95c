#include "core/recognition/library_check.h"

#include "core/capture/picture.h"

#include <algorithm>

namespace farol::recognition {

namespace {

/// The library without view `held` of every template that has others.
std::shared_ptr<const LandmarkLibrary> without(const LandmarkLibrary& library, std::size_t held) {
    auto rest = std::make_shared<LandmarkLibrary>(library);
    for (Template& entry : rest->templates)
        if (entry.views.size() > 1 && held < entry.views.size())
            entry.views.erase(entry.views.begin() + static_cast<std::ptrdiff_t>(held));
    return rest;
}

void look(const LandmarkRecogniser& recogniser, const View& view, bool heldBack, TemplateCheck& check) {
    auto image = capture::decodePicture(view.jpeg, check.id.value);
    if (!image) return;
    bool found = false;
    for (const Detection& detection : recogniser.recognise(*image).detections) {
        if (detection.templateId == check.id)
            found = true;
        else
            ++check.confusedWith[detection.templateId.value];
    }
    if (!heldBack) return;
    ++check.tested;
    if (found) ++check.found;
}

} // namespace

std::vector<TemplateCheck> checkLibrary(const LandmarkLibrary& library, const RecogniserOptions& options,
                                        const std::function<void(std::size_t, std::size_t)>& progress) {
    std::vector<TemplateCheck> checks;
    std::size_t rounds = 0;
    for (const Template& entry : library.templates) {
        checks.push_back({entry.id, static_cast<int>(entry.views.size()), 0, 0, {}});
        rounds = std::max(rounds, entry.views.size());
    }
    std::size_t done = 0;
    // One view of every template at a time: as many indexes as the richest template has views, not one for
    // each.
    for (std::size_t held = 0; held < rounds; ++held) {
        LandmarkRecogniser recogniser(without(library, held), options);
        for (std::size_t i = 0; i < library.templates.size(); ++i) {
            const Template& entry = library.templates[i];
            if (held >= entry.views.size()) continue;
            look(recogniser, entry.views[held], entry.views.size() > 1, checks[i]);
            if (progress) progress(++done, library.viewCount());
        }
    }
    return checks;
}

} // namespace farol::recognition
