#include "core/recognition/text_reader.h"

#include "core/recognition/grey.h"
#include "core/recognition/ink_lines.h"
#include "core/recognition/line_picture.h"
#include "core/recognition/line_reader.h"
#include "core/recognition/plate_around.h"
#include "core/recognition/rectangle_detector.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr double kFrameShare = 0.05; // of a plate's height, cut off on every side with its edge

Quad withoutEdge(const Quad& plate) {
    ImageBox box = boundingBox(plate);
    double share = box.width > 0.0 ? std::min(0.2, kFrameShare * box.height / box.width) : 0.0;
    return drawnIn(plate, share, kFrameShare);
}

double coveredBy(const ImageBox& inner, const ImageBox& outer) {
    double w = std::min(inner.x + inner.width, outer.x + outer.width) - std::max(inner.x, outer.x);
    double h = std::min(inner.y + inner.height, outer.y + outer.height) - std::max(inner.y, outer.y);
    return w > 0.0 && h > 0.0 ? w * h / std::max(1e-9, inner.area()) : 0.0;
}

int digitsIn(const std::string& text) {
    return static_cast<int>(std::count_if(
        text.begin(), text.end(), [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }));
}

constexpr int kLooks = 4;

/// The same line in four ways.
cv::Mat lookAt(const LinePicture& line, int look) {
    if (look == 0) return line.soft;
    if (look == 1) return line.picture;
    cv::Mat other;
    double scale = look == 2 ? 0.7 : 1.35;
    cv::resize(line.soft, other, cv::Size(), scale, scale, look == 2 ? cv::INTER_AREA : cv::INTER_CUBIC);
    return other;
}

/// A single letter or digit is told only from a mark that is nothing else: bars are read as 1, rings as 0.
bool standsOnItsOwn(const LinePicture& line, const std::string& text) {
    // A letter leaves most of its box empty; a box on the wall does not.
    if (!line.alone || line.fill > 0.62) return false;
    if (text.front() == '-') return line.glyphs == 2 && line.aspect < 2.0;
    if (line.glyphs != 1) return false;
    if (text == "1" || text == "I" || text == "l")
        return line.holes == 0 && line.aspect > 0.4 && line.aspect < 0.9;
    bool round = text == "0" || text == "O" || text == "o" || text == "Q" || text == "D";
    // A ring with something in it is a sign that forbids.
    if (round && line.middle > 0.1) return false;
    return line.aspect > 0.4 && line.aspect < (round ? 0.9 : 1.05);
}

/// One place in the picture where a line seems to stand, and the ways to cut it out, the likeliest first.
struct Spot {
    std::vector<LinePicture> lines;
    bool ends = false; ///< the first is known to be all of its line: it stands on a plate
};

/// `ends`: the line stands on a plate and is all that does. Of others the longer one comes first, as the
/// shorter may be a part of it.
void addTo(std::vector<Spot>& spots, LinePicture line, bool ends) {
    constexpr std::size_t kWays = 3;
    ImageBox box = boundingBox(line.quad);
    for (Spot& spot : spots) {
        ImageBox there = boundingBox(spot.lines.front().quad);
        if (coveredBy(box, there) < 0.5 && coveredBy(there, box) < 0.5) continue;
        bool longer = box.width > there.width * 1.1 && box.height < there.height * 1.5;
        bool first = ends == spot.ends ? longer : ends;
        // A part of an open line may be another word.
        if (!first && !ends) return;
        if (first && !ends) spot.lines.clear();
        spot.lines.insert(first ? spot.lines.begin() : spot.lines.end(), std::move(line));
        spot.ends = spot.ends || ends;
        if (spot.lines.size() > kWays) spot.lines.pop_back();
        return;
    }
    spots.push_back({{std::move(line)}, ends});
}

} // namespace

Result<void> TextReaderOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    auto isConfidence = [](double value) { return value >= 0.0 && value <= 100.0; };
    if (languageNames(languages).empty())
        return wrong("name at least one language, such as por+eng", "languages");
    if (!isConfidence(minConfidence)) return wrong("a confidence lies between 0 and 100", "minConfidence");
    if (!isConfidence(minWordConfidence))
        return wrong("a confidence lies between 0 and 100", "minWordConfidence");
    if (!(minSharpness >= 0.0)) return wrong("must not be negative", "minSharpness");
    if (!(minEdge >= 0.0)) return wrong("must not be negative", "minEdge");
    if (!(minSteepness >= 0.0)) return wrong("must not be negative", "minSteepness");
    if (minLetters < 1) return wrong("at least one letter is wanted", "minLetters");
    if (letterHeightPx < 16 || letterHeightPx > 256)
        return wrong("between 16 and 256 pixels", "letterHeightPx");
    if (maxLines < 1 || maxLines > 1000) return wrong("between 1 and 1000", "maxLines");
    return {};
}

struct TextReader::Engine {
    TextReaderOptions options;
    Lexicon lexicon;
    LineReader reader;

    std::vector<Spot> spotsIn(const cv::Mat& grey, const std::vector<Quad>& plates) const;
    std::string whyNotWorthReading(const LinePicture& line, double& value) const;
    std::string judged(const LinePicture& line, const LineReading& reading, std::string& text) const;
    std::string readLine(const LinePicture& line, std::string& text, double& confidence);
    void readInto(const Spot& spot, ImageSize size, DetectorResult& result);
};

/// Lines on plates and lines in the open picture, gathered by where they stand. Ground that ends on all sides
/// tells best where a line ends; of the others the longer one comes first, as the shorter may be a part of
/// it.
std::vector<Spot> TextReader::Engine::spotsIn(const cv::Mat& grey, const std::vector<Quad>& plates) const {
    std::vector<Spot> spots;
    auto most = static_cast<std::size_t>(options.maxLines) * 3;
    std::vector<InkLine> open = inkLines(grey);
    open.resize(std::min(open.size(), most));
    auto addPlate = [&](const Quad& plate) {
        for (LinePicture& line : linesOfPlate(grey, withoutEdge(plate), options.letterHeightPx))
            if (!line.cutLeft && !line.cutRight) addTo(spots, std::move(line), true);
    };
    for (const InkLine& line : open) {
        auto plate = plateAround(grey, line.quad, line.lightInk);
        if (auto whole = wholeLine(grey, line.quad, line.lightInk, options.letterHeightPx, plate))
            addTo(spots, std::move(*whole), plate.has_value());
        if (plate) addPlate(*plate);
    }
    for (std::size_t i = 0; i < std::min(plates.size(), most); ++i) addPlate(plates[i]);
    return spots;
}

/// A stable word, or nothing when the line may be read.
std::string TextReader::Engine::whyNotWorthReading(const LinePicture& line, double& value) const {
    value = line.contrast;
    if (line.contrast < 20.0) return "low_contrast";
    value = line.letterPx;
    if (line.letterPx < 7.0) return "too_small";
    value = line.sharpness * line.letterPx;
    if (value < options.minEdge) return "blurred";
    // Edges several pixels wide are a smear, however large the letters are.
    value = line.sharpness;
    if (value < options.minSteepness) return "blurred";
    value = line.glyphs;
    return line.glyphs < 1 || line.glyphs > 60 ? "no_letters" : "";
}

/// A stable word, or nothing when `text` may be told.
std::string TextReader::Engine::judged(const LinePicture& line, const LineReading& reading,
                                       std::string& text) const {
    int letters = letterCount(reading.text);
    if (letters == 0) return "no_letters";
    if (letters == 1 && !standsOnItsOwn(line, reading.text)) return "lone_stroke";
    // As many letters as there are pieces of ink; letters that touch may make fewer pieces, never more.
    bool number = digitsIn(reading.text) == letters;
    bool point = reading.text.find_first_of(".,-:") != std::string::npos;
    auto marks = std::count_if(reading.text.begin(), reading.text.end(),
                               [](char c) { return std::ispunct(static_cast<unsigned char>(c)) != 0; });
    if (line.glyphs > letters + (number ? static_cast<int>(point) : static_cast<int>(marks)))
        return "lost_letter";
    // "Lab3" for "Lab 3" is another name to whoever compares it.
    if (line.gap && reading.text.find(' ') == std::string::npos) return "lost_space";
    if (auto word = lexicon.meant(reading.text); word && reading.confidence >= options.minWordConfidence) {
        text = *word;
        return letterCount(text) == 1 && !standsOnItsOwn(line, text) ? "lone_stroke" : "";
    }
    text = reading.text;
    if (reading.confidence < options.minConfidence) return "low_confidence";
    bool capitals = std::none_of(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    if (letters < options.minLetters || (letters < 3 && !capitals)) return "too_short";
    // 303 beside a post may be 13.03.
    if (number && line.besideEdge) return "beside_an_edge";
    // A lost point turns 2.14 into another room. Points that stand among digits have to be in the reading.
    return number && line.dots == 1 && !point ? "lost_point" : "";
}

/// Empty when `text` may be told, else a stable word for why not. A digit that changes with how it is looked
/// at is a guess, however sure Tesseract is of it: two of at most four looks have to agree.
std::string TextReader::Engine::readLine(const LinePicture& line, std::string& text, double& confidence) {
    std::string reason;
    std::vector<std::string> told;
    confidence = 0.0;
    for (int look = 0; look < kLooks; ++look) {
        LineReading reading = reader.read(lookAt(line, look));
        std::string one;
        std::string why = judged(line, reading, one);
        confidence = std::max(confidence, reading.confidence);
        if (look == 0) reason = why;
        if (look == kLooks - 2 && told.empty() && !why.empty()) break; // no two can agree any more
        if (!why.empty()) continue;
        if (std::find(told.begin(), told.end(), one) != told.end()) {
            text = one;
            return "";
        }
        told.push_back(one);
    }
    return told.empty() ? reason : "unstable_reading";
}

/// Two ways to cut a line out have to agree where more than one can be read: what the map does not hold has
/// nothing else to be checked against.
void TextReader::Engine::readInto(const Spot& spot, ImageSize size, DetectorResult& result) {
    Rejection rejection{"text", Kind::Text, {}, spot.lines.front().quad, "", 0.0};
    std::vector<Detection> told;
    bool agreed = false;
    for (std::size_t i = 0; i < spot.lines.size() && !agreed; ++i) {
        const LinePicture& line = spot.lines[i];
        double value = 0.0;
        Detection detection;
        std::string reason = whyNotWorthReading(line, value);
        if (reason.empty()) reason = readLine(line, detection.text, value);
        if (i == 0) rejection.reason = reason, rejection.value = value;
        if (!reason.empty()) continue;
        detection.kind = Kind::Text;
        detection.quad = line.quad;
        detection.image = size;
        detection.score = std::clamp(value / 100.0, 0.0, 1.0);
        agreed = lexicon.meant(detection.text).has_value() ||
                 std::any_of(told.begin(), told.end(),
                             [&](const Detection& d) { return d.text == detection.text; });
        told.push_back(std::move(detection));
    }
    if (agreed || told.size() == 1) {
        result.detections.push_back(std::move(told.back()));
    } else {
        if (!told.empty()) rejection.reason = "unstable_reading";
        result.rejections.push_back(rejection);
    }
}

TextReader::TextReader(std::unique_ptr<Engine> engine) : m_engine(std::move(engine)) {}
TextReader::~TextReader() = default;
TextReader::TextReader(TextReader&&) noexcept = default;
TextReader& TextReader::operator=(TextReader&&) noexcept = default;

Result<TextReader> TextReader::create(const TextReaderOptions& options) {
    if (auto checked = options.check(); !checked) return checked.error();
    auto reader = LineReader::create(options.languages);
    if (!reader) return reader.error();
    return TextReader(
        std::make_unique<Engine>(Engine{options, Lexicon(options.words), std::move(reader).value()}));
}

DetectorResult TextReader::read(const cv::Mat& image, const std::vector<Quad>& plates) const {
    TextPlaces places;
    if (!plates.empty()) places.plates = plates;
    return readAt(image, places);
}

DetectorResult TextReader::readAt(const cv::Mat& image, const TextPlaces& places) const {
    DetectorResult result;
    cv::Mat grey = greyOf(image);
    if (grey.empty() || std::min(grey.cols, grey.rows) < 16) return result;
    std::vector<Quad> wanted = places.plates.value_or(std::vector<Quad>{});
    if (!places.plates)
        for (const Detection& rectangle : detectRectangles(grey).detections) wanted.push_back(rectangle.quad);
    auto isKnown = [&](const LinePicture& line) {
        ImageBox box = boundingBox(line.quad);
        return std::any_of(places.known.begin(), places.known.end(),
                           [&](const Quad& known) { return coveredBy(box, boundingBox(known)) > 0.5; });
    };
    int left = places.maxLines.value_or(m_engine->options.maxLines);
    for (const Spot& spot : m_engine->spotsIn(grey, wanted)) {
        const LinePicture& first = spot.lines.front();
        if (isKnown(first)) continue;
        double value = 0.0;
        std::string reason = m_engine->whyNotWorthReading(first, value);
        if (!reason.empty() && spot.lines.size() == 1) {
            result.rejections.push_back({"text", Kind::Text, {}, first.quad, reason, value});
        } else if (left > 0) {
            --left;
            m_engine->readInto(spot, {grey.cols, grey.rows}, result);
        }
    }
    std::stable_sort(result.detections.begin(), result.detections.end(),
                     [](const Detection& a, const Detection& b) {
                         return boundingBox(a.quad).centre().y < boundingBox(b.quad).centre().y;
                     });
    return result;
}

} // namespace farol::recognition
