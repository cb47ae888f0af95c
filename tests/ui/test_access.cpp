// For who uses a screen reader or the keyboard alone: on every page and in every dialog each control has a
// name and a role, and Tab comes to each of them and round again. The list is printed. Where FAROL_SHOTS
// names a folder, every page is also saved as a picture, at two sizes, light and dark, to be looked at.

#include "core/building/geopackage.h"
#include "tests/recognition/drawn_pictures.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/convert/palettes.h"
#include "ui/live/revote_dialog.h"
#include "ui/main_window/figures_dialog.h"
#include "ui/main_window/help_dialog.h"
#include "ui/main_window/keys_dialog.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/settings_dialog.h"
#include "ui/main_window/source_dialog.h"
#include "ui/main_window/welcome_dialog.h"
#include "ui/training/edit_template_dialog.h"
#include "ui/training/library_panel.h"
#include "ui/training/teach_views.h"
#include "ui/training/teach_what.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QMetaEnum>
#include <QPushButton>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>

namespace farol::ui {

namespace {

constexpr int kPatience = 60000;

/// Inner parts of a control that has the name itself.
bool innerPart(const QWidget& widget) {
    for (const QWidget* parent = widget.parentWidget(); parent != nullptr; parent = parent->parentWidget())
        if (qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent))
            return true;
    return false;
}

QList<QWidget*> controls(const QWidget& top) {
    QList<QWidget*> found;
    for (QWidget* widget : top.findChildren<QWidget*>()) {
        const bool shown = widget->isVisibleTo(&top) && widget->isEnabledTo(&top);
        if (shown && widget->focusPolicy() & Qt::TabFocus && !widget->focusProxy() && !innerPart(*widget) &&
            !widget->isWindow())
            found << widget;
    }
    return found;
}

QString roleName(QAccessible::Role role) {
    return QString::fromLatin1(QMetaEnum::fromType<QAccessible::Role>().valueToKey(role));
}

} // namespace

class AccessTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanup();
    void theWalkPage();
    void theMapPage();
    void theLandmarksPage();
    void theWizard();
    void everyDialog();

private:
    void make();
    void look(QWidget& top, const char* name);
    void walkByTab(QWidget& top, const char* name);
    void shots(const char* name);

    QTemporaryDir m_folder;
    QString m_map, m_library, m_photo;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
};

void AccessTest::initTestCase() {
    namespace drawn = recognition::test;
    m_map = m_folder.filePath(QStringLiteral("house.gpkg"));
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(m_map)).ok());
    m_library = m_folder.filePath(QStringLiteral("posters.gpkg"));
    recognition::LandmarkLibrary library;
    for (const std::uint64_t seed : {1U, 2U, 1U}) drawn::trainPoster(library, seed);
    QVERIFY(recognition::saveLibrary(library, toUtf8(m_library)).ok());
    cv::Mat picture = drawn::room(3);
    drawn::hang(picture, drawn::poster(21), quadOf({160, 100, 320, 240}));
    m_photo = m_folder.filePath(QStringLiteral("photo.jpg"));
    QFile file(m_photo);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(drawn::jpeg(picture)));
}

void AccessTest::make() {
    m_window.reset();
    QDir(m_folder.filePath(QStringLiteral("teaching"))).removeRecursively();
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("settings.ini")));
    m_settings->setLanguage(qEnvironmentVariable("FAROL_SHOTS_LANGUAGE", QStringLiteral("en")));
    MainWindow::applyLanguage(*m_settings);
    MainWindow::applyLook(*m_settings);
    const auto open = [](const std::string&,
                         const capture::SourceOptions&) -> Result<std::unique_ptr<capture::FrameSource>> {
        return std::unique_ptr<capture::FrameSource>(std::make_unique<test::FakeSource>(3, 0.3));
    };
    m_window = std::make_unique<MainWindow>(
        *m_settings, open, [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(); });
    m_window->resize(1280, 800);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void AccessTest::cleanup() {
    m_window.reset();
    m_settings.reset();
    QApplication::setPalette(QPalette());
}

/// Names and roles, as a screen reader gets them.
void AccessTest::look(QWidget& top, const char* name) {
    const QList<QWidget*> all = controls(top);
    QVERIFY2(!all.isEmpty(), name);
    for (QWidget* widget : all) {
        QAccessibleInterface* access = QAccessible::queryAccessibleInterface(widget);
        QVERIFY(access);
        // A list that opens reports its choice as its text; the name that was given stands on the widget.
        QString text = access->text(QAccessible::Name);
        if (qobject_cast<QComboBox*>(widget)) text = widget->accessibleName();
        const QString line =
            QStringLiteral("%1 | %2 | %3").arg(QLatin1String(name), roleName(access->role()), text);
        std::printf("%s\n", qPrintable(line));
        QVERIFY2(!text.trimmed().isEmpty(),
                 qPrintable(line + QLatin1Char(' ') + QLatin1String(widget->metaObject()->className())));
        QVERIFY2(access->role() != QAccessible::NoRole, qPrintable(line));
    }
}

/// Tab comes to every control and back to the first; nothing holds it.
void AccessTest::walkByTab(QWidget& top, const char* name) {
    top.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&top));
    const QList<QWidget*> all = controls(top);
    QWidget* first = all.first();
    first->setFocus(Qt::TabFocusReason);
    QSet<QWidget*> visited;
    for (int i = 0; i < all.size() + 20; ++i) {
        QWidget* focus = QApplication::focusWidget();
        QVERIFY2(focus, name);
        if (i > 0 && focus == first) break;
        QVERIFY2(!visited.contains(focus),
                 qPrintable(QStringLiteral("%1: Tab comes to %2 twice")
                                .arg(QLatin1String(name), focus->accessibleName())));
        visited << focus;
        QTest::keyClick(focus, Qt::Key_Tab);
    }
    QVERIFY2(QApplication::focusWidget() == first, name);
    for (QWidget* widget : all) {
        // One button of a group has the focus for all; the arrows go between them.
        const auto* button = qobject_cast<QAbstractButton*>(widget);
        if (button && button->autoExclusive() && button->isCheckable() && !button->isChecked()) continue;
        QVERIFY2(visited.contains(widget),
                 qPrintable(QStringLiteral("%1: Tab never comes to %2 (%3)")
                                .arg(QLatin1String(name), widget->accessibleName(),
                                     QLatin1String(widget->metaObject()->className()))));
    }
    // And back again, at least one step.
    QTest::keyClick(first, Qt::Key_Backtab);
    QVERIFY2(QApplication::focusWidget() != first, name);
}

void AccessTest::shots(const char* name) {
    const QString folder = qEnvironmentVariable("FAROL_SHOTS");
    if (folder.isEmpty()) return;
    for (const bool dark : {false, true})
        for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
            QApplication::setPalette(dark ? darkPalette() : lightPalette());
            m_window->resize(size);
            QApplication::processEvents();
            const QString file = QStringLiteral("%1-%2%3.png")
                                     .arg(QLatin1String(name))
                                     .arg(size.width())
                                     .arg(dark ? QStringLiteral("-dark") : QString());
            m_window->grab().save(QDir(folder).filePath(file));
        }
    m_window->resize(1280, 800);
    QApplication::setPalette(QPalette());
}

void AccessTest::theWalkPage() {
    make();
    StartOptions options;
    options.map = m_map;
    options.source = QStringLiteral("grey");
    options.to = QStringLiteral("Library");
    options.play = true;
    m_window->begin(options);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Ended, kPatience);
    m_window->page().show(test::handMadeSnapshot());
    look(*m_window, "walk");
    walkByTab(*m_window, "walk");
    shots("walk");
}

void AccessTest::theMapPage() {
    make();
    StartOptions options;
    options.edit = m_map;
    m_window->begin(options);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->mapPage().settled() && m_window->mapPage().document().building(),
                             kPatience);
    look(*m_window, "map");
    walkByTab(*m_window, "map");
    shots("map");
}

void AccessTest::theLandmarksPage() {
    make();
    QTest::keyClick(m_window.get(), Qt::Key_3, Qt::ControlModifier);
    QCOMPARE(m_window->shownPage(), Page::Landmarks);
    look(*m_window, "landmarks, empty");
    TrainingPage& page = m_window->trainingPage();
    page.open(m_library);
    QTRY_VERIFY_WITH_TIMEOUT(page.document().library(), kPatience);
    look(*m_window, "landmarks");
    walkByTab(*m_window, "landmarks");
    shots("landmarks");
    page.panel().showReport();
    page.panel().check();
    QTRY_VERIFY_WITH_TIMEOUT(page.panel().confusion().rowCount() > 0, kPatience);
    look(*m_window, "report");
    walkByTab(*m_window, "report");
    shots("report");
}

void AccessTest::theWizard() {
    make();
    m_window->showPage(Page::Landmarks);
    TrainingPage& page = m_window->trainingPage();
    page.open(m_library);
    QTRY_VERIFY_WITH_TIMEOUT(page.document().library(), kPatience);
    page.teach();
    QTest::keyClicks(&page.wizard().what().name(), QStringLiteral("Notice"));
    look(*m_window, "teach, what it is");
    walkByTab(*m_window, "teach, what it is");
    shots("teach-1");
    page.wizard().forward().click();
    page.wizard().reel().openFiles({m_photo});
    QTRY_VERIFY_WITH_TIMEOUT(page.wizard().reel().current() && page.settled(), kPatience);
    page.wizard().views().addButton().click();
    QTRY_VERIFY_WITH_TIMEOUT(page.session().trained() && page.settled(), kPatience);
    look(*m_window, "teach, views");
    walkByTab(*m_window, "teach, views");
    shots("teach-2");
    page.wizard().forward().click();
    QTRY_VERIFY_WITH_TIMEOUT(page.settled(), kPatience);
    look(*m_window, "teach, trial");
    walkByTab(*m_window, "teach, trial");
    shots("teach-3");
    page.wizard().forward().click();
    QTRY_COMPARE_WITH_TIMEOUT(page.wizard().step(), TeachPanel::End, kPatience);
    look(*m_window, "teach, map");
    walkByTab(*m_window, "teach, map");
    shots("teach-4");
}

void AccessTest::everyDialog() {
    make();
    recognition::LandmarkLibrary library;
    recognition::test::trainPoster(library, 1);
    const auto check = [this](QDialog* made, const char* name) {
        const std::unique_ptr<QDialog> dialog(made);
        dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog.get()));
        look(*dialog, name);
        walkByTab(*dialog, name);
        const QString folder = qEnvironmentVariable("FAROL_SHOTS");
        if (!folder.isEmpty())
            dialog->grab().save(QDir(folder).filePath(QLatin1String(name) + QStringLiteral(".png")));
    };
    auto* settings = new SettingsDialog(*m_settings);
    const int pages = settings->findChild<QTabWidget*>()->count();
    delete settings;
    for (int page = 0; page < pages; ++page) {
        auto* dialog = new SettingsDialog(*m_settings);
        dialog->findChild<QTabWidget*>()->setCurrentIndex(page);
        check(dialog, qPrintable(QStringLiteral("settings %1").arg(page + 1)));
    }
    check(new SourceDialog({QStringLiteral("camera:0"), 0.0}), "pictures");
    check(new WelcomeDialog(*m_settings), "welcome");
    check(new HelpDialog, "help");
    check(new FiguresDialog({Figures::votes(m_window->page().timeline(), nullptr)}), "figures");
    check(new KeysDialog(m_window->actions().withKeys()), "keys");
    check(new EditTemplateDialog(library.templates.front()), "change landmark");
    check(new RevoteDialog(m_folder.path(), {{QStringLiteral("voting"), QStringLiteral("Voting")}}),
          "work out anew");
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::AccessTest)
#include "test_access.moc"
