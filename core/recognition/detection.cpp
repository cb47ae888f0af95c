#include "core/recognition/detection.h"

#include <iterator>

namespace farol::recognition {

void DetectorResult::append(DetectorResult other) {
    detections.insert(detections.end(), std::make_move_iterator(other.detections.begin()),
                      std::make_move_iterator(other.detections.end()));
    rejections.insert(rejections.end(), std::make_move_iterator(other.rejections.begin()),
                      std::make_move_iterator(other.rejections.end()));
}

} // namespace farol::recognition
