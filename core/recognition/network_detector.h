#pragma once
// A detector of the user's own: a network in an ONNX file, and beside it a small JSON file that describes it.
//
//   {
//     "model": "signs.onnx",                       beside the description, or an absolute path
//     "input": {
//       "width": 640, "height": 640,
//       "scale": 0.00392157,                       values are (pixel - mean) * scale; 1/255 where it is
//       missing "mean": [0, 0, 0],                         in the order of the channels; 0 where it is
//       missing "channels": "rgb",                         or "bgr"; rgb where it is missing "fit":
//       "letterbox"                         or "stretch"; letterbox where it is missing
//     },
//     "layout": "yolo",                            or "ssd"
//     "classes": [{"name": "exit sign", "kind": "exit_sign"}, {"name": "person", "kind": null}],
//     "score": 0.5, "nms": 0.45
//   }
//
// yolo: rows of centre, size (pixels of the input), where there is one the chance that anything is there, and
// a score for each class; rows may be columns. ssd: rows of picture, class, score and two corners as shares.
// A class whose kind is null is not told.

#include "core/base/error.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace farol::recognition {

struct DetectorDescription {
    enum class Layout { Yolo, Ssd };
    struct Class {
        std::string name;
        std::optional<Kind> kind; ///< empty: not told
    };

    std::filesystem::path model;
    int width = 0, height = 0; ///< of the network's input
    double scale = 1.0 / 255.0;
    cv::Scalar mean;
    bool redFirst = true, letterbox = true;
    Layout layout = Layout::Yolo;
    std::vector<Class> classes;
    double minScore = 0.5, maxOverlap = 0.45;

    /// `where`: the file's name, for errors; a model that is no absolute path lies beside it.
    static Result<DetectorDescription> parse(std::string_view json, const std::filesystem::path& where);
};

/// Not for two threads at once: each loads its own.
class NetworkDetector {
public:
    /// Reads the description and the network and tries it once, so that one of another shape than described
    /// is refused here and not on a walk.
    static Result<NetworkDetector> load(const std::filesystem::path& description);
    ~NetworkDetector();
    NetworkDetector(NetworkDetector&&) noexcept;
    NetworkDetector& operator=(NetworkDetector&&) noexcept;

    /// `bgr` 8-bit, colour; in any other picture nothing is found. Best first. Kind::Sign and Kind::Other
    /// carry the class's name as text.
    DetectorResult detect(const cv::Mat& bgr);
    const DetectorDescription& description() const { return m_description; }

private:
    struct Network;
    NetworkDetector(DetectorDescription description, std::unique_ptr<Network> network);
    DetectorDescription m_description;
    std::unique_ptr<Network> m_network;
};

} // namespace farol::recognition
