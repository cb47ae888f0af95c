// find_object_run SET [--Group/parameter VALUE]...: introlab/find-object on a set of composed planes, through
// the same calls as its console mode. One template a picture (the frontal photograph from 1 m), one thread.
// Prints one row: recall easy, medium, hard; precision; false in frames without a template; such frames;
// median milliseconds of the processor. find_object.sh builds it.

#include <QtCore/QCoreApplication>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <find_object/DetectionInfo.h>
#include <find_object/FindObject.h>
#include <find_object/Settings.h>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using nlohmann::json;
using Outline = std::vector<cv::Point2f>;

double cpuMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

Outline outlineFrom(const json& corners) {
    Outline outline;
    for (const json& p : corners) outline.emplace_back(p.at(0).get<float>(), p.at(1).get<float>());
    return outline;
}

double overlap(const Outline& a, const Outline& b) {
    Outline common;
    double both = cv::intersectConvexConvex(a, b, common);
    return both / (cv::contourArea(a) + cv::contourArea(b) - both);
}

std::map<int, std::string> train(const std::string& set, find_object::FindObject& finder) {
    std::map<int, std::string> names;
    std::ifstream in(set + "/train.jsonl");
    int id = 0;
    for (std::string line; std::getline(in, line);) {
        json one = json::parse(line);
        if (one.at("view").get<int>() != 0) continue;
        cv::Mat picture = cv::imread(set + "/" + one.at("file").get<std::string>(), cv::IMREAD_GRAYSCALE);
        cv::Rect box = cv::boundingRect(outlineFrom(one.at("outline"))) & cv::Rect({}, picture.size());
        finder.addObject(picture(box).clone(), ++id);
        names[id] = one.at("template").get<std::string>();
    }
    finder.updateObjects();
    finder.updateVocabulary();
    return names;
}

struct Tally {
    std::array<int, 3> shown{}, found{};
    int wrong = 0, wrongInNegatives = 0, negatives = 0;
    std::vector<double> milliseconds;
};

void count(const json& line, const find_object::DetectionInfo& info, const std::map<int, std::string>& names,
           Tally& tally) {
    const auto difficulty = line.at("difficulty").get<std::string>();
    const std::size_t at = difficulty == "easy" ? 0 : difficulty == "medium" ? 1 : 2;
    const json& shown = line.at("landmarks");
    tally.shown[at] += static_cast<int>(shown.size());
    tally.negatives += shown.empty() ? 1 : 0;
    std::set<std::string> found;
    auto size = info.objDetectedSizes_.constBegin();
    for (auto hit = info.objDetected_.constBegin(); hit != info.objDetected_.constEnd(); ++hit, ++size) {
        Outline outline;
        const double w = size.value().width(), h = size.value().height();
        for (const QPointF& p : {QPointF(0, 0), QPointF(w, 0), QPointF(w, h), QPointF(0, h)}) {
            QPointF q = hit.value().map(p);
            outline.emplace_back(static_cast<float>(q.x()), static_cast<float>(q.y()));
        }
        const std::string& name = names.at(hit.key());
        bool right = std::any_of(shown.begin(), shown.end(), [&](const json& one) {
            return one.at("template").get<std::string>() == name &&
                   overlap(outlineFrom(one.at("quad")), outline) > 0.5;
        });
        if (right && found.insert(name).second) {
            ++tally.found[at];
        } else {
            ++tally.wrong;
            tally.wrongInNegatives += shown.empty() ? 1 : 0;
        }
    }
}

double share(int part, int whole) {
    return whole > 0 ? static_cast<double>(part) / whole : 0.0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "find_object_run SET [--Group/parameter VALUE]...\n");
        return 2;
    }
    QCoreApplication application(argc, argv);
    cv::setNumThreads(1);
    find_object::Settings::init("");
    for (int i = 2; i + 1 < argc; i += 2)
        find_object::Settings::setParameter(QString(argv[i]).mid(2), QString(argv[i + 1]));
    find_object::FindObject finder;
    const std::string set = argv[1];
    auto names = train(set, finder);
    Tally tally;
    std::ifstream in(set + "/frames.jsonl");
    for (std::string line; std::getline(in, line);) {
        json one = json::parse(line);
        cv::Mat picture = cv::imread(set + "/" + one.at("file").get<std::string>(), cv::IMREAD_GRAYSCALE);
        find_object::DetectionInfo info;
        double start = cpuMilliseconds();
        finder.detect(picture, info);
        tally.milliseconds.push_back(cpuMilliseconds() - start);
        count(one, info, names, tally);
    }
    int right = tally.found[0] + tally.found[1] + tally.found[2];
    auto middle = tally.milliseconds.begin() + static_cast<std::ptrdiff_t>(tally.milliseconds.size() / 2);
    std::nth_element(tally.milliseconds.begin(), middle, tally.milliseconds.end());
    std::printf("| %.4f | %.4f | %.4f | %.4f | %d | %d | %.1f |\n", share(tally.found[0], tally.shown[0]),
                share(tally.found[1], tally.shown[1]), share(tally.found[2], tally.shown[2]),
                share(right, right + tally.wrong), tally.wrongInNegatives, tally.negatives, *middle);
    return 0;
}
