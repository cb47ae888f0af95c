#pragma once
// Trained objects, which are planes or nearly so. Only this folder and the fit of its weights (tests/bench)
// include it.

#include "core/recognition/byte_index.h"
#include "core/recognition/detection.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/object_evidence.h"
#include "core/recognition/view_poses.h"

#include <optional>
#include <string>
#include <vector>

namespace farol::recognition {

/// A template fitted somewhere, whether accepted or not.
struct ObjectTrial {
    TemplateId id;
    Quad quad{};
    FitEvidence evidence;
};

class ObjectMatcher {
public:
    /// Takes every template of the library that is no place.
    ObjectMatcher(const LandmarkLibrary& library, const RecogniserOptions& options);
    /// Takes over what is the same in both libraries; the rest is taken out and put in.
    ObjectMatcher(const ObjectMatcher& before, const LandmarkLibrary& library);
    bool empty() const { return m_index.living() == 0; }
    /// So much is gone that making a new one is better.
    bool outworn() const { return 2 * m_index.living() < m_index.size(); }
    /// `trials`: told of every fit that is a sane outline, when wanted.
    DetectorResult match(const cv::Mat& grey, const Features& seen,
                         std::vector<ObjectTrial>* trials = nullptr) const;

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
        const Template* entry = nullptr; ///< null: no longer in the library
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
        std::vector<Pair> inliers;
    };
    struct Judged {
        Quad quad{};
        FitEvidence evidence;
        const char* reason = nullptr; ///< why not; null when it stands
        double value = 0.0;           ///< that fell short
        double odds = -1e9;           ///< logarithm
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
    /// As an affinity, which few matches determine well, and as a homography where there are more.
    std::vector<Fit> fitted(const Candidate& candidate, const cv::Mat& grey, const Features& frame,
                            const FrameGrid& grid) const;
    Fit fitAt(const cv::Matx33d& planeToFrame, const std::vector<Pair>& pairs, const Features& frame,
              double reach) const;
    FitEvidence geometryOf(const Candidate& candidate, const Fit& fit, const cv::Mat& grey,
                           const Features& frame) const;
    Judged judged(const Candidate& candidate, const Fit& fit, const cv::Mat& grey,
                  const Features& frame) const;
    bool worthFitting(const Candidate& candidate) const;
    bool verify(const Candidate& candidate, const cv::Mat& grey, const Features& frame, const FrameGrid& grid,
                DetectorResult& result, std::vector<ObjectTrial>* trials) const;

    RecogniserOptions m_options;
    std::string m_extractor;
    int m_likeEnough;
    std::vector<Object> m_objects;
    std::vector<Look> m_looks;
    std::vector<Row> m_rows;
    ByteIndex m_index;
};

} // namespace farol::recognition
