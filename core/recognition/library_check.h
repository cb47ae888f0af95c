#pragma once
// Will a template be found, from how far and how far aside, and what is it confused with? Each view is held
// back once and looked for with the rest; then the best photograph is shown smaller and turned by
// computation, in poses that training does not make, until it is found no more.

#include "core/recognition/landmark_recogniser.h"

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace farol::recognition {

struct TemplateCheck {
    TemplateId id;
    int views = 0;
    int tested = 0; ///< views that could be held back: none where a template has only one
    int found = 0;  ///< of those
    /// Other templates named in its views, held back or made, and how often: a row of the table of who is
    /// taken for whom.
    std::map<std::string, int> confusedWith;
    /// Other templates in whose photographs it is named, and in how many; told by checkTemplate() alone.
    std::map<std::string, int> seenIn;
    int shown = 0;      ///< views made by computation; none of a place
    int shownFound = 0; ///< of those
    /// Longer side, in pixels of a frame 640 wide, at which it is still found squarely; 0 where never.
    double smallestPx = 0.0;
    std::optional<double>
        farthestM;              ///< the same in metres for a 56 degree lens, where the real size is known
    double widestDegrees = 0.0; ///< turned so far aside it is still found at 200 pixels; -1 where never
};

/// In the library's order. `progress` is told pictures done and in all. Once `stop` is set, what was looked
/// at until then is told.
std::vector<TemplateCheck> checkLibrary(const LandmarkLibrary& library, const RecogniserOptions& options = {},
                                        const std::function<void(std::size_t, std::size_t)>& progress = {},
                                        const std::atomic<bool>* stop = nullptr);

/// The same for one template among the others, with what others are taken for it; empty where there is no
/// such template, or once `stop` is set.
std::optional<TemplateCheck> checkTemplate(const LandmarkLibrary& library, const TemplateId& id,
                                           const RecogniserOptions& options = {},
                                           const std::atomic<bool>* stop = nullptr);

} // namespace farol::recognition
