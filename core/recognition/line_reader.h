#pragma once
// Tesseract for single lines. Only this folder includes it.

#include "core/base/error.h"

#include <opencv2/core.hpp>

#include <memory>
#include <string>

namespace farol::recognition {

struct LineReading {
    std::string text;        ///< without stray marks at the ends; empty when nothing was read
    double confidence = 0.0; ///< of the weakest word, 0 to 100
};

/// One per thread (Tesseract keeps state).
class LineReader {
public:
    /// `languages` as "por+eng"; those not installed are left out with a warning.
    static Result<LineReader> create(const std::string& languages);
    ~LineReader();
    LineReader(LineReader&&) noexcept;
    LineReader& operator=(LineReader&&) noexcept;

    /// Dark letters on light ground with a margin.
    LineReading read(const cv::Mat& line);

private:
    struct Engine;
    explicit LineReader(std::unique_ptr<Engine> engine);
    std::unique_ptr<Engine> m_engine;
};

/// Letters and digits in UTF-8: each lead byte above ASCII counts as a letter.
int letterCount(const std::string& text);
/// The names in "por+eng".
std::vector<std::string> languageNames(const std::string& languages);

} // namespace farol::recognition
