#include "core/recognition/text_reader.h"

#include "core/base/log.h"
#include "core/recognition/grey.h"
#include "core/recognition/rectangle_detector.h"
#include "core/recognition/sharpness.h"
#include "core/recognition/text_lines.h"

#include <opencv2/imgproc.hpp>
#include <tesseract/baseapi.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <dlfcn.h>
#include <sstream>

namespace farol::recognition {

namespace {

/// Tesseract's own threads cost more than they bring for single lines (measured: a third of the time), and
/// the cores are wanted elsewhere. It offers no switch; OpenMP does, for the calling thread.
void oneOpenMpThread() {
    using SetThreads = void (*)(int);
    static const auto kSetThreads = reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "omp_set_num_threads"));
    if (kSetThreads != nullptr) kSetThreads(1);
}

/// What Tesseract prints on stderr stands in our errors.
bool init(tesseract::TessBaseAPI& api, const std::string& languages) {
    std::vector<std::string> names{"debug_file"};
    std::vector<std::string> values{"/dev/null"};
    return api.Init(nullptr, languages.c_str(), tesseract::OEM_LSTM_ONLY, nullptr, 0, &names, &values,
                    false) == 0;
}

std::vector<std::string> split(const std::string& languages) {
    std::vector<std::string> out;
    std::istringstream in(languages);
    for (std::string one; std::getline(in, one, '+');)
        if (!one.empty()) out.push_back(one);
    return out;
}

/// Letters and digits in UTF-8: each lead byte above ASCII counts as a letter.
int letterCount(const std::string& text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
        auto byte = static_cast<unsigned char>(c);
        return byte >= 0xC0 || (byte < 0x80 && std::isalnum(byte) != 0);
    }));
}

/// Without what is not part of words at the ends: a frame's edge is read as a bar or a bracket.
std::string trimmed(const std::string& word) {
    static const std::string kStray = "|[]{}\\_~^`'\"*=<>";
    std::size_t first = word.find_first_not_of(kStray);
    std::size_t last = word.find_last_not_of(kStray);
    return first == std::string::npos ? std::string() : word.substr(first, last - first + 1);
}

struct Reading {
    std::string text;
    double confidence = 0.0; ///< of the weakest word kept
};

struct Line {
    Quad quad{};
    cv::Mat picture; ///< dark on light
};

constexpr double kFrameShare = 0.07; // of a plate's height, cut off on every side with the frame's line

ImagePoint between(const Quad& quad, double u, double v) {
    auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
    return {mix(mix(quad[0].x, quad[1].x, u), mix(quad[3].x, quad[2].x, u), v),
            mix(mix(quad[0].y, quad[1].y, u), mix(quad[3].y, quad[2].y, u), v)};
}

Quad part(const Quad& quad, double left, double top, double right, double bottom) {
    return {between(quad, left, top), between(quad, right, top), between(quad, right, bottom),
            between(quad, left, bottom)};
}

double heightOf(const Quad& quad) {
    return (std::hypot(quad[0].x - quad[3].x, quad[0].y - quad[3].y) +
            std::hypot(quad[1].x - quad[2].x, quad[1].y - quad[2].y)) /
           2.0;
}

double widthOf(const Quad& quad) {
    return (std::hypot(quad[0].x - quad[1].x, quad[0].y - quad[1].y) +
            std::hypot(quad[3].x - quad[2].x, quad[3].y - quad[2].y)) /
           2.0;
}

} // namespace

Result<void> TextReaderOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (split(languages).empty()) return wrong("name at least one language, such as por+eng", "languages");
    if (!(minConfidence >= 0.0 && minConfidence <= 100.0))
        return wrong("a confidence lies between 0 and 100", "minConfidence");
    if (!(minSharpness >= 0.0)) return wrong("must not be negative", "minSharpness");
    if (minLetters < 1) return wrong("at least one letter is wanted", "minLetters");
    if (lineHeightPx < 16 || lineHeightPx > 512) return wrong("between 16 and 512 pixels", "lineHeightPx");
    if (maxPlates < 1 || maxPlates > 1000) return wrong("between 1 and 1000", "maxPlates");
    return {};
}

struct TextReader::Engine {
    TextReaderOptions options;
    tesseract::TessBaseAPI api;

    std::optional<Reading> readLine(const cv::Mat& line, double& confidence);
    std::vector<Line> linesOfPlate(const cv::Mat& grey, const Quad& plate) const;
    void readInto(const Line& line, ImageSize size, DetectorResult& result);
};

/// The words of one line; empty when there is none that can be trusted. `confidence` then tells how far it
/// fell short.
std::optional<Reading> TextReader::Engine::readLine(const cv::Mat& line, double& confidence) {
    cv::Mat framed;
    int margin = options.lineHeightPx / 5;
    cv::copyMakeBorder(line, framed, margin, margin, margin, margin, cv::BORDER_CONSTANT, cv::Scalar(255));
    api.SetPageSegMode(tesseract::PSM_SINGLE_LINE);
    api.SetImage(framed.data, framed.cols, framed.rows, 1, static_cast<int>(framed.step));
    api.SetSourceResolution(300);
    confidence = 0.0;
    if (api.Recognize(nullptr) != 0) return std::nullopt;
    std::unique_ptr<tesseract::ResultIterator> words(api.GetIterator());
    Reading reading;
    reading.confidence = 100.0;
    bool weak = false;
    if (!words) return std::nullopt;
    do {
        std::unique_ptr<char[]> text(words->GetUTF8Text(tesseract::RIL_WORD));
        if (!text || letterCount(text.get()) == 0) continue; // strokes beside the text, read as punctuation
        double sure = words->Confidence(tesseract::RIL_WORD);
        reading.confidence = std::min(reading.confidence, sure);
        weak = weak || sure < options.minConfidence;
        reading.text += (reading.text.empty() ? "" : " ") + trimmed(text.get());
    } while (words->Next(tesseract::RIL_WORD));
    confidence = reading.text.empty() ? 0.0 : reading.confidence;
    // A line of which one word is doubtful may mean something else altogether.
    if (weak || letterCount(reading.text) < options.minLetters) return std::nullopt;
    return reading;
}

std::vector<Line> TextReader::Engine::linesOfPlate(const cv::Mat& grey, const Quad& plate) const {
    double height = heightOf(plate);
    double width = widthOf(plate);
    std::vector<Line> lines;
    if (height < 8.0 || width < 8.0) return lines;
    double cutX = std::min(0.2, kFrameShare * height / width);
    Quad inner = part(plate, cutX, kFrameShare, 1.0 - cutX, 1.0 - kFrameShare);
    int rows = std::clamp(static_cast<int>(height * 2.0), options.lineHeightPx, 4 * options.lineHeightPx);
    cv::Mat flat = darkOnLight(rectified(grey, inner, rows));
    for (const cv::Range& ink : inkRows(flat)) {
        double pad = 0.25 * ink.size();
        double top = std::max(0.0, (ink.start - pad) / flat.rows);
        double bottom = std::min(1.0, (ink.end + pad) / flat.rows);
        Line line;
        line.quad = part(inner, 0.0, top, 1.0, bottom);
        double asTall = (bottom - top) * flat.rows / ink.size();
        line.picture = darkOnLight(
            rectified(grey, line.quad, static_cast<int>(options.lineHeightPx * std::min(asTall, 1.5))));
        lines.push_back(std::move(line));
    }
    return lines;
}

void TextReader::Engine::readInto(const Line& line, ImageSize size, DetectorResult& result) {
    Rejection rejection{"text", Kind::Text, {}, line.quad, "", 0.0};
    double sharp = sharpness(line.picture);
    if (sharp < options.minSharpness) {
        rejection.reason = "blurred";
        rejection.value = sharp;
        result.rejections.push_back(rejection);
        return;
    }
    double confidence = 0.0;
    auto reading = readLine(line.picture, confidence);
    if (!reading) {
        rejection.reason = "low_confidence";
        rejection.value = confidence;
        result.rejections.push_back(rejection);
        return;
    }
    // A digit that changes with the size it is read at is a guess, however sure Tesseract is of it.
    cv::Mat smaller;
    cv::resize(line.picture, smaller, cv::Size(), 0.7, 0.7, cv::INTER_AREA);
    double again = 0.0;
    auto second = readLine(smaller, again);
    if (!second || second->text != reading->text) {
        rejection.reason = "unstable_reading";
        rejection.value = again;
        result.rejections.push_back(rejection);
        return;
    }
    Detection detection;
    detection.kind = Kind::Text;
    detection.text = reading->text;
    detection.quad = line.quad;
    detection.image = size;
    detection.score = std::clamp(reading->confidence / 100.0, 0.0, 1.0);
    result.detections.push_back(std::move(detection));
}

TextReader::TextReader(std::unique_ptr<Engine> engine) : m_engine(std::move(engine)) {}
TextReader::~TextReader() = default;
TextReader::TextReader(TextReader&&) noexcept = default;
TextReader& TextReader::operator=(TextReader&&) noexcept = default;

Result<TextReader> TextReader::create(const TextReaderOptions& options) {
    if (auto checked = options.check(); !checked) return checked.error();
    std::string usable, missing, packages;
    for (const std::string& language : split(options.languages)) {
        tesseract::TessBaseAPI probe;
        bool there = init(probe, language);
        probe.End();
        std::string& list = there ? usable : missing;
        list += (list.empty() ? "" : "+") + language;
        if (!there) packages += " tesseract-ocr-" + language;
    }
    if (usable.empty())
        return Error{ErrorCode::Unavailable,
                     "text cannot be read: Tesseract has none of the languages " + missing + "; install" +
                         packages,
                     "languages"};
    if (!missing.empty())
        logWarning("Tesseract does not have " + missing + "; text is read as " + usable + " (install" +
                   packages + ")");
    auto engine = std::make_unique<Engine>();
    engine->options = options;
    if (!init(engine->api, usable))
        return Error{ErrorCode::Unavailable, "Tesseract could not be started with the languages " + usable,
                     "languages"};
    return TextReader(std::move(engine));
}

DetectorResult TextReader::read(const cv::Mat& image, const std::vector<Quad>& plates) const {
    DetectorResult result;
    cv::Mat grey = greyOf(image);
    if (grey.empty() || std::min(grey.cols, grey.rows) < 8) return result;
    oneOpenMpThread();
    std::vector<Quad> wanted = plates;
    if (plates.empty())
        for (const Detection& rectangle : detectRectangles(grey).detections) wanted.push_back(rectangle.quad);
    auto limit = static_cast<std::size_t>(m_engine->options.maxPlates);
    std::vector<Line> lines;
    for (const Quad& line : plates.empty() ? lettersInLines(grey, std::max(3, m_engine->options.minLetters))
                                           : std::vector<Quad>{})
        if (lines.size() < limit)
            lines.push_back(
                {line, darkOnLight(rectified(grey, line, m_engine->options.lineHeightPx * 7 / 5))});
    for (std::size_t i = 0; i < std::min(wanted.size(), limit); ++i)
        for (Line& line : m_engine->linesOfPlate(grey, wanted[i])) lines.push_back(std::move(line));
    for (const Line& line : lines) {
        bool known = std::any_of(result.detections.begin(), result.detections.end(), [&](const Detection& d) {
            return overlap(boundingBox(d.quad), boundingBox(line.quad)) > 0.3;
        });
        if (!known) m_engine->readInto(line, {grey.cols, grey.rows}, result);
    }
    return result;
}

} // namespace farol::recognition
