#pragma once
// Text on upright quads and in open lines (paper section 3f) by Tesseract. No reading is better than a wrong
// one: a line is read twice, and only what both readings agree on is told.

#include "core/base/error.h"
#include "core/recognition/detection.h"
#include "core/recognition/lexicon.h"

#include <opencv2/core.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace farol::recognition {

struct TextReaderOptions {
    std::string languages = "por+eng"; ///< tessdata names; those not installed are left out with a warning
    double minConfidence = 80.0;       ///< Tesseract's, 0 to 100, of the weakest word kept
    double minWordConfidence = 60.0;   ///< the same where the lexicon holds what was read
    double minSharpness = 2.0;         ///< of a whole frame; see sharpness.h
    double minEdge = 3.5;              ///< of a line's letters: their height over the width of their edges
    double minSteepness = 0.25;        ///< of the letters' edges: 1 rises within one pixel
    int minLetters = 2;                ///< of what the lexicon does not hold
    int letterHeightPx = 48;           ///< letters are read at this height
    int maxLines = 8;                  ///< read in one frame
    /// What the map calls its places. Single letters and digits are told only when they stand here.
    std::vector<std::string> words;

    Result<void> check() const;
};

/// Where to look, and what need not be read.
struct TextPlaces {
    std::optional<std::vector<Quad>> plates; ///< empty: the reader finds rectangles itself
    std::vector<Quad> known;                 ///< lines here are left out
    std::optional<int> maxLines;             ///< instead of the option
};

/// One per thread (Tesseract keeps state).
class TextReader {
public:
    /// Unavailable when no wanted language is installed (the message names the packages).
    static Result<TextReader> create(const TextReaderOptions& options = {});
    ~TextReader();
    TextReader(TextReader&&) noexcept;
    TextReader& operator=(TextReader&&) noexcept;

    /// Reads plates found by detectRectangles (or finds them itself when `plates` is empty), and lines of
    /// letters anywhere. Detections of kind Text, from top to bottom.
    DetectorResult read(const cv::Mat& image, const std::vector<Quad>& plates = {}) const;
    DetectorResult readAt(const cv::Mat& image, const TextPlaces& places) const;

private:
    struct Engine;
    explicit TextReader(std::unique_ptr<Engine> engine);
    std::unique_ptr<Engine> m_engine;
};

} // namespace farol::recognition
