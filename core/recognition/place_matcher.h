#pragma once
// Places: whole views of a spot, not planes. Only this folder includes it.

#include "core/recognition/byte_index.h"
#include "core/recognition/detection.h"
#include "core/recognition/landmark_recogniser.h"

#include <span>
#include <vector>

namespace farol::recognition {

/// How well a frame fits one trained view of a place.
struct PlaceSupport {
    int view = 0;        ///< of PlaceMatcher
    int matches = 0;     ///< that pass the ratio test and agree in roll and scale
    int inliers = 0;     ///< of the epipolar geometry
    int cells = 0;       ///< of the frame's 8 x 6 cells that hold an inlier
    double spread = 0.0; ///< share of the frame that the middle three quarters of them span
    double strength() const;
};

class PlaceMatcher {
public:
    PlaceMatcher(const LandmarkLibrary& library, const RecogniserOptions& options);
    /// Takes over what is the same in both libraries; the rest is taken out and put in.
    PlaceMatcher(const PlaceMatcher& before, const LandmarkLibrary& library);
    bool empty() const { return m_index.living() == 0; }
    bool outworn() const { return 2 * m_index.living() < m_index.size(); }
    /// At most one detection.
    DetectorResult match(ImageSize frameSize, const Features& frame) const;

    const Template& placeOf(int view) const { return *m_views[static_cast<std::size_t>(view)].entry; }

private:
    struct PlaceView {
        const Template* entry = nullptr; ///< null: no longer in the library
        const View* view = nullptr;
        cv::Mat descriptors; ///< comparable
        int firstRow = 0;
    };

    void add(const Template& entry, std::vector<cv::Mat>& descriptors);
    std::vector<int> candidates(const Features& frame, std::size_t most) const;
    /// Verified, strongest first.
    std::vector<PlaceSupport> ranked(ImageSize frameSize, const Features& frame,
                                     std::span<const int> views) const;
    void addLookAlikes(Detection& told, const std::vector<PlaceSupport>& fits) const;
    PlaceSupport verified(ImageSize frameSize, const Features& frame, int view) const;
    bool sameSpot(int a, int b) const;

    RecogniserOptions m_options;
    std::string m_extractor;
    std::vector<PlaceView> m_views;
    std::vector<int> m_viewOfRow;
    ByteIndex m_index;
};

} // namespace farol::recognition
