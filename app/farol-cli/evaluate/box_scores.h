#pragma once
// What evaluations of boxes share: labels, hits, and the cells of their tables.

#include "app/farol-cli/evaluate/evaluation.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

namespace farol::cli {

/// YOLO form: class, centre and size as shares of the picture. Those of class 0; none where the file is
/// absent.
std::vector<ImageBox> yoloBoxes(const std::filesystem::path& labels, cv::Size size);

struct BoxScores {
    int boxes = 0, found = 0, wrong = 0;

    /// Each box is found once at most, by a detection that shares half with it (IoU). True if none was missed
    /// and nothing was wrong.
    bool book(const std::vector<recognition::Detection>& detections, const std::vector<ImageBox>& truth);
};

/// Three digits; null of nothing.
EvaluationJson shareCell(int part, int whole);
/// The median to a tenth; null of nothing.
EvaluationJson medianCell(std::vector<double> values);

} // namespace farol::cli
