#include "tests/training/training_pictures.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>

namespace farol::training {

namespace {

namespace fs = std::filesystem;

Result<std::vector<std::vector<std::string>>> rowsOf(const fs::path& file) {
    std::ifstream in(file);
    if (!in) return Error{ErrorCode::NotFound, "cannot be read", file.string()};
    std::vector<std::vector<std::string>> rows;
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::vector<std::string> row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        rows.push_back(row);
    }
    return rows;
}

/// YOLO form: class, centre and size as shares of the picture; class 0 is a door.
std::vector<ImageBox> doorBoxes(const fs::path& labels, double width, double height) {
    std::vector<ImageBox> boxes;
    std::ifstream in(labels);
    int kind = 0;
    double x = 0.0, y = 0.0, w = 0.0, h = 0.0;
    while (in >> kind >> x >> y >> w >> h)
        if (kind == 0)
            boxes.push_back({(x - w / 2.0) * width, (y - h / 2.0) * height, w * width, h * height});
    return boxes;
}

} // namespace

bool inDevelopmentHalf(const std::string& fileName) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (char c : fileName) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211ULL;
    }
    return (hash >> 32U) % 2 == 0;
}

Result<std::vector<TrainingPicture>> doorPictures(const fs::path& data, const fs::path& here) {
    std::vector<TrainingPicture> pictures;
    fs::path doors = data / "images" / "doors", walk = data / "images" / "corridor_walk",
             stairs = data / "images" / "stairs";
    auto rows = rowsOf(doors / "index.csv");
    if (!rows) return rows.error();
    for (const auto& row : *rows) {
        if (!inDevelopmentHalf(row.at(0))) continue;
        fs::path labels = doors / "labels" / fs::path(row.at(0)).replace_extension(".txt");
        pictures.push_back({row.at(1), doors / "images" / row.at(0),
                            doorBoxes(labels, std::stod(row.at(3)), std::stod(row.at(4))),
                            row.at(1) == "indoor_home" ? 0.5 : 1.0});
    }
    auto labels = rowsOf(here / "corridor_doors.csv");
    if (!labels) return labels.error();
    std::map<std::string, std::vector<ImageBox>> boxes;
    for (const auto& row : *labels)
        boxes[row.at(0)].push_back(
            {std::stod(row.at(1)), std::stod(row.at(2)), std::stod(row.at(3)), std::stod(row.at(4))});
    for (int frame = 1; frame <= 40; ++frame) {
        std::string name = std::to_string(frame) + ".jpg";
        pictures.push_back({"corridor", walk / name, boxes[name], 1.0});
    }
    auto flights = rowsOf(stairs / "stairs.csv");
    if (!flights) return flights.error();
    for (const auto& row : *flights)
        if (inDevelopmentHalf(row.at(0))) pictures.push_back({"stairs", stairs / "img" / row.at(0), {}, 1.0});
    return pictures;
}

cv::Mat varied(const cv::Mat& picture, int variant, std::vector<ImageBox>& boxes, cv::RNG& random) {
    if (variant == 0) return picture;
    double angle = random.uniform(-5.0, 5.0), scale = random.uniform(0.8, 1.15);
    double width = picture.cols, height = picture.rows;
    cv::Mat motion = cv::getRotationMatrix2D(
        cv::Point2f(static_cast<float>(width / 2.0), static_cast<float>(height / 2.0)), angle, scale);
    motion.at<double>(0, 2) += random.uniform(-0.08, 0.08) * width;
    motion.at<double>(1, 2) += random.uniform(-0.08, 0.08) * height;
    cv::Mat out, light(1, 256, CV_8U);
    cv::warpAffine(picture, out, motion, picture.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    double gamma = std::exp(random.uniform(-0.5, 0.5));
    for (int i = 0; i < 256; ++i)
        light.at<uchar>(i) = cv::saturate_cast<uchar>(255.0 * std::pow(i / 255.0, gamma));
    cv::LUT(out, light, out);
    if (variant % 3 == 0) cv::GaussianBlur(out, out, cv::Size(), random.uniform(0.5, 2.0) * height / 1000.0);
    for (ImageBox& box : boxes) { // its centre moves, its size scales: the turn is small
        double x = box.x + box.width / 2.0, y = box.y + box.height / 2.0, w = scale * box.width,
               h = scale * box.height;
        double turn = std::abs(std::sin(angle * kPi / 180.0)) / 2.0;
        double cx = motion.at<double>(0, 0) * x + motion.at<double>(0, 1) * y + motion.at<double>(0, 2);
        double cy = motion.at<double>(1, 0) * x + motion.at<double>(1, 1) * y + motion.at<double>(1, 2);
        double wide = w + turn * h, tall = h + turn * w;
        double x0 = std::max(0.0, cx - wide / 2.0), y0 = std::max(0.0, cy - tall / 2.0);
        box = {x0, y0, std::min(width, cx + wide / 2.0) - x0, std::min(height, cy + tall / 2.0) - y0};
    }
    return out;
}

} // namespace farol::training
