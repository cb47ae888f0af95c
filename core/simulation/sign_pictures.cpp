#include "core/simulation/sign_pictures.h"

#include "core/simulation/hash.h"
#include "core/simulation/lettering.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cctype>
#include <vector>

namespace farol::simulation {

namespace {

using Points = std::vector<cv::Point>;

const cv::Scalar kWhite(244, 248, 248), kBlack(32, 30, 30);

void fill(cv::Mat& picture, const Points& points, const cv::Scalar& colour) {
    cv::fillPoly(picture, std::vector<Points>{points}, colour, cv::LINE_AA);
}

void limb(cv::Mat& picture, const Points& joints, int thick, const cv::Scalar& colour) {
    for (std::size_t i = 1; i < joints.size(); ++i)
        cv::line(picture, joints[i - 1], joints[i], colour, thick, cv::LINE_AA);
}

void runner(cv::Mat& picture, cv::Point at, const cv::Scalar& colour) {
    cv::circle(picture, at + cv::Point(18, -62), 14, colour, -1, cv::LINE_AA);
    limb(picture, {at + cv::Point(8, -42), at + cv::Point(-8, 4)}, 24, colour);
    limb(picture, {at + cv::Point(10, -42), at + cv::Point(36, -22), at + cv::Point(54, -34)}, 11, colour);
    limb(picture, {at + cv::Point(2, -42), at + cv::Point(-28, -36), at + cv::Point(-40, -10)}, 11, colour);
    limb(picture, {at + cv::Point(-6, 4), at + cv::Point(24, 22), at + cv::Point(18, 60)}, 14, colour);
    limb(picture, {at + cv::Point(-8, 4), at + cv::Point(-20, 36), at + cv::Point(-52, 48)}, 14, colour);
}

void arrowAt(cv::Mat& picture, cv::Point at, int way, const cv::Scalar& colour) {
    Points head{{46, 0}, {0, -46}, {0, -20}, {-46, -20}, {-46, 20}, {0, 20}, {0, 46}}, turned;
    for (cv::Point p : head)
        turned.push_back(at + (way == 0 ? cv::Point(-p.y, p.x) : cv::Point(p.x * way, p.y)));
    fill(picture, turned, colour);
}

cv::Mat plate(int width, int height, const cv::Scalar& colour) {
    cv::Mat picture(height, width, CV_8UC3, colour);
    cv::rectangle(picture, {0, 0, width, height}, colour * 0.8, 3);
    return picture;
}

cv::Scalar lively(Draw& draw, double low, double high) {
    cv::Mat hsv(1, 1, CV_8UC3,
                cv::Scalar(draw.below(180), draw.between(low, high) * 255.0, draw.between(110.0, 240.0)));
    cv::Mat bgr;
    cv::cvtColor(hsv, bgr, cv::COLOR_HSV2BGR);
    auto p = bgr.at<cv::Vec3b>(0, 0);
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// Rows of small strokes that look like print from where nobody can read it.
void print(cv::Mat& picture, const cv::Rect& box, int line, const cv::Scalar& colour, Draw& draw) {
    for (int y = box.y; y + line < box.y + box.height; y += line * 2) {
        int x = box.x, end = box.x + static_cast<int>(box.width * draw.between(0.65, 1.0));
        while (x < end) {
            int word = line + draw.below(line * 5);
            cv::rectangle(picture, {x, y, std::min(word, end - x), std::max(1, line - draw.below(2))}, colour,
                          -1);
            x += word + line / 2 + 1;
        }
    }
}

/// Something like a photograph: hills, discs and grain, its own for each seed.
void photo(cv::Mat picture, Draw& draw) {
    cv::Scalar above = lively(draw, 0.2, 0.7), below = lively(draw, 0.2, 0.7);
    for (int y = 0; y < picture.rows; ++y) {
        double share = static_cast<double>(y) / picture.rows;
        picture.row(y).setTo(above * (1.0 - share) + below * share);
    }
    for (int hill = 0; hill < 3; ++hill) {
        Points line;
        double height = picture.rows * draw.between(0.3, 0.85);
        for (int x = 0; x <= 12; ++x) {
            height = std::clamp(height + draw.between(-0.09, 0.09) * picture.rows, picture.rows * 0.15,
                                picture.rows * 0.95);
            line.emplace_back(x * picture.cols / 12, static_cast<int>(height));
        }
        line.emplace_back(picture.cols, picture.rows);
        line.emplace_back(0, picture.rows);
        fill(picture, line, lively(draw, 0.3, 0.9) * draw.between(0.5, 1.0));
    }
    int discs = 5 + draw.below(12);
    for (int i = 0; i < discs; ++i) {
        cv::Point at(draw.below(picture.cols), draw.below(picture.rows));
        int size = 3 + draw.below(std::max(4, picture.cols / 9));
        if (draw.chance(0.5))
            cv::circle(picture, at, size, lively(draw, 0.4, 1.0), -1, cv::LINE_AA);
        else
            cv::ellipse(picture, at, {size, size / 2 + 1}, draw.between(0.0, 180.0), 0.0, 360.0,
                        lively(draw, 0.4, 1.0), draw.chance(0.3) ? 2 : -1, cv::LINE_AA);
    }
    for (int i = 0; i < picture.rows * picture.cols / 90; ++i) {
        auto& pixel = picture.at<cv::Vec3b>(draw.below(picture.rows), draw.below(picture.cols));
        double shift = draw.between(-30.0, 30.0);
        for (int c = 0; c < 3; ++c) pixel[c] = cv::saturate_cast<std::uint8_t>(pixel[c] + shift);
    }
}

const char* kTitles[] = {"OPEN DAY",   "CONCERT",      "RECYCLE",    "EXHIBITION", "CHESS CLUB",
                         "LECTURE",    "BLOOD\nDRIVE", "ERASMUS",    "THEATRE",    "ROBOTICS",
                         "FOR SALE",   "YOGA",         "TEATRO",     "FESTA",      "BIBLIOTECA",
                         "CONFERENCE", "ASTRONOMY",    "FILM NIGHT", "MARATHON",   "JAZZ"};

} // namespace

cv::Mat exitSign(int arrow) {
    cv::Mat picture = plate(400, 200, cv::Scalar(78, 132, 0));
    bool left = arrow < 0;
    cv::Mat half = picture(cv::Rect(left ? 200 : 0, 0, 200, 200));
    cv::Mat figure = cv::Mat(half.size(), CV_8UC3, cv::Scalar(78, 132, 0));
    cv::rectangle(figure, {128, 26, 58, 150}, kWhite, -1);
    runner(figure, {80, 108}, kWhite);
    if (left) cv::flip(figure, figure, 1);
    figure.copyTo(half);
    arrowAt(picture, {left ? 100 : 300, 100}, arrow, kWhite);
    cv::rectangle(picture, {4, 4, 392, 192}, kWhite, 3);
    return picture;
}

cv::Mat extinguisherSign() {
    cv::Mat picture = plate(256, 256, cv::Scalar(36, 26, 190));
    cv::rectangle(picture, {96, 92, 60, 130}, kWhite, -1);
    cv::ellipse(picture, {126, 92}, {30, 22}, 0.0, 180.0, 360.0, kWhite, -1, cv::LINE_AA);
    cv::rectangle(picture, {114, 46, 24, 30}, kWhite, -1);
    limb(picture, {{126, 52}, {176, 40}}, 10, kWhite);
    limb(picture, {{112, 56}, {76, 66}, {70, 150}}, 9, kWhite);
    fill(picture, {{214, 220}, {186, 170}, {204, 130}, {208, 158}, {226, 140}, {238, 190}}, kWhite);
    cv::rectangle(picture, {6, 6, 244, 244}, kWhite, 4);
    return picture;
}

cv::Mat hydrantSign() {
    cv::Mat picture = plate(256, 256, cv::Scalar(36, 26, 190));
    cv::circle(picture, {110, 140}, 66, kWhite, 14, cv::LINE_AA);
    cv::circle(picture, {110, 140}, 36, kWhite, 12, cv::LINE_AA);
    limb(picture, {{110, 74}, {200, 74}, {222, 110}}, 14, kWhite);
    fill(picture, {{214, 236}, {186, 196}, {204, 150}, {210, 180}, {226, 164}, {238, 210}}, kWhite);
    return picture;
}

cv::Mat extinguisherLabel(std::uint64_t seed) {
    Draw draw(seed);
    cv::Mat picture(256, 192, CV_8UC3, cv::Scalar(222, 232, 236));
    cv::rectangle(picture, {0, 0, 192, 52}, cv::Scalar(30, 30, 30), -1);
    write(picture, draw.chance(0.5) ? "FIRE" : "PO 6 kg", Face::Bold, {16, 12, 160, 30}, kWhite);
    for (int i = 0; i < 3; ++i)
        cv::rectangle(picture, {14 + i * 58, 66, 46, 46}, cv::Scalar(60, 90, 40 + 60 * i), -1);
    print(picture, {14, 126, 164, 120}, 5, kBlack, draw);
    return picture;
}

cv::Mat textSign(const std::string& text, double widthOverHeight, std::uint64_t seed) {
    if (text.empty()) return pictogram(seed);
    Draw draw(seed);
    int height = 220, width = std::clamp(static_cast<int>(height * widthOverHeight), 60, 1200);
    bool dark = draw.chance(0.35);
    cv::Scalar ground = dark ? cv::Scalar(70 + draw.below(60), 50 + draw.below(40), 30 + draw.below(40))
                             : cv::Scalar(226 + draw.below(20), 232 + draw.below(16), 232 + draw.below(16));
    cv::Mat picture = plate(width, height, ground);
    int margin = height / 7;
    write(picture, text, draw.chance(0.6) ? Face::Bold : Face::Sans,
          {margin, margin * 3 / 2, width - 2 * margin, height - 3 * margin}, dark ? kWhite : kBlack);
    if (draw.chance(0.3)) cv::rectangle(picture, {8, 8, width - 16, height - 16}, dark ? kWhite : kBlack, 4);
    return picture;
}

cv::Mat pictogram(std::uint64_t seed) {
    Draw draw(seed);
    cv::Mat picture = plate(256, 256, cv::Scalar(140 + draw.below(40), 80 + draw.below(30), 20));
    auto person = [&](int x, bool skirt) {
        cv::circle(picture, {x, 60}, 20, kWhite, -1, cv::LINE_AA);
        if (skirt)
            fill(picture, {{x - 16, 88}, {x + 16, 88}, {x + 36, 170}, {x - 36, 170}}, kWhite);
        else
            cv::rectangle(picture, {x - 22, 88, 44, 84}, kWhite, -1);
        cv::rectangle(picture, {x - 18, 168, 14, 56}, kWhite, -1);
        cv::rectangle(picture, {x + 4, 168, 14, 56}, kWhite, -1);
    };
    switch (draw.below(5)) {
    case 0: // toilets
        person(80, false);
        person(176, true);
        cv::line(picture, {128, 40}, {128, 224}, kWhite, 5);
        break;
    case 1: // information
        write(picture, "i", Face::Serif, {60, 40, 136, 176}, kWhite);
        break;
    case 2: // coffee
        cv::rectangle(picture, {66, 96, 100, 96}, kWhite, -1);
        cv::ellipse(picture, {168, 136}, {30, 28}, 0.0, 0.0, 360.0, kWhite, 12, cv::LINE_AA);
        cv::rectangle(picture, {48, 200, 140, 12}, kWhite, -1);
        break;
    case 3: // meeting point
        for (int dx : {-1, 1})
            for (int dy : {-1, 1})
                limb(picture, {{128 + dx * 100, 128 + dy * 100}, {128 + dx * 52, 128 + dy * 52}}, 18, kWhite);
        person(128, false);
        break;
    default:
        arrowAt(picture, {128, 128}, draw.chance(0.5) ? 1 : -1, kWhite);
        break;
    }
    return picture;
}

cv::Mat stairsSign() {
    cv::Mat picture = plate(256, 256, cv::Scalar(150, 90, 20));
    Points steps{{40, 214}};
    for (int i = 0; i < 5; ++i) {
        steps.emplace_back(40 + i * 36, 214 - i * 34 - 34);
        steps.emplace_back(40 + (i + 1) * 36, 214 - i * 34 - 34);
    }
    steps.emplace_back(220, 214);
    fill(picture, steps, kWhite);
    return picture;
}

cv::Mat liftSign() {
    cv::Mat picture = plate(256, 256, cv::Scalar(150, 90, 20));
    cv::rectangle(picture, {58, 80, 140, 150}, kWhite, 8);
    for (int x : {90, 128, 166}) {
        cv::circle(picture, {x, 116}, 12, kWhite, -1, cv::LINE_AA);
        cv::rectangle(picture, {x - 13, 132, 26, 84}, kWhite, -1);
    }
    fill(picture, {{80, 66}, {124, 66}, {102, 34}}, kWhite);
    fill(picture, {{134, 36}, {178, 36}, {156, 68}}, kWhite);
    return picture;
}

cv::Mat poster(const std::string& title, double widthOverHeight, std::uint64_t seed) {
    Draw draw(seed);
    int height = 512, width = std::clamp(static_cast<int>(height * widthOverHeight), 96, 1024);
    cv::Scalar ground = draw.chance(0.5) ? lively(draw, 0.0, 0.18) : lively(draw, 0.4, 0.9);
    cv::Mat picture(height, width, CV_8UC3, ground);
    cv::Scalar ink = cv::mean(picture)[1] > 140.0 ? cv::Scalar(40, 30, 30) : kWhite;
    std::string head = title;
    if (head.empty()) head = kTitles[draw.below(static_cast<int>(std::size(kTitles)))];
    int layout = draw.below(4);
    int band = height / 5, edge = width / 14;
    cv::Rect titleBox(edge, edge, width - 2 * edge, band - edge);
    cv::Rect image(edge, band, width - 2 * edge, height / 2);
    if (layout == 1) {
        titleBox.y = height - band;
        image.y = edge;
    } else if (layout == 2) {
        image = cv::Rect(0, 0, width, height * 3 / 5);
        titleBox = cv::Rect(edge, height * 3 / 5 + 8, width - 2 * edge, band - 8);
    }
    photo(picture(image), draw);
    if (layout == 3) {
        for (int i = 0; i < 4; ++i)
            cv::circle(picture, {draw.below(width), draw.below(height)}, width / 12 + draw.below(width / 5),
                       lively(draw, 0.6, 1.0), draw.chance(0.5) ? -1 : 8, cv::LINE_AA);
    }
    write(picture, head, draw.chance(0.5) ? Face::Bold : Face::Serif, titleBox, ink);
    int free = layout == 1 ? image.y + image.height + 10
                           : std::max(image.y + image.height, titleBox.y + titleBox.height) + 10;
    int bottom = layout == 1 ? titleBox.y - 8 : height - edge;
    if (bottom - free > 24)
        print(picture, {edge, free, width - 2 * edge, bottom - free}, 5 + draw.below(4), ink, draw);
    if (draw.chance(0.4)) cv::rectangle(picture, {0, 0, width, height}, kWhite, 14);
    return picture;
}

cv::Mat paintedPicture(double widthOverHeight, std::uint64_t seed) {
    Draw draw(seed);
    int height = 400, width = std::clamp(static_cast<int>(height * widthOverHeight), 96, 1000), rim = 26;
    cv::Mat picture(height, width, CV_8UC3, lively(draw, 0.2, 0.5) * 0.4);
    cv::rectangle(picture, {6, 6, width - 12, height - 12}, lively(draw, 0.1, 0.5), 6);
    photo(picture(cv::Rect(rim, rim, width - 2 * rim, height - 2 * rim)), draw);
    return picture;
}

cv::Mat noticeBoard(double widthOverHeight, std::uint64_t seed) {
    Draw draw(seed);
    int height = 440, width = std::clamp(static_cast<int>(height * widthOverHeight), 200, 1200);
    cv::Mat picture(height, width, CV_8UC3,
                    draw.chance(0.6) ? cv::Scalar(110, 160, 196) : cv::Scalar(120, 96, 60));
    for (int i = 0; i < width * height / 40; ++i) {
        auto& pixel = picture.at<cv::Vec3b>(draw.below(height), draw.below(width));
        for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(pixel[c] * 4 / 5);
    }
    int sheets = width / 38;
    for (int i = 0; i < sheets; ++i) {
        int w = 60 + draw.below(60), h = 70 + draw.below(80);
        cv::Rect box(draw.below(std::max(1, width - w)), draw.below(std::max(1, height - h)), w, h);
        bool small = draw.chance(0.25);
        cv::Mat sheet(h, w, CV_8UC3, draw.chance(0.7) ? cv::Scalar(236, 240, 240) : lively(draw, 0.15, 0.5));
        if (small)
            cv::resize(poster("", static_cast<double>(w) / h, draw.bits()), sheet, sheet.size(), 0.0, 0.0,
                       cv::INTER_AREA);
        else
            print(sheet, {6, 10, w - 12, h - 16}, 3 + draw.below(2), kBlack, draw);
        sheet.copyTo(picture(box));
        cv::rectangle(picture, box, cv::Scalar(90, 90, 90), 1);
        cv::circle(picture, {box.x + w / 2, box.y + 4}, 3, lively(draw, 0.8, 1.0), -1, cv::LINE_AA);
    }
    cv::rectangle(picture, {0, 0, width, height}, cv::Scalar(150, 156, 160), 16);
    return picture;
}

cv::Mat lockerDoors(double widthM, std::uint64_t seed) {
    Draw draw(seed);
    int columns = std::clamp(static_cast<int>(widthM / 0.3 + 0.5), 1, 30), cell = 100, rows = 2, tall = 290;
    cv::Scalar colour = lively(draw, 0.2, 0.65);
    cv::Mat picture(rows * tall, columns * cell, CV_8UC3, colour);
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            cv::Rect door(c * cell, r * tall, cell, tall);
            picture(door).setTo(colour * draw.between(0.92, 1.05));
            cv::rectangle(picture, door, colour * 0.45, 4);
            for (int i = 0; i < 4; ++i)
                cv::rectangle(picture, {door.x + 26, door.y + 30 + i * 14, cell - 52, 5}, colour * 0.4, -1);
            cv::circle(picture, {door.x + cell - 20, door.y + tall / 2}, 8, cv::Scalar(190, 190, 190), -1,
                       cv::LINE_AA);
            write(picture, std::to_string(1 + c + r * columns + static_cast<int>(seed % 40) * 10), Face::Sans,
                  {door.x + 30, door.y + 100, 40, 20}, kWhite);
            if (draw.chance(0.15))
                cv::rectangle(picture, {door.x + 14 + draw.below(30), door.y + 170 + draw.below(60), 34, 28},
                              lively(draw, 0.6, 1.0), -1);
        }
    }
    return picture;
}

cv::Mat vendingFront(std::uint64_t seed) {
    Draw draw(seed);
    cv::Scalar body = lively(draw, 0.5, 0.95) * 0.8;
    cv::Mat picture(760, 400, CV_8UC3, body);
    cv::rectangle(picture, {24, 90, 270, 500}, cv::Scalar(40, 36, 34), -1);
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 5; ++column) {
            cv::Scalar colour = lively(draw, 0.5, 1.0);
            cv::Rect item(36 + column * 52, 104 + row * 82, 36, 56);
            cv::rectangle(picture, item, colour, -1);
            cv::rectangle(picture, {item.x + 6, item.y + 16, 24, 14}, kWhite, -1);
        }
        cv::rectangle(picture, {24, 164 + row * 82, 270, 7}, cv::Scalar(170, 170, 170), -1);
    }
    cv::rectangle(picture, {312, 200, 66, 110}, cv::Scalar(60, 60, 60), -1);
    for (int i = 0; i < 12; ++i)
        cv::rectangle(picture, {320 + i % 3 * 18, 244 + i / 3 * 15, 13, 10}, cv::Scalar(200, 200, 200), -1);
    cv::rectangle(picture, {320, 210, 50, 24}, cv::Scalar(90, 200, 120), -1);
    cv::rectangle(picture, {60, 640, 200, 70}, cv::Scalar(30, 30, 30), -1);
    const char* names[] = {"SNACKS", "DRINKS", "CAFÉ", "BEBIDAS"};
    write(picture, names[draw.below(4)], Face::Bold, {40, 20, 320, 54}, kWhite);
    return picture;
}

cv::Mat windowView(double widthOverHeight) {
    int height = 256, width = std::clamp(static_cast<int>(height * widthOverHeight), 64, 900), bar = 12;
    cv::Mat picture(height, width, CV_8UC3);
    for (int y = 0; y < height; ++y) {
        double share = static_cast<double>(y) / height;
        picture.row(y).setTo(cv::Scalar(250, 226, 200) * (1.0 - share) + cv::Scalar(240, 240, 236) * share);
    }
    cv::rectangle(picture, {0, 0, width, height}, cv::Scalar(226, 228, 228), 2 * bar);
    cv::rectangle(picture, {width / 2 - bar / 2, 0, bar, height}, cv::Scalar(226, 228, 228), -1);
    return picture;
}

cv::Mat buttonPanel(std::uint64_t seed) {
    Draw draw(seed);
    cv::Mat picture(480, 120, CV_8UC3, cv::Scalar(176, 176, 172));
    cv::rectangle(picture, {22, 20, 76, 50}, cv::Scalar(20, 16, 16), -1);
    write(picture, std::to_string(draw.below(4)), Face::Bold, {40, 28, 40, 34}, cv::Scalar(40, 60, 255));
    for (int i = 0; i < 6; ++i) {
        cv::Point at(60, 110 + i * 54);
        cv::circle(picture, at, 20, cv::Scalar(220, 222, 222), -1, cv::LINE_AA);
        cv::circle(picture, at, 20, cv::Scalar(90, 90, 90), 2, cv::LINE_AA);
        write(picture, std::to_string(5 - i), Face::Sans, {at.x - 10, at.y - 10, 20, 20}, kBlack);
    }
    return picture;
}

} // namespace farol::simulation
