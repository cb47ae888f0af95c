#include "core/recognition/line_reader.h"

#include "core/base/log.h"

#include <tesseract/baseapi.h>

#include <algorithm>
#include <cctype>
#include <dlfcn.h>
#include <sstream>
#include <vector>

namespace farol::recognition {

namespace {

/// Tesseract's own threads cost more than they bring for single lines (measured: a third of the time), and
/// the cores are wanted elsewhere. It offers no switch; OpenMP does, for the calling thread. Part of the
/// network asks for four threads by name, so a wish for one is not enough: no level of threads is allowed.
void oneOpenMpThread() {
    using SetNumber = void (*)(int);
    static const auto kSetLevels =
        reinterpret_cast<SetNumber>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
    if (kSetLevels != nullptr) kSetLevels(0);
}

/// What Tesseract prints on stderr stands in our errors.
bool init(tesseract::TessBaseAPI& api, const std::string& languages) {
    std::vector<std::string> names{"debug_file"};
    std::vector<std::string> values{"/dev/null"};
    return api.Init(nullptr, languages.c_str(), tesseract::OEM_LSTM_ONLY, nullptr, 0, &names, &values,
                    false) == 0;
}

/// Without what is not part of words at the ends: a frame's edge is read as a bar or a bracket, a speck as a
/// comma. A minus in front of a digit stays: floors below the ground have it.
std::string trimmed(const std::string& word) {
    auto solid = [](char c) {
        auto byte = static_cast<unsigned char>(c);
        return byte >= 0x80 || std::isalnum(byte) != 0;
    };
    auto first = std::find_if(word.begin(), word.end(), solid);
    auto last = std::find_if(word.rbegin(), word.rend(), solid).base();
    if (first >= last) return {};
    bool minus =
        first != word.begin() && *(first - 1) == '-' && std::isdigit(static_cast<unsigned char>(*first));
    return std::string(minus ? first - 1 : first, last);
}

/// Marks outside ASCII that are no letters: quotation marks, dashes and the like.
std::string withoutMarks(std::string word) {
    for (const char* mark :
         {"“", "”", "‘", "’", "„", "—", "–", "«", "»", "°", "©", "®", "§", "¡", "¿", "€", "£", "•"})
        for (std::size_t at = word.find(mark); at != std::string::npos; at = word.find(mark))
            word.erase(at, std::string(mark).size());
    return word;
}

} // namespace

int letterCount(const std::string& text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
        auto byte = static_cast<unsigned char>(c);
        return byte >= 0xC0 || (byte < 0x80 && std::isalnum(byte) != 0);
    }));
}

std::vector<std::string> languageNames(const std::string& languages) {
    std::vector<std::string> out;
    std::istringstream in(languages);
    for (std::string one; std::getline(in, one, '+');)
        if (!one.empty()) out.push_back(one);
    return out;
}

struct LineReader::Engine {
    tesseract::TessBaseAPI api;
};

LineReader::LineReader(std::unique_ptr<Engine> engine) : m_engine(std::move(engine)) {}
LineReader::~LineReader() = default;
LineReader::LineReader(LineReader&&) noexcept = default;
LineReader& LineReader::operator=(LineReader&&) noexcept = default;

Result<LineReader> LineReader::create(const std::string& languages) {
    std::string usable, missing, packages;
    for (const std::string& language : languageNames(languages)) {
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
    if (!init(engine->api, usable))
        return Error{ErrorCode::Unavailable, "Tesseract could not be started with the languages " + usable,
                     "languages"};
    return LineReader(std::move(engine));
}

LineReading LineReader::read(const cv::Mat& line) {
    LineReading reading;
    if (line.empty()) return reading;
    oneOpenMpThread();
    tesseract::TessBaseAPI& api = m_engine->api;
    api.SetPageSegMode(tesseract::PSM_SINGLE_LINE);
    api.SetImage(line.data, line.cols, line.rows, 1, static_cast<int>(line.step));
    api.SetSourceResolution(300);
    if (api.Recognize(nullptr) != 0) return reading;
    std::unique_ptr<tesseract::ResultIterator> words(api.GetIterator());
    if (!words) return reading;
    double weakest = 100.0;
    do {
        std::unique_ptr<char[]> text(words->GetUTF8Text(tesseract::RIL_WORD));
        if (!text || letterCount(text.get()) == 0) continue; // strokes beside the text, read as punctuation
        std::string word = trimmed(withoutMarks(text.get()));
        if (word.empty()) continue;
        weakest = std::min(weakest, static_cast<double>(words->Confidence(tesseract::RIL_WORD)));
        reading.text += (reading.text.empty() ? "" : " ") + word;
    } while (words->Next(tesseract::RIL_WORD));
    reading.confidence = reading.text.empty() ? 0.0 : weakest;
    return reading;
}

} // namespace farol::recognition
