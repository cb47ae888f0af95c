#pragma once
// Trained objects, which are planes or nearly so. Only this folder includes it.

#include "core/recognition/byte_index.h"
#include "core/recognition/detection.h"
#include "core/recognition/landmark_recogniser.h"

#include <memory>
#include <vector>

namespace farol::recognition {

class ObjectMatcher {
public:
    /// Takes every template of the library that is no place.
    ObjectMatcher(const LandmarkLibrary& library, const RecogniserOptions& options);
    bool empty() const { return m_rows.empty(); }
    DetectorResult match(const cv::Mat& grey, const Features& frame) const;

private:
    /// What is known of one descriptor of the index.
    struct Row {
        int object = 0;
        cv::Point2f onPlane;  ///< in the plane's coordinates
        cv::Point2f toCentre; ///< from the keypoint to the object's centre, in the picture it was seen in
        float size = 0.0F, angle = 0.0F; ///< of the keypoint there
        float extent = 0.0F;             ///< of the object there: square root of its area
    };
    struct Object {
        const Template* entry = nullptr;
        cv::Point2f planeSize;
        cv::Mat patch; ///< 64 x 64 grey
    };
    struct Pair {
        int query = 0;
        int row = 0;
        float ratio = 0.0F;
    };
    struct Candidate {
        int object = 0;
        std::vector<Pair> pairs;
    };

    void addObject(const Template& entry, std::vector<cv::Mat>& descriptors);
    std::vector<std::vector<Pair>> pairsByObject(const Features& frame) const;
    Candidate largestCluster(int object, const std::vector<Pair>& pairs, const Features& frame) const;
    void verify(const Candidate& candidate, const cv::Mat& grey, const Features& frame,
                DetectorResult& result) const;
    double patchCorrelation(const Object& object, const cv::Mat& grey, const cv::Matx33d& planeToFrame) const;

    RecogniserOptions m_options;
    std::vector<Object> m_objects;
    std::vector<Row> m_rows;
    std::unique_ptr<ByteIndex> m_index;
};

} // namespace farol::recognition
