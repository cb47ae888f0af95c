#pragma once
// Trained objects, which are planes or nearly so. Only this folder includes it.

#include "core/recognition/byte_index.h"
#include "core/recognition/detection.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/view_poses.h"

#include <optional>
#include <vector>

namespace farol::recognition {

class ObjectMatcher {
public:
    /// Takes every template of the library that is no place.
    ObjectMatcher(const LandmarkLibrary& library, const RecogniserOptions& options);
    bool empty() const { return m_rows.empty(); }
    DetectorResult match(const cv::Mat& grey, const Features& frame) const;

private:
    /// One picture of an object: a photograph, or a pose made from it.
    struct Look {
        cv::Matx33d planeToPicture;
        cv::Point2f centre;  ///< of the object there
        float extent = 1.0F; ///< square root of its area there
    };
    /// What is known of one descriptor of the index.
    struct Row {
        int object = 0;
        int look = 0;
        cv::Point2f onPlane;
        cv::Point2f toCentre;            ///< from the keypoint to the object's centre, in its look
        float size = 0.0F, angle = 0.0F; ///< of the keypoint there
    };
    struct Object {
        const Template* entry = nullptr;
        cv::Point2f planeSize;
        cv::Mat patch; ///< 64 x 64 grey
        int firstRow = 0, rowCount = 0;
    };
    struct Pair {
        int query = 0;
        int row = 0;
        float ratio = 0.0F;
    };
    /// Where one match alone would put the object.
    struct Vote {
        cv::Point2f centre;
        float logExtent = 0.0F, angle = 0.0F;
    };
    struct Candidate {
        int object = 0;
        int look = 0;            ///< of its seed
        Vote where;              ///< mean of the matches that agree
        float logScale = 0.0F;   ///< of the look's picture to the frame
        std::vector<Pair> pairs; ///< that agree roughly
        double weight = 0.0;
    };
    struct Fit {
        cv::Matx33d planeToFrame;
        int inliers = 0;
        double correlation = -1.0;
    };
    class FrameGrid;

    void addObject(const Template& entry, std::vector<cv::Mat>& descriptors);
    void addView(const View& view, int object, const Plane& plane);
    std::vector<std::vector<Pair>> pairsByObject(const Features& frame) const;
    Vote voteOf(const Pair& pair, const Features& frame) const;
    std::optional<Candidate> largestCluster(int object, const std::vector<Pair>& pairs,
                                            const Features& frame) const;
    std::vector<Candidate> candidates(const Features& frame) const;
    cv::Matx33d placed(const Candidate& candidate) const;
    std::vector<Pair> guided(const Candidate& candidate, const cv::Matx33d& planeToFrame, double reach,
                             const Features& frame, const FrameGrid& grid) const;
    std::optional<Fit> fitted(const Candidate& candidate, const cv::Mat& grey, const Features& frame,
                              const FrameGrid& grid) const;
    Fit judged(const Object& object, const cv::Matx33d& planeToFrame, const std::vector<Pair>& pairs,
               const cv::Mat& grey, const Features& frame, double reach) const;
    bool verify(const Candidate& candidate, const cv::Mat& grey, const Features& frame, const FrameGrid& grid,
                DetectorResult& result) const;

    RecogniserOptions m_options;
    std::vector<Object> m_objects;
    std::vector<Look> m_looks;
    std::vector<Row> m_rows;
    ByteIndex m_index;
};

} // namespace farol::recognition
