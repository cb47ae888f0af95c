#include "core/recognition/landmark_library.h"

#include <algorithm>

namespace farol::recognition {

bool sameLook(const Template& a, const Template& b) {
    auto same = [](const View& x, const View& y) {
        const cv::Mat &dx = x.features.descriptors, &dy = y.features.descriptors;
        bool outline =
            std::equal(x.outline.begin(), x.outline.end(), y.outline.begin(),
                       [](const ImagePoint& p, const ImagePoint& q) { return p.x == q.x && p.y == q.y; });
        return outline && dx.data == dy.data && dx.rows == dy.rows;
    };
    return a.kind == b.kind && a.widthM == b.widthM && a.heightM == b.heightM &&
           std::equal(a.views.begin(), a.views.end(), b.views.begin(), b.views.end(), same);
}

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
