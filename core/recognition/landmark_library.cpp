#include "core/recognition/landmark_library.h"

#include <algorithm>

namespace farol::recognition {

const Template* LandmarkLibrary::find(const TemplateId& id) const {
    auto found =
        std::find_if(templates.begin(), templates.end(), [&](const Template& t) { return t.id == id; });
    return found == templates.end() ? nullptr : &*found;
}

std::size_t LandmarkLibrary::viewCount() const {
    std::size_t count = 0;
    for (const Template& entry : templates) count += entry.views.size();
    return count;
}

} // namespace farol::recognition
