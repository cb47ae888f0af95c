#include "tests/ui/desk_tour.h"

#include "core/building/edit.h"
#include "core/building/geopackage.h"
#include "tests/recognition/drawn_pictures.h"
#include "ui/convert/convert.h"
#include "ui/curation/feature_dialogs.h"
#include "ui/curation/floor_pictures.h"
#include "ui/curation/import_dialog.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/missing_dialog.h"
#include "ui/curation/plan_panel.h"
#include "ui/curation/report_panel.h"
#include "ui/curation/route_panel.h"
#include "ui/kiosk/kiosk_page.h"
#include "ui/live/revote_dialog.h"
#include "ui/main_window/figures_dialog.h"
#include "ui/main_window/help_dialog.h"
#include "ui/main_window/keys_dialog.h"
#include "ui/main_window/profile_menu.h"
#include "ui/main_window/settings_dialog.h"
#include "ui/main_window/source_dialog.h"
#include "ui/main_window/welcome_dialog.h"
#include "ui/parts/banner.h"
#include "ui/training/edit_template_dialog.h"
#include "ui/training/library_panel.h"
#include "ui/training/teach_views.h"
#include "ui/training/teach_what.h"
#include "ui/training/training_actions.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTest>

namespace farol::ui::test {

namespace {

constexpr int kPatience = 60000;

class NoChimes : public Chimes {
public:
    void play(Sound /*sound*/) override {}
};

Result<std::unique_ptr<capture::FrameSource>> greySource(const std::string&, const capture::SourceOptions&) {
    return std::unique_ptr<capture::FrameSource>(std::make_unique<FakeSource>(3, 0.3));
}

Result<std::unique_ptr<capture::FrameSource>> lastingSource(const std::string&,
                                                            const capture::SourceOptions&) {
    return std::unique_ptr<capture::FrameSource>(std::make_unique<FakeSource>(1000000, 0.1));
}

std::unique_ptr<SpeechOutput> fakeVoice(const VoiceChoice&) {
    return std::make_unique<FakeVoice>();
}

/// The hand-made house with a mistake, so that the report has something to tell.
building::BuildingData house() {
    building::BuildingData data = handMadeBuilding()->data();
    data.landmarks.push_back(data.landmarks[0]);
    data.landmarks.back().id = LandmarkId("L3");
    data.landmarks.back().position = {30.0, 30.0};
    return data;
}

} // namespace

DeskTour::DeskTour() {
    namespace drawn = recognition::test;
    m_map = file("house.gpkg");
    if (!building::saveBuilding(building::Building(house()), toUtf8(m_map)).ok()) m_wrong = m_map;
    m_library = file("posters.gpkg");
    recognition::LandmarkLibrary library;
    for (const std::uint64_t seed : {1U, 2U, 1U}) drawn::trainPoster(library, seed);
    if (!recognition::saveLibrary(library, toUtf8(file("posters-as-made.gpkg"))).ok()) m_wrong = m_library;
    for (const char* name : {"photo-1.jpg", "photo-2.jpg"}) {
        cv::Mat picture = drawn::room(m_photos.size() + 3);
        drawn::hang(picture, drawn::poster(21), quadOf({160, 100, 320, 240}));
        QFile photo(file(name));
        if (photo.open(QIODevice::WriteOnly)) photo.write(QByteArray::fromStdString(drawn::jpeg(picture)));
        m_photos << photo.fileName();
    }
}

QString DeskTour::go(const QString& language, const Visit& visit) {
    m_language = language;
    m_visit = visit;
    pages();
    windowsOwnDialogs();
    dialogs();
    kiosk();
    m_window.reset();
    m_settings.reset();
    return m_wrong;
}

bool DeskTour::await(const std::function<bool()>& condition, const char* what) {
    if (!m_wrong.isEmpty()) return false;
    if (!QTest::qWaitFor(condition, kPatience)) m_wrong = QLatin1String(what);
    return m_wrong.isEmpty();
}

void DeskTour::make() {
    m_window.reset();
    QDir(file("teaching")).removeRecursively();
    QFile::remove(file("settings.ini"));
    QFile::remove(m_library);
    QFile::copy(file("posters-as-made.gpkg"), m_library);
    m_settings = std::make_unique<Settings>(file("settings.ini"));
    m_settings->setLanguage(m_language);
    m_settings->setRecordingFolder(m_folder.path());
    MainWindow::applyLanguage(*m_settings);
    MainWindow::applyLook(*m_settings);
    m_window = std::make_unique<MainWindow>(*m_settings, greySource, fakeVoice);
    m_window->resize(1280, 800);
    m_window->show();
}

void DeskTour::stop(QWidget& top, const QString& name) {
    if (!m_wrong.isEmpty()) return;
    top.activateWindow();
    if (!await([&] { return QApplication::activeWindow() == &top; }, "the window does not become active"))
        return;
    QApplication::processEvents(); // layouts come to rest
    m_visit(top, name);
}

void DeskTour::see(std::unique_ptr<QDialog> dialog, const QString& name) {
    dialog->show();
    stop(*dialog, name);
}

void DeskTour::seeModal(const QString& name) {
    if (!await([] { return QApplication::activeModalWidget() != nullptr; }, qPrintable(name))) return;
    QWidget* top = QApplication::activeModalWidget();
    stop(*top, name);
    QTest::keyClick(top, Qt::Key_Escape);
    await([top] { return QApplication::activeModalWidget() != top; }, "a question stays");
}

void DeskTour::pages() {
    walkPage();
    demo();
    mapPage();
    landmarksPage();
    wizard();
}

void DeskTour::walkPage() {
    make();
    stop(*m_window, QStringLiteral("walk-empty"));
    StartOptions options;
    options.map = m_map;
    options.source = QStringLiteral("grey");
    options.to = QStringLiteral("Library");
    options.play = true;
    m_window->begin(options);
    await([this] { return m_window->walk().state() == session::RunState::Ended; }, "the walk does not end");
    LivePage& page = m_window->page();
    page.show(handMadeSnapshot());
    auto* tabs = page.findChild<QTabWidget*>();
    for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        stop(*m_window, QStringLiteral("walk-%1").arg(tab + 1));
    }
}

void DeskTour::demo() {
    make();
    StartOptions options;
    options.map = m_map;
    options.source = QStringLiteral("sim:Café");
    options.play = true;
    m_window->begin(options);
    await([this] { return m_window->page().framesShown() > 0; }, "the demonstration does not begin");
    m_window->walk().pause();
    await([this] { return m_window->walk().state() == session::RunState::Paused; }, "it does not hold");
    stop(*m_window, QStringLiteral("demo"));
}

void DeskTour::mapPage() {
    make();
    m_window->showPage(Page::Map);
    stop(*m_window, QStringLiteral("map-empty"));
    MapPage& page = m_window->mapPage();
    page.open(m_map);
    await([&] { return page.settled() && page.document().building() != nullptr; }, "the map does not open");
    if (!m_wrong.isEmpty()) return;
    for (const auto what : {MapHit::What::Region, MapHit::What::Access, MapHit::What::Landmark}) {
        page.plan().view().select(MapHit{what, 0}, true);
        stop(*m_window, QStringLiteral("map-table-%1").arg(static_cast<int>(what) + 1));
    }
    page.actions().ambiguity->setChecked(true);
    await([&] { return page.settled(); }, "the marks do not come");
    page.actions().ambiguity->setChecked(false);
    page.actions().coverage->setChecked(true);
    QImage picture(260, 120, QImage::Format_RGB32);
    picture.fill(QColor(120, 160, 90));
    picture.save(file("floor.png"));
    page.pictures().load(file("floor.png"));
    await([&] { return page.settled() && page.pictures().placing(); }, "the image does not come");
    stop(*m_window, QStringLiteral("map-layers"));
    page.pictures().remove();
    page.actions().coverage->setChecked(false);
    page.tabs().setCurrentWidget(&page.report());
    page.report().showNext();
    stop(*m_window, QStringLiteral("map-check"));
    page.tabs().setCurrentWidget(&page.route());
    page.showRoute(QStringLiteral("r1"), QStringLiteral("lib"));
    await([&] { return page.route().model().route() != nullptr; }, "no route");
    stop(*m_window, QStringLiteral("map-route"));
}

void DeskTour::landmarksPage() {
    make();
    m_window->showPage(Page::Landmarks);
    stop(*m_window, QStringLiteral("landmarks-empty"));
    TrainingPage& page = m_window->trainingPage();
    page.open(m_library);
    if (!await([&] { return page.document().library() != nullptr; }, "the library does not open")) return;
    page.panel().table().selectRow(0);
    stop(*m_window, QStringLiteral("landmarks"));
    page.panel().showReport();
    page.panel().check();
    await([&] { return page.panel().confusion().rowCount() > 0; }, "no report");
    stop(*m_window, QStringLiteral("landmarks-report"));
    page.panel().table().selectRow(0);
    page.panel().views().setCurrentRow(1);
    page.actions().split->trigger();
    seeModal(QStringLiteral("split"));
    page.actions().merge->trigger();
    seeModal(QStringLiteral("merge"));
    // Another program at the same library.
    Q_EMIT page.document().changedOutside();
    stop(*m_window, QStringLiteral("landmarks-changed-outside"));
    Q_EMIT page.document().joined();
    Q_EMIT page.document().overtaken();
    stop(*m_window, QStringLiteral("landmarks-overtaken"));
}

void DeskTour::wizard() {
    make();
    m_window->showPage(Page::Landmarks);
    TrainingPage& page = m_window->trainingPage();
    page.open(m_library);
    if (!await([&] { return page.document().library() != nullptr; }, "the library does not open")) return;
    page.teach();
    QTest::keyClicks(&page.wizard().what().name(), QStringLiteral("Notice"));
    stop(*m_window, QStringLiteral("teach-1"));
    page.wizard().forward().click();
    page.wizard().reel().openFiles(m_photos);
    await([&] { return page.wizard().reel().current() && page.settled(); }, "the photographs do not open");
    page.wizard().views().addButton().click();
    await([&] { return page.session().trained() && page.settled(); }, "the view is not learnt");
    stop(*m_window, QStringLiteral("teach-2"));
    page.wizard().forward().click();
    await([&] { return page.settled(); }, "the trial does not end");
    stop(*m_window, QStringLiteral("teach-3"));
    page.wizard().giveUp().click();
    seeModal(QStringLiteral("question-give-up"));
    page.wizard().forward().click();
    await([&] { return page.wizard().step() == TeachPanel::End; }, "the landmark is not saved");
    stop(*m_window, QStringLiteral("teach-4"));
}

/// What the window asks by itself.
void DeskTour::windowsOwnDialogs() {
    make();
    MapPage& page = m_window->mapPage();
    m_window->showPage(Page::Map);
    page.open(m_map);
    if (!await([&] { return page.settled() && page.document().building() != nullptr; },
               "the map does not open"))
        return;
    page.plan().view().select(MapHit{MapHit::What::Landmark, 0}, true);
    page.actions().remove->trigger();
    page.whenSaved([] {});
    seeModal(QStringLiteral("question-unsaved"));
    Q_EMIT page.document().overtaken(m_map);
    seeModal(QStringLiteral("question-overtaken"));
    m_window->showPage(Page::Walk);
    m_window->actions().sayThis->trigger();
    seeModal(QStringLiteral("say-this"));
    for (QAction* action : m_window->findChild<ProfileMenu*>()->actions())
        if (!action->isCheckable() && !action->isSeparator() && action->isEnabled()) {
            action->trigger();
            break;
        }
    seeModal(QStringLiteral("new-user"));
    m_window->welcome();
    seeModal(QStringLiteral("welcome"));
}

void DeskTour::dialogs() {
    make();
    recognition::LandmarkLibrary library;
    recognition::test::trainPoster(library, 1);
    const auto building = handMadeBuilding();
    const int pages = SettingsDialog(*m_settings).findChild<QTabWidget*>()->count();
    for (int page = 0; page < pages; ++page) {
        auto dialog = std::make_unique<SettingsDialog>(*m_settings);
        dialog->findChild<QTabWidget*>()->setCurrentIndex(page);
        see(std::move(dialog), QStringLiteral("settings-%1").arg(page + 1));
    }
    see(std::make_unique<SourceDialog>(WalkSource{QStringLiteral("camera:0"), 0.0}),
        QStringLiteral("pictures"));
    see(std::make_unique<SourceDialog>(WalkSource{m_folder.path(), 4.0}), QStringLiteral("pictures-folder"));
    const std::vector<QWidget*> pictured{&m_window->page(), &m_window->mapPage(), &m_window->trainingPage()};
    const int chapters = HelpDialog(pictured).chapters().count();
    for (int chapter = 0; chapter < chapters; ++chapter) {
        auto dialog = std::make_unique<HelpDialog>(pictured);
        dialog->chapters().setCurrentRow(chapter);
        see(std::move(dialog), QStringLiteral("help-%1").arg(chapter + 1));
    }
    const std::vector<Chart> charts{Figures::votes(m_window->page().timeline(), nullptr),
                                    Figures::latency(m_window->page().timeline()), Figures::calibration({}),
                                    Figures::ranges({})};
    see(std::make_unique<FiguresDialog>(charts), QStringLiteral("figures"));
    see(std::make_unique<KeysDialog>(m_window->actions().withKeys()), QStringLiteral("keys"));
    see(std::make_unique<EditTemplateDialog>(library.templates.front()), QStringLiteral("change-template"));
    see(std::make_unique<RevoteDialog>(
            m_folder.path(),
            QList<std::pair<QString, QString>>{{QStringLiteral("voting"), QStringLiteral("Voting")}}),
        QStringLiteral("work-out-anew"));
    building::BuildingData apart = house();
    apart.accesses[1].closed = true;
    apart.accesses[3].oneWay = building::OneWay::AToB;
    auto missing = std::make_unique<MissingDialog>(std::make_shared<const building::Building>(apart),
                                                   routing::RouteOptions());
    await([&] { return missing->done(); }, "the report of missing routes does not come");
    see(std::move(missing), QStringLiteral("missing-routes"));
    see(std::make_unique<ImportDialog>(m_folder.path()), QStringLiteral("import"));
    see(std::make_unique<RegionDialog>(building->regions().front()), QStringLiteral("change-region"));
    see(std::make_unique<AccessDialog>(building, building->accesses().front()),
        QStringLiteral("change-door"));
    see(std::make_unique<LandmarkDialog>(building, building->landmarks().front()),
        QStringLiteral("change-landmark"));
}

void DeskTour::kiosk() {
    KioskStart start;
    start.map = m_map;
    start.source = QStringLiteral("grey");
    start.memoryFile = file("kiosk.json");
    QFile::remove(start.memoryFile);
    Kiosk kiosk(*m_settings, start, lastingSource, fakeVoice, std::make_unique<NoChimes>());
    KioskPage page(kiosk);
    page.resize(1280, 800);
    page.show();
    kiosk.begin();
    await([&] { return kiosk.walk().building() != nullptr; }, "the kiosk's map does not open");
    // The words on the screen come by themselves after each key.
    const auto press = [&](Qt::Key key, const char* name, const QString& letters = {}) {
        if (!m_wrong.isEmpty()) return;
        QSignalSpy spoken(&kiosk, &Kiosk::spoken);
        if (letters.isEmpty())
            QTest::keyClick(&page, key);
        else
            QTest::keyClicks(&page, letters);
        if (!await([&] { return !spoken.isEmpty(); }, name)) return;
        if (name[0] != '\0') stop(page, QLatin1String("kiosk-") + QLatin1String(name));
    };
    stop(page, QStringLiteral("kiosk-begin"));
    press(Qt::Key_Down, "place");
    press(Qt::Key_Right, "category");
    press(Qt::Key_F1, "keys");
    press(Qt::Key_F1, "number-pad");
    press(Qt::Key_Escape, "");
    press(Qt::Key_V, "setting");
    press(Qt::Key_F, "search");
    press(Qt::Key_unknown, "typing", QStringLiteral("lib"));
    press(Qt::Key_Return, "found");
    press(Qt::Key_Return, "preview");
    await([&] { return kiosk.walk().snapshot() != nullptr; }, "the kiosk's camera gives nothing");
    press(Qt::Key_L, "instructions");
    press(Qt::Key_Return, "walking");
    press(Qt::Key_W, "where-am-i");
    press(Qt::Key_S, "look-around");
    press(Qt::Key_Escape, "stop-question");
    press(Qt::Key_Down, "");
    press(Qt::Key_F4, "two-keys");
    press(Qt::Key_F4, "");
    guidance::Cue arrived;
    arrived.kind = guidance::CueKind::Arrived;
    arrived.regionName = "Library";
    arrived.validUntil = 1e9;
    QSignalSpy told(&kiosk, &Kiosk::spoken);
    Q_EMIT kiosk.walk().cueCame(arrived);
    await([&] { return !told.isEmpty(); }, "the arrival is not told");
    stop(page, QStringLiteral("kiosk-arrived"));
    press(Qt::Key_Return, "");
    press(Qt::Key_Escape, "leave-question");
    page.close();
}

} // namespace farol::ui::test
