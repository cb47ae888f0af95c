// The kiosk's page alone: what the window system's events mean, and how its lines break.

#include "tests/ui/hand_made.h"
#include "ui/kiosk/kiosk_page.h"
#include "ui/speech/phrasebook.h"

#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QVariantAnimation>

namespace farol::ui {

namespace {

class NoChimes : public Chimes {
public:
    void play(Sound /*sound*/) override {}
};

} // namespace

class KioskPageTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void aHeldKeyIsNoSecondPress();
    void whoeverHoldsOnLeaves();
    void anotherKeyEndsTheHold();
    void aKeyAndItsWordStayTogether();
    void noLineIsCutThrough();

private:
    void send(QEvent::Type type, quint64 at, int key = Qt::Key_Escape);
    KioskState state() { return m_kiosk->machine().state(); }

    QTemporaryDir m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<Kiosk> m_kiosk;
    std::unique_ptr<KioskPage> m_page;
};

void KioskPageTest::init() {
    installTranslation(QStringLiteral("en"));
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("page.ini")));
    m_kiosk = std::make_unique<Kiosk>(
        *m_settings, KioskStart(), Walk::OpenSource(),
        [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(); }, std::make_unique<NoChimes>());
    m_page = std::make_unique<KioskPage>(*m_kiosk);
    m_page->resize(1280, 800);
    m_page->show();
    m_kiosk->begin();
}

void KioskPageTest::cleanup() {
    m_page.reset();
    m_kiosk.reset();
    m_settings.reset();
}

void KioskPageTest::send(QEvent::Type type, quint64 at, int key) {
    QKeyEvent event(type, key, Qt::NoModifier);
    event.setTimestamp(at);
    QApplication::sendEvent(m_page.get(), &event);
}

/// The window system repeats a held key as a release and a press of the same moment.
void KioskPageTest::aHeldKeyIsNoSecondPress() {
    send(QEvent::KeyPress, 1000);
    for (quint64 at = 1660; at < 2400; at += 40) {
        send(QEvent::KeyRelease, at);
        send(QEvent::KeyPress, at);
        QCOMPARE(state(), KioskState::LeaveQuestion);
    }
    send(QEvent::KeyRelease, 2410);
    send(QEvent::KeyPress, 2600); // a finger
    QCOMPARE(state(), KioskState::Leaving);
}

void KioskPageTest::whoeverHoldsOnLeaves() {
    QSignalSpy finished(m_kiosk.get(), &Kiosk::finished);
    send(QEvent::KeyPress, 1000);
    send(QEvent::KeyRelease, 1660);
    send(QEvent::KeyPress, 1660); // the time that was held until now counts
    QCOMPARE(state(), KioskState::LeaveQuestion);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
}

void KioskPageTest::anotherKeyEndsTheHold() {
    m_page->setHoldMs(0);
    send(QEvent::KeyPress, 1000);
    send(QEvent::KeyPress, 1010, Qt::Key_Down);
    QApplication::processEvents();
    QVERIFY(state() != KioskState::Leaving);
}

void KioskPageTest::aKeyAndItsWordStayTogether() {
    for (const Language& language : languages()) {
        m_settings->setLanguage(language.code);
        QTRY_COMPARE(installedLanguage(), language.code);
        send(QEvent::KeyPress, 1000, Qt::Key_F1);
        const auto* hint = m_page->findChild<QLabel*>(QStringLiteral("hint"));
        QVERIFY(hint->text().contains(QLatin1String("F1")));
        for (const QString& entry : hint->text().split(QStringLiteral("   ")))
            QVERIFY2(!entry.contains(QLatin1Char(' ')), qPrintable(entry));
        send(QEvent::KeyRelease, 1100, Qt::Key_F1);
        send(QEvent::KeyPress, 1200, Qt::Key_Escape);
        send(QEvent::KeyRelease, 1300, Qt::Key_Escape);
    }
}

/// All keys at once are more than fits: what is shown of it begins and ends between two lines.
void KioskPageTest::noLineIsCutThrough() {
    const auto* area = m_page->findChild<QScrollArea*>(QStringLiteral("area"));
    const auto blank = [](const QImage& picture, int row) {
        for (int x = 0; x < picture.width(); ++x)
            if (picture.pixelColor(x, row) != QColor(Qt::black)) return false;
        return true;
    };
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080), QSize(1366, 768)}) {
        m_page->resize(size);
        send(QEvent::KeyPress, 1000, Qt::Key_F1);
        send(QEvent::KeyRelease, 1100, Qt::Key_F1);
        QApplication::processEvents();
        QScrollBar* bar = area->verticalScrollBar();
        QVERIFY(bar->maximum() > 0 || size.height() == 1080);
        auto* scroll = m_page->findChild<QVariantAnimation*>();
        for (int part = 0; part <= 20; ++part) {
            scroll->setCurrentTime(scroll->duration() * part / 20);
            const QImage seen = area->viewport()->grab().toImage();
            QVERIFY2(blank(seen, 0) && blank(seen, seen.height() - 1),
                     qPrintable(QStringLiteral("%1 px wide, at %2").arg(size.width()).arg(bar->value())));
        }
        if (bar->maximum() > 0) QCOMPARE(bar->value(), bar->maximum());
        send(QEvent::KeyPress, 1200, Qt::Key_Escape);
        send(QEvent::KeyRelease, 1300, Qt::Key_Escape);
    }
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::KioskPageTest)
#include "test_kiosk_page.moc"
