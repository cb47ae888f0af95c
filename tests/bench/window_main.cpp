// farol-bench-window: the workstation's window with a large map and a film of 30 pictures a second, walked
// again and again. Does the window always answer, and does its memory stay as it is?

#include "core/base/memory.h"
#include "core/building/geopackage.h"
#include "core/recognition/landmark_library.h"
#include "tests/bench/heartbeat.h"
#include "tests/support/campus.h"
#include "ui/convert/convert.h"
#include "ui/live/walk.h"
#include "ui/main_window/main_window.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTimer>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <malloc.h>
#include <string>
#include <unistd.h>
#include <utility>

namespace farol::bench {

namespace {

constexpr int kWarmingMs = 5000, kKeyMs = 400;

struct Task {
    std::string library, film;
    double seconds = 60.0;
    std::size_t regions = 10000;
    double framesPerSecond = 30.0;
    bool typing = false;
};

/// A film that begins again at its end, while its clock goes on.
class EndlessFilm : public capture::FrameSource {
public:
    using Open = std::function<Result<std::unique_ptr<capture::FrameSource>>()>;

    EndlessFilm(std::unique_ptr<capture::FrameSource> first, Open open, double period)
        : m_film(std::move(first)), m_open(std::move(open)), m_period(period) {}

    std::optional<capture::Frame> next() override {
        for (int attempt = 0; attempt < 2 && m_film && !stopRequested(); ++attempt) {
            if (auto frame = m_film->next()) {
                frame->index = m_index;
                frame->capturedAt = static_cast<double>(m_index++) * m_period;
                return frame;
            }
            auto again = m_open();
            m_film = again ? std::move(*again) : nullptr;
        }
        return std::nullopt;
    }
    bool live() const override { return false; }
    double framePeriod() const override { return m_period; }
    std::string description() const override { return "a film without an end"; }

private:
    std::unique_ptr<capture::FrameSource> m_film;
    Open m_open;
    double m_period;
    std::uint64_t m_index = 0;
};

/// What the program holds; the rest of the resident memory is code, libraries, and holes between what it
/// holds.
double allocatedMb() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
}

double residentMb() {
    std::ifstream file("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    file >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// The templates of the library hang all over the campus, so that what is seen speaks for many places.
std::shared_ptr<const building::Building> campusWith(const std::string& library, std::size_t regions) {
    test::CampusOptions options;
    options.regions = regions;
    building::BuildingData data = test::campusData(options);
    const auto known = recognition::loadPhotographs(library);
    if (known && !known->templates.empty()) {
        std::size_t next = 0;
        std::vector<building::Landmark> more;
        for (const building::Region& region : data.regions) {
            if (region.kind != building::RegionKind::Corridor || region.polygon.outer.empty()) continue;
            const recognition::Template& seen = known->templates[next++ % known->templates.size()];
            building::Landmark landmark;
            landmark.id = LandmarkId("bench-" + std::to_string(next));
            landmark.kind = seen.kind;
            landmark.templateId = seen.id;
            landmark.region = region.id;
            landmark.level = region.level;
            landmark.position = region.polygon.outer.front();
            more.push_back(std::move(landmark));
        }
        data.landmarks.insert(data.landmarks.end(), more.begin(), more.end());
    }
    return std::make_shared<const building::Building>(std::move(data));
}

class Bench : public QObject {
public:
    Bench(const Task& task, ui::MainWindow& window) : m_task(task), m_window(window) {
        QObject::connect(&window.page(), &ui::LivePage::frameShown, this, [this](int) { shown(); });
        QObject::connect(&window.walk(), &ui::Walk::problem, this, [](ui::Problem, const QString& message) {
            std::fprintf(stderr, "farol-bench-window: %s\n", qPrintable(message));
            QCoreApplication::exit(1);
        });
        QObject::connect(&window.walk(), &ui::Walk::stepped, this,
                         [this](const session::NavigationStep& step) {
                             ++m_steps;
                             m_votes = std::max(m_votes, step.fix.votes.size());
                             m_frame = step.percept.frame;
                         });
        QObject::connect(&m_minute, &QTimer::timeout, this, [this] { tellMinute(); });
        m_minute.setInterval(60000);
        QObject::connect(&m_hands, &QTimer::timeout, this, [this] { typeNext(); });
        m_hands.setInterval(kKeyMs);
    }

private:
    /// The first pictures load what is needed later; then it counts.
    void shown() {
        ++m_shown;
        if (std::exchange(m_begun, true)) return;
        QTimer::singleShot(kWarmingMs, this, [this] { beginMeasuring(); });
    }

    void beginMeasuring() {
        m_opening = m_heart.beats();
        m_heart.reset();
        m_shown = m_steps = 0;
        m_firstFrame = m_frame;
        std::printf(
            "| minute | resident memory, MB | of it asked for, MB |\n|---:|---:|---:|\n| 0 | %.0f | %.0f |\n",
            residentMb(), allocatedMb());
        std::fflush(stdout);
        m_minute.start();
        if (m_task.typing) m_hands.start();
        QTimer::singleShot(static_cast<int>(m_task.seconds * 1000.0), this, [this] { finish(); });
    }

    /// An assistant who looks for a destination all the time, and leaves it at that.
    void typeNext() {
        for (QLineEdit* line : m_window.findChildren<QLineEdit*>()) {
            if (line->accessibleName() != QLatin1String("Destination")) continue;
            const QString text = QStringLiteral("room 1");
            const bool over = m_keys % (text.size() + 1) == text.size();
            const QString letter = over ? QString() : text.mid(m_keys % (text.size() + 1), 1);
            ++m_keys;
            QKeyEvent press(QEvent::KeyPress, over ? int(Qt::Key_Escape) : int(letter[0].toUpper().unicode()),
                            Qt::NoModifier, letter);
            if (QWidget* list = QApplication::activePopupWidget())
                QApplication::sendEvent(list, &press);
            else
                QApplication::sendEvent(line, &press);
            return;
        }
    }

    void tellMinute() {
        std::printf("| %d | %.0f | %.0f |\n", ++m_minutes, residentMb(), allocatedMb());
        std::fflush(stdout);
    }

    void finish() {
        m_minute.stop();
        m_hands.stop();
        if (m_task.typing) std::printf("\n%lld keys were pressed\n", static_cast<long long>(m_keys));
        const auto due = static_cast<double>(m_frame - m_firstFrame);
        std::printf("\n%.0f pictures were due in %.0f s, %zu went through the chain, %zu were shown; at most "
                    "%zu places "
                    "voted for\n\nWhile opening (map, library, film), and the first 5 s:\n\n",
                    due, m_task.seconds, m_steps, m_shown, m_votes);
        printBeats(m_opening);
        std::printf("\nWhile walking:\n\n");
        printBeats(m_heart.beats());
        m_window.walk().stop();
        QTimer::singleShot(200, qApp, [] { QCoreApplication::exit(0); });
    }

    Task m_task;
    ui::MainWindow& m_window;
    Heartbeat m_heart;
    std::vector<Beat> m_opening;
    QTimer m_minute, m_hands;
    qsizetype m_keys = 0;
    std::size_t m_shown = 0, m_steps = 0, m_votes = 0;
    std::uint64_t m_frame = 0, m_firstFrame = 0;
    int m_minutes = 0;
    bool m_begun = false;
};

int run(const Task& task, int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    const QTemporaryDir folder;
    const auto campus = campusWith(task.library, task.regions);
    const QString map = folder.filePath(QStringLiteral("campus.gpkg"));
    if (auto saved = building::saveBuilding(*campus, ui::toUtf8(map)); !saved) {
        std::fprintf(stderr, "farol-bench-window: %s\n", saved.error().text().c_str());
        return 1;
    }
    std::printf("%zu regions, %zu accesses, %zu landmarks\n\n", campus->regions().size(),
                campus->accesses().size(), campus->landmarks().size());
    ui::Settings settings(folder.filePath(QStringLiteral("settings.ini")));
    settings.setLanguage(QStringLiteral("en"));
    ui::MainWindow::applyLanguage(settings);
    const auto open =
        [task](const std::string& name,
               const capture::SourceOptions& options) -> Result<std::unique_ptr<capture::FrameSource>> {
        auto first = capture::openSource(name, options);
        if (!first) return first.error();
        return std::unique_ptr<capture::FrameSource>(new EndlessFilm(
            std::move(*first), [name, options] { return capture::openSource(name, options); },
            1.0 / task.framesPerSecond));
    };
    ui::MainWindow window(settings, open);
    window.resize(1280, 800);
    window.show();
    Bench bench(task, window);
    ui::StartOptions begin;
    begin.map = map;
    begin.library = ui::toQString(task.library);
    begin.source = ui::toQString(task.film);
    begin.framesPerSecond = task.framesPerSecond;
    const auto ways = test::campusPairs(*campus, 1);
    begin.from = ui::toQString(ways.front().first.region.value);
    begin.to = ui::toQString(ways.front().second.region.value);
    begin.play = true;
    window.begin(begin);
    return QApplication::exec();
}

} // namespace

} // namespace farol::bench

int main(int argc, char** argv) {
    farol::keepHeapSmall(); // as the workstation does
    const auto usage = [] {
        std::fprintf(
            stderr,
            "usage: farol-bench-window LIBRARY FILM [--seconds S] [--regions N] [--fps F] [--typing]\n");
        return 2;
    };
    farol::bench::Task task;
    task.typing = argc > 3 && std::strcmp(argv[argc - 1], "--typing") == 0;
    if (task.typing) --argc;
    if (argc < 3 || argc % 2 == 0) return usage();
    task.library = argv[1];
    task.film = argv[2];
    for (int i = 3; i + 1 < argc; i += 2) {
        const double value = std::atof(argv[i + 1]);
        if (!(value > 0.0 && value <= 1e6)) return usage();
        if (std::strcmp(argv[i], "--seconds") == 0)
            task.seconds = value;
        else if (std::strcmp(argv[i], "--regions") == 0)
            task.regions = static_cast<std::size_t>(value);
        else if (std::strcmp(argv[i], "--fps") == 0)
            task.framesPerSecond = value;
        else
            return usage();
    }
    return farol::bench::run(task, argc, argv);
}
