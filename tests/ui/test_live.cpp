// The live page shows what a snapshot holds, in words too, and choosing a place works from the keyboard.

#include "tests/ui/hand_made.h"
#include "ui/convert/kind_style.h"
#include "ui/live/frame_panel.h"
#include "ui/live/instruction_panel.h"
#include "ui/live/live_page.h"
#include "ui/live/map_panel.h"
#include "ui/parts/banner.h"
#include "ui/parts/place_chooser.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QCompleter>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace farol::ui {

class LiveTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void aSnapshotIsShownInWords();
    void anEmptyPageSaysWhatToDo();
    void theSpokenZoneIsMarkedForAWhile();
    void theMapFollowsTheFloorUnlessToldNotTo();
    void typingOneNameAndReturnChooses();
    void severalNamesAreNotGuessed();
    void anUnknownNameIsTold();
    void clearingGivesTheDestinationUp();
    void aFailingVoiceIsVisible();
    void anOldSentenceDoesNotLookLikeAnOrder();
    void everyLabelIsReadable_data();
    void everyLabelIsReadable();
    void aBannerIsReplacedAndClosed();
    void thePictureIsLetterboxed();

private:
    PlaceChooser& chooser() { return m_page->destination(); }

    QTemporaryDir m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<Walk> m_walk;
    std::unique_ptr<SpeechDesk> m_speech;
    std::unique_ptr<LivePage> m_page;
};

void LiveTest::init() {
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("settings.ini")));
    m_walk = std::make_unique<Walk>();
    m_speech = std::make_unique<SpeechDesk>(
        *m_settings, [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(false); });
    m_page = std::make_unique<LivePage>(*m_walk, *m_speech, *m_settings);
    m_page->resize(1200, 760);
}

void LiveTest::cleanup() {
    m_page.reset();
    m_speech.reset();
    m_walk.reset();
    m_settings.reset();
}

void LiveTest::aSnapshotIsShownInWords() {
    m_page->setBuilding(test::handMadeBuilding());
    QSignalSpy frames(m_page.get(), &LivePage::frameShown);
    m_page->show(test::handMadeSnapshot());
    QCOMPARE(frames.count(), 1);
    const QString where = m_page->mapPanel().whereText();
    QVERIFY(where.contains(QLatin1String("Main corridor")));
    QCOMPARE(m_page->mapPanel().view().accessibleDescription(), where);
    const QString facts = m_page->framePanel().facts();
    QVERIFY(facts.contains(QLatin1String("7"))); // the seventh picture
    QVERIFY(facts.contains(QLatin1String("1:02.5")));
    QVERIFY(facts.contains(QLatin1String("85")));
    QVERIFY(m_page->framePanel().view().accessibleDescription().contains(Phrasebook::kindWord(Kind::Door)));
    QVERIFY(m_page->instruction().way().contains(QLatin1String("Library")));
    QVERIFY(m_page->instruction().way().contains(QLatin1String("19")));
    QCOMPARE(m_page->mapPanel().view().overlay().heatOf(RegionId("c")), 1.0);
    QVERIFY(m_page->mapPanel().view().overlay().route != nullptr);
    QVERIFY(!m_page->grab().isNull());
}

void LiveTest::anEmptyPageSaysWhatToDo() {
    QVERIFY(!m_page->instruction().sentence().isEmpty());
    QVERIFY(!m_page->mapPanel().whereText().isEmpty());
    QVERIFY(!m_page->framePanel().view().accessibleDescription().isEmpty());
    QVERIFY(!chooser().isEnabled());                    // there is nothing to choose from
    auto empty = std::make_shared<session::Snapshot>(); // news before the first picture
    m_page->show(empty);
    QCOMPARE(m_page->framesShown(), 0);
    QVERIFY(!m_page->grab().isNull());
}

void LiveTest::theSpokenZoneIsMarkedForAWhile() {
    m_page->setBuilding(test::handMadeBuilding());
    guidance::Cue cue;
    cue.kind = guidance::CueKind::Detection;
    cue.priority = guidance::CuePriority::Detection;
    cue.id = 1;
    cue.time = 62.0;
    cue.validUntil = 70.0;
    cue.objectKind = Kind::Extinguisher;
    cue.zone = {Column::Left, Row::Down};
    m_speech->setNow(62.0, RegionId("c"), 0);
    m_speech->add(cue);
    QTRY_VERIFY(m_page->framePanel().view().spokenZone().has_value());
    QCOMPARE(*m_page->framePanel().view().spokenZone(), (Zone{Column::Left, Row::Down}));
    QTRY_COMPARE(m_page->utterances().rowCount(), 1);
    m_page->show(test::handMadeSnapshot()); // 62.5 s: still marked
    QVERIFY(m_page->framePanel().view().spokenZone().has_value());
    auto later = std::make_shared<session::Snapshot>(*test::handMadeSnapshot());
    later->step.percept.time = 80.0;
    m_page->show(later);
    QVERIFY(!m_page->framePanel().view().spokenZone().has_value());
}

void LiveTest::theMapFollowsTheFloorUnlessToldNotTo() {
    m_page->setBuilding(test::handMadeBuilding());
    auto upstairs = std::make_shared<session::Snapshot>(*test::handMadeSnapshot());
    upstairs->step.fix.region = RegionId("lib");
    upstairs->step.fix.level = 1.0;
    m_page->show(upstairs);
    QCOMPARE(m_page->mapPanel().view().level(), 1.0);
    m_page->mapPanel().setFollow(false);
    m_page->show(test::handMadeSnapshot());
    QCOMPARE(m_page->mapPanel().view().level(), 1.0);
    QVERIFY(!m_settings->followLevel());
    m_page->mapPanel().setFollow(true);
    QCOMPARE(m_page->mapPanel().view().level(), 0.0);
}

void LiveTest::typingOneNameAndReturnChooses() {
    m_page->setBuilding(test::handMadeBuilding());
    QSignalSpy chosen(&chooser(), &PlaceChooser::placeChosen);
    QTest::keyClicks(&chooser().edit(), QStringLiteral("cafe"));
    QTest::keyClick(&chooser().edit(), Qt::Key_Return);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chooser().chosen(), RegionId("r2"));
    QVERIFY(chooser().edit().text().startsWith(QStringLiteral("Café")));
    QCOMPARE(m_walk->destination(), RegionId("r2"));
    QTest::keyClick(&chooser().edit(), Qt::Key_Return); // again: nothing new
    QCOMPARE(chosen.count(), 1);
}

void LiveTest::severalNamesAreNotGuessed() {
    m_page->setBuilding(test::handMadeBuilding());
    QTest::keyClicks(&chooser().edit(), QStringLiteral("stairs"));
    chooser().edit().completer()->popup()->hide();
    QTest::keyClick(&chooser().edit(), Qt::Key_Return);
    QVERIFY(!chooser().chosen());
    QVERIFY(chooser().hint().contains(QLatin1Char('2')));
    chooser().edit().completer()->popup()->hide();
}

void LiveTest::anUnknownNameIsTold() {
    m_page->setBuilding(test::handMadeBuilding());
    QTest::keyClicks(&chooser().edit(), QStringLiteral("swimming pool"));
    QVERIFY(!chooser().hint().isEmpty());
    QTest::keyClick(&chooser().edit(), Qt::Key_Return);
    QVERIFY(!chooser().chosen());
    QTest::keyClick(&chooser().edit(), Qt::Key_Escape);
    QVERIFY(chooser().edit().text().isEmpty());
    QVERIFY(chooser().hint().isEmpty());
}

void LiveTest::clearingGivesTheDestinationUp() {
    m_page->setBuilding(test::handMadeBuilding());
    m_walk->setDestination(RegionId("lib"));
    QVERIFY(chooser().edit().text().startsWith(QLatin1String("Library")));
    chooser().edit().selectAll();
    QTest::keyClick(&chooser().edit(), Qt::Key_Delete);
    QVERIFY(!m_walk->destination());
    QVERIFY(!m_page->mapPanel().view().overlay().destination);
}

void LiveTest::aFailingVoiceIsVisible() {
    m_page->setBuilding(test::handMadeBuilding());
    guidance::Cue cue;
    cue.kind = guidance::CueKind::Unsure;
    cue.priority = guidance::CuePriority::OffRoute;
    cue.id = 1;
    cue.validUntil = 100.0;
    m_speech->add(cue);
    QTRY_VERIFY(m_speech->trouble());
    QVERIFY(m_page->instruction().voiceText().contains(QLatin1String("hoarse")));
    QTRY_COMPARE(m_page->utterances().rowCount(), 1);
    QTRY_COMPARE(m_page->utterances().at(0).state, UtteranceState::Shown);
    QCOMPARE(m_page->instruction().sentence(),
             m_page->utterances().at(0).text); // never silence without a word
}

void LiveTest::anOldSentenceDoesNotLookLikeAnOrder() {
    m_page->setBuilding(test::handMadeBuilding());
    Utterance utterance;
    utterance.cue.kind = guidance::CueKind::Act;
    utterance.cue.time = 60.0;
    utterance.cue.validUntil = 63.0;
    utterance.text = QStringLiteral("Turn left.");
    utterance.state = UtteranceState::Shown;
    m_page->instruction().note(utterance);
    m_page->show(test::handMadeSnapshot()); // 62.5 s
    QVERIFY(!m_page->instruction().way().contains(QLatin1String("1:00.0")));
    auto later = std::make_shared<session::Snapshot>(*test::handMadeSnapshot());
    later->step.percept.time = 64.0;
    m_page->show(later);
    QVERIFY(m_page->instruction().way().contains(QLatin1String("1:00.0"))); // it tells when that was
    m_page->show(nullptr);
    QVERIFY(!m_page->instruction().sentence().contains(QLatin1String("Turn left")));
}

void LiveTest::everyLabelIsReadable_data() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void LiveTest::everyLabelIsReadable() {
    QFETCH(bool, dark);
    const QPalette before = QApplication::palette();
    QPalette palette = before;
    if (dark) {
        palette = QPalette(QColor(0x2b2f36));
        palette.setColor(QPalette::Base, QColor(0x1e2126));
        palette.setColor(QPalette::AlternateBase, QColor(0x262a30));
        for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
            palette.setColor(role, QColor(0xf0f2f5));
    }
    QApplication::setPalette(palette);
    m_page->ensurePolished();
    m_page->setBuilding(test::handMadeBuilding());
    m_page->show(test::handMadeSnapshot());
    m_page->instruction().setVoice(QStringLiteral("broken"), true);
    for (const BannerKind kind : {BannerKind::Note, BannerKind::Warning, BannerKind::Problem})
        m_page->banners().show(QString::number(static_cast<int>(kind)),
                               {kind, QStringLiteral("Something is to be told."), {}, {}, true});
    m_page->QWidget::show(); // palettes reach a window when it is shown
    QCoreApplication::processEvents();
    for (const QLabel* label : m_page->findChildren<QLabel*>()) {
        if (!label->isVisibleTo(m_page.get()) || !label->isEnabled()) continue;
        const auto* banner = qobject_cast<const Banner*>(label->parentWidget());
        const QColor back =
            banner ? banner->palette().color(QPalette::Window) : palette.color(QPalette::Window);
        const double ratio = contrast(label->palette().color(QPalette::Active, QPalette::WindowText), back);
        QVERIFY2(ratio >= 4.5, qPrintable(QStringLiteral("%1: %2").arg(label->text()).arg(ratio)));
    }
    if (qEnvironmentVariableIsSet("FAROL_SHOTS"))
        m_page->grab().save(qEnvironmentVariable("FAROL_SHOTS") +
                            (dark ? QStringLiteral("/dark.png") : QStringLiteral("/light.png")));
    QApplication::setPalette(before);
}

void LiveTest::aBannerIsReplacedAndClosed() {
    BannerStack& banners = m_page->banners();
    int acted = 0;
    banners.show(QStringLiteral("x"), {BannerKind::Problem, QStringLiteral("one"), {}, {}, true});
    banners.show(QStringLiteral("x"),
                 {BannerKind::Problem, QStringLiteral("two"), QStringLiteral("Act"), [&] { ++acted; }, true});
    QCOMPARE(banners.text(QStringLiteral("x")), QStringLiteral("two"));
    auto* banner = banners.findChild<Banner*>();
    banner->findChild<QPushButton*>()->click();
    QCOMPARE(acted, 1);
    banners.hide(QStringLiteral("x"));
    banners.hide(QStringLiteral("x"));
    QVERIFY(!banners.shows(QStringLiteral("x")));
}

void LiveTest::thePictureIsLetterboxed() {
    FrameView view;
    view.resize(400, 400);
    QVERIFY(view.pictureRect().isEmpty());
    view.setFrame(QImage(320, 240, QImage::Format_RGB32));
    QCOMPARE(view.pictureRect(), QRectF(0, 50, 400, 300));
    view.resize(800, 240);
    QCOMPARE(view.pictureRect(), QRectF(240, 0, 320, 240));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::LiveTest)
#include "test_live.moc"
