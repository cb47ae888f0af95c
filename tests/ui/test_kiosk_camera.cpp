// A live camera that goes in the middle of a way: what the blind user hears, and what stands on the screen.

#include "core/building/geopackage.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/kiosk/kiosk_page.h"
#include "ui/speech/phrasebook.h"

#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace farol::ui {

namespace {

class CountedWarnings : public Chimes {
public:
    explicit CountedWarnings(int& warnings) : m_warnings(warnings) {}
    void play(Sound sound) override { m_warnings += sound == Sound::Warning ? 1 : 0; }

private:
    int& m_warnings;
};

} // namespace

class KioskCameraTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void anUnpluggedCameraIsToldAndComesBack();
    void aCameraThatGivesUpIsTold();

private:
    void bringOnTheWay();
    void key(int key) { QTest::keyClick(m_page.get(), static_cast<Qt::Key>(key)); }
    bool heard(const char* part) const { return !m_log.filter(QString::fromUtf8(part)).isEmpty(); }

    QTemporaryDir m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<Kiosk> m_kiosk;
    std::unique_ptr<KioskPage> m_page;
    std::shared_ptr<test::Cable> m_cable;
    QStringList m_log;
    int m_warnings = 0;
};

void KioskCameraTest::init() {
    installTranslation(QStringLiteral("en"));
    const QString map = m_folder.filePath(QStringLiteral("house.gpkg"));
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(map)).ok());
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("kiosk.ini")));
    m_settings->setLanguage(QStringLiteral("en"));
    m_cable = std::make_shared<test::Cable>();
    KioskStart start;
    start.map = map;
    start.source = QStringLiteral("cable");
    start.from = QStringLiteral("c");
    start.memoryFile = m_folder.filePath(QStringLiteral("state.json"));
    QFile::remove(start.memoryFile);
    m_kiosk = std::make_unique<Kiosk>(
        *m_settings, start,
        [cable = m_cable](const std::string&, const capture::SourceOptions&) {
            return Result<std::unique_ptr<capture::FrameSource>>(
                std::make_unique<test::CameraOnCable>(cable));
        },
        [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(); },
        std::make_unique<CountedWarnings>(m_warnings));
    connect(m_kiosk.get(), &Kiosk::spoken, this, [this](const QString& text) { m_log << text; });
    m_page = std::make_unique<KioskPage>(*m_kiosk);
    m_page->resize(1280, 800);
    m_page->show();
    m_kiosk->begin();
}

void KioskCameraTest::cleanup() {
    m_page.reset();
    m_kiosk.reset();
    m_settings.reset();
}

void KioskCameraTest::bringOnTheWay() {
    QTRY_VERIFY_WITH_TIMEOUT(m_kiosk->walk().snapshot() != nullptr, 60000);
    QTRY_COMPARE(m_kiosk->machine().state(), KioskState::Choosing);
    for (const Qt::Key each : {Qt::Key_End, Qt::Key_Return, Qt::Key_Return}) key(each);
    QCOMPARE(m_kiosk->machine().state(), KioskState::Walking);
    m_log.clear();
}

void KioskCameraTest::anUnpluggedCameraIsToldAndComesBack() {
    bringOnTheWay();
    const int warnings = m_warnings;
    m_cable->setPlugged(false);
    QTRY_VERIFY_WITH_TIMEOUT(heard("Stop. The camera gives no picture, and I cannot guide you."), 60000);
    QCOMPARE(m_log.filter(QStringLiteral("The camera gives no picture")).size(), 1);
    QVERIFY(m_warnings > warnings);
    auto* detail = m_page->findChild<QLabel*>(QStringLiteral("detail"));
    QVERIFY(detail && detail->isVisible() && detail->text().contains(QLatin1String("no picture")));
    m_log.clear();
    key(Qt::Key_N); // an answer would be of a place seen long ago
    QTRY_VERIFY(heard("Stop. The camera gives no pictures"));
    key(Qt::Key_Return);
    QTRY_VERIFY(heard("I try the camera again"));
    QCOMPARE(m_kiosk->walk().state(), session::RunState::Running);
    m_cable->setPlugged(true);
    QTRY_VERIFY_WITH_TIMEOUT(heard("The camera works again."), 60000);
    QCOMPARE(m_log.filter(QStringLiteral("works again")).size(), 1);
    QVERIFY(!detail->isVisible());
    m_log.clear();
    key(Qt::Key_N);
    QTRY_VERIFY_WITH_TIMEOUT(!m_log.isEmpty(), 60000);
    QVERIFY(!heard("no picture"));
}

void KioskCameraTest::aCameraThatGivesUpIsTold() {
    bringOnTheWay();
    m_cable->pull();
    QTRY_COMPARE_WITH_TIMEOUT(m_kiosk->walk().state(), session::RunState::Failed, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(heard("Stop. The camera gives no picture"), 60000);
    QCOMPARE(m_log.filter(QStringLiteral("no picture")).size(), 1);
    QVERIFY(m_kiosk->detail().contains(QLatin1String("no picture")));
    m_cable->setPlugged(true);
    QSignalSpy began(&m_kiosk->walk(), &Walk::walkBegan);
    key(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(began.count(), 1, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(heard("The camera works again."), 60000);
    QVERIFY(m_kiosk->detail().isEmpty());
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::KioskCameraTest)
#include "test_kiosk_camera.moc"
