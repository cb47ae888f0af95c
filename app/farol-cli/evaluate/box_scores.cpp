#include "app/farol-cli/evaluate/box_scores.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace farol::cli {

std::vector<ImageBox> yoloBoxes(const std::filesystem::path& labels, cv::Size size) {
    std::vector<ImageBox> boxes;
    std::ifstream in(labels);
    int kind = 0;
    double x = 0.0, y = 0.0, w = 0.0, h = 0.0;
    while (in >> kind >> x >> y >> w >> h)
        if (kind == 0)
            boxes.push_back(
                {(x - w / 2.0) * size.width, (y - h / 2.0) * size.height, w * size.width, h * size.height});
    return boxes;
}

bool BoxScores::book(const std::vector<recognition::Detection>& detections,
                     const std::vector<ImageBox>& truth) {
    std::vector<bool> met(truth.size(), false);
    bool clean = true;
    for (const recognition::Detection& d : detections) {
        bool hit = false;
        for (std::size_t i = 0; i < truth.size() && !hit; ++i) {
            if (met[i] || overlap(boundingBox(d.quad), truth[i]) < 0.5) continue;
            met[i] = hit = true;
        }
        (hit ? found : wrong) += 1;
        clean = clean && hit;
    }
    boxes += static_cast<int>(truth.size());
    return clean && std::find(met.begin(), met.end(), false) == met.end();
}

EvaluationJson shareCell(int part, int whole) {
    if (whole == 0) return nullptr;
    return std::round(1000.0 * part / whole) / 1000.0;
}

EvaluationJson medianCell(std::vector<double> values) {
    if (values.empty()) return nullptr;
    std::sort(values.begin(), values.end());
    return std::round(10.0 * values[values.size() / 2]) / 10.0;
}

} // namespace farol::cli
