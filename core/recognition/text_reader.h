#pragma once
// Text on upright quads (paper section 3f) by Tesseract. No reading is better than a wrong one.

#include "core/base/error.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

#include <memory>
#include <string>
#include <vector>

namespace farol::recognition {

struct TextReaderOptions {
    std::string languages = "por+eng"; ///< tessdata names; those not installed are left out with a warning
    double minConfidence = 80.0;       ///< Tesseract's, 0 to 100, of the weakest word kept
    double minSharpness = 7.0;         ///< of one line as it is rectified; see sharpness.h
    int minLetters = 2;
    int lineHeightPx = 64; ///< a plate is rectified to this height a line
    int maxPlates = 8;     ///< a frame

    Result<void> check() const;
};

/// One per thread (Tesseract keeps state).
class TextReader {
public:
    /// Unavailable when no wanted language is installed (the message names the packages).
    static Result<TextReader> create(const TextReaderOptions& options = {});
    ~TextReader();
    TextReader(TextReader&&) noexcept;
    TextReader& operator=(TextReader&&) noexcept;

    /// Reads plates found by detectRectangles (or finds them itself when `plates` is empty). Detections of
    /// kind Text.
    DetectorResult read(const cv::Mat& image, const std::vector<Quad>& plates = {}) const;

private:
    struct Engine;
    explicit TextReader(std::unique_ptr<Engine> engine);
    std::unique_ptr<Engine> m_engine;
};

} // namespace farol::recognition
