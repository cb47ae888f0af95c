#include "core/simulation/lettering.h"

#include <opencv2/freetype.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <fontconfig/fontconfig.h>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <vector>

namespace farol::simulation {

namespace {

const char* familyOf(Face face) {
    switch (face) {
    case Face::Bold:
        return "DejaVu Sans:bold";
    case Face::Condensed:
        return "DejaVu Sans Condensed:bold";
    case Face::Serif:
        return "DejaVu Serif:bold";
    case Face::Sans:
        break;
    }
    return "DejaVu Sans";
}

/// Null where no font can be had; then OpenCV's own strokes do. Guarded by the caller.
cv::Ptr<cv::freetype::FreeType2> typeOf(Face face) {
    static std::map<Face, cv::Ptr<cv::freetype::FreeType2>> known;
    auto found = known.find(face);
    if (found != known.end()) return found->second;
    cv::Ptr<cv::freetype::FreeType2> type;
    std::string file = fontFile(familyOf(face));
    try {
        if (!file.empty()) {
            type = cv::freetype::createFreeType2();
            type->loadFontData(file, 0);
        }
    } catch (const cv::Exception&) {
        type.release();
    }
    known[face] = type;
    return type;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

} // namespace

std::string fontFile(const char* name) {
    std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> wanted(
        FcNameParse(reinterpret_cast<const FcChar8*>(name)), &FcPatternDestroy);
    if (!wanted) return {};
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> found(FcFontMatch(nullptr, wanted.get(), &result),
                                                                  &FcPatternDestroy);
    FcChar8* file = nullptr;
    if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(file);
}

cv::Mat inkOf(const std::string& text, Face face, int pixels) {
    static std::mutex guard; // one font machine for all
    std::lock_guard<std::mutex> lock(guard);
    std::string shown = text.substr(0, 80);
    int width = static_cast<int>(shown.size() + 2) * pixels + 40;
    cv::Mat sheet = cv::Mat::zeros(pixels * 3, width, CV_8UC3);
    try {
        if (auto type = typeOf(face))
            type->putText(sheet, shown, {pixels, pixels * 2}, pixels, cv::Scalar::all(255), -1, cv::LINE_AA,
                          true);
        else
            cv::putText(sheet, shown, {pixels, pixels * 2}, cv::FONT_HERSHEY_DUPLEX, pixels / 22.0,
                        cv::Scalar::all(255), std::max(1, pixels / 12), cv::LINE_AA);
    } catch (const cv::Exception&) {
        return {}; // a text that no font can draw
    }
    cv::Mat ink;
    cv::extractChannel(sheet, ink, 0);
    cv::Rect box = cv::boundingRect(ink);
    return box.area() > 0 ? ink(box).clone() : cv::Mat();
}

void write(cv::Mat& picture, const std::string& text, Face face, const cv::Rect& box,
           const cv::Scalar& colour) {
    std::vector<std::string> lines = linesOf(text);
    if (lines.empty() || box.width < 4 || box.height < 4) return;
    int step = box.height / static_cast<int>(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        cv::Mat ink = inkOf(lines[i], face, std::max(12, step));
        if (ink.empty()) continue;
        double tall = lines.size() > 1 ? step * 0.72 : step;
        double scale = std::min(tall / ink.rows, static_cast<double>(box.width) / ink.cols);
        cv::resize(ink, ink, cv::Size(), scale, scale, cv::INTER_AREA);
        cv::Point at(box.x + (box.width - ink.cols) / 2,
                     box.y + static_cast<int>(i) * step + (step - ink.rows) / 2);
        cv::Rect target = cv::Rect(at, ink.size()) & cv::Rect(0, 0, picture.cols, picture.rows);
        for (int y = 0; y < target.height; ++y) {
            for (int x = 0; x < target.width; ++x) {
                double share = ink.at<std::uint8_t>(target.y - at.y + y, target.x - at.x + x) / 255.0;
                auto& pixel = picture.at<cv::Vec3b>(target.y + y, target.x + x);
                for (int c = 0; c < 3; ++c)
                    pixel[c] = cv::saturate_cast<std::uint8_t>(pixel[c] + (colour[c] - pixel[c]) * share);
            }
        }
    }
}

cv::Mat floorDisplay(const std::string& ref) {
    cv::Mat picture(88, 208, CV_8UC3, cv::Scalar(14, 12, 12));
    write(picture, ref.empty() ? "-" : ref, Face::Bold, {80, 14, 110, 60}, cv::Scalar(40, 60, 255));
    std::vector<cv::Point> arrow{{20, 56}, {42, 22}, {64, 56}};
    cv::fillConvexPoly(picture, arrow, cv::Scalar(40, 60, 255), cv::LINE_AA);
    return picture;
}

} // namespace farol::simulation
