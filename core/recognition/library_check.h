#pragma once
// Will a template be found, and what is it confused with? Each view is held back once and looked for with the
// rest.

#include "core/recognition/landmark_recogniser.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace farol::recognition {

struct TemplateCheck {
    TemplateId id;
    int views = 0;
    int tested = 0; ///< views that could be held back: none where a template has only one
    int found = 0;  ///< of those
    std::map<std::string, int> confusedWith; ///< other templates named in its views, and how often
};

/// In the library's order. `progress` is told views done and in all.
std::vector<TemplateCheck> checkLibrary(const LandmarkLibrary& library, const RecogniserOptions& options = {},
                                        const std::function<void(std::size_t, std::size_t)>& progress = {});

} // namespace farol::recognition
