// What the user chose survives a restart; what a file holds that makes no sense does not matter.

#include "ui/settings/option_fields.h"
#include "ui/settings/settings.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace farol::ui {

class SettingsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void freshSettingsAreUsable();
    void choicesSurviveARestart();
    void nonsenseFallsBack();
    void recentItemsAreNewestFirstAndOnce();
    void onlyChangesAreTold();
    void optionsAreKeptAndStayInTheirLimits();
    void everyUserHasSettingsOfTheirOwn();

private:
    QTemporaryDir m_folder;
    QString file(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
};

void SettingsTest::freshSettingsAreUsable() {
    const Settings settings(file("fresh.ini"));
    QCOMPARE(settings.language(), QString());
    QCOMPARE(settings.directionStyle(), DirectionStyle::LeftRight);
    QCOMPARE(settings.verbosity(), guidance::Verbosity::Objects);
    QVERIFY(!settings.muted());
    QVERIFY(settings.followLevel());
    QVERIFY(settings.showGrid());
    QCOMPARE(settings.speed(), 1.0);
    QVERIFY(!settings.recordingFolder().isEmpty());
    QVERIFY(settings.recent(RecentKind::Map).isEmpty());
}

void SettingsTest::choicesSurviveARestart() {
    {
        Settings settings(file("kept.ini"));
        settings.setLanguage(QStringLiteral("pt"));
        settings.setVoice({QStringLiteral("flite"), QStringLiteral("slt"), QString(), -0.5, 0.25});
        settings.setMuted(true);
        settings.setDirectionStyle(DirectionStyle::Clock);
        settings.setVerbosity(guidance::Verbosity::Directions);
        settings.setFollowLevel(false);
        settings.setSpeed(2.0);
        settings.addRecent(RecentKind::Source, QStringLiteral("camera:1"));
    }
    const Settings again(file("kept.ini"));
    QCOMPARE(again.language(), QStringLiteral("pt"));
    QCOMPARE(again.voice().engine, QStringLiteral("flite"));
    QCOMPARE(again.voice().voice, QStringLiteral("slt"));
    QCOMPARE(again.voice().rate, -0.5);
    QCOMPARE(again.voice().volume, 0.25);
    QCOMPARE(again.voice().language, QStringLiteral("pt"));
    QVERIFY(again.muted());
    QCOMPARE(again.directionStyle(), DirectionStyle::Clock);
    QCOMPARE(again.verbosity(), guidance::Verbosity::Directions);
    QVERIFY(!again.followLevel());
    QCOMPARE(again.speed(), 2.0);
    QCOMPARE(again.recent(RecentKind::Source), QStringList{QStringLiteral("camera:1")});
}

void SettingsTest::nonsenseFallsBack() {
    {
        QSettings raw(file("broken.ini"), QSettings::IniFormat);
        raw.setValue(QStringLiteral("words/language"), QStringLiteral("klingon"));
        raw.setValue(QStringLiteral("words/direction-style"), QStringLiteral("sideways"));
        raw.setValue(QStringLiteral("words/verbosity"), 17);
        raw.setValue(QStringLiteral("voice/rate"), QStringLiteral("nan"));
        raw.setValue(QStringLiteral("voice/volume"), 900);
        raw.setValue(QStringLiteral("walk/speed"), -3);
    }
    const Settings settings(file("broken.ini"));
    QCOMPARE(settings.language(), QString());
    QCOMPARE(settings.directionStyle(), DirectionStyle::LeftRight);
    QCOMPARE(settings.verbosity(), guidance::Verbosity::Objects);
    QCOMPARE(settings.voice().rate, 0.0);
    QCOMPARE(settings.voice().volume, 1.0);
    QCOMPARE(settings.speed(), 0.25);
}

void SettingsTest::recentItemsAreNewestFirstAndOnce() {
    Settings settings(file("recent.ini"));
    for (int i = 0; i < 12; ++i) settings.addRecent(RecentKind::Map, QString::number(i));
    settings.addRecent(RecentKind::Map, QStringLiteral("7"));
    settings.addRecent(RecentKind::Map, QString());
    const QStringList maps = settings.recent(RecentKind::Map);
    QCOMPARE(maps.size(), 8);
    QCOMPARE(maps.first(), QStringLiteral("7"));
    QCOMPARE(maps.count(QStringLiteral("7")), 1);
    QVERIFY(settings.recent(RecentKind::Library).isEmpty());
    settings.clearRecent(RecentKind::Map);
    QVERIFY(settings.recent(RecentKind::Map).isEmpty());
}

void SettingsTest::onlyChangesAreTold() {
    Settings settings(file("told.ini"));
    QSignalSpy muted(&settings, &Settings::mutedChanged);
    QSignalSpy language(&settings, &Settings::languageChanged);
    settings.setMuted(true);
    settings.setMuted(true);
    settings.setLanguage(QStringLiteral("en"));
    settings.setLanguage(QStringLiteral("en"));
    QCOMPARE(muted.count(), 1);
    QCOMPARE(language.count(), 1);
}

void SettingsTest::optionsAreKeptAndStayInTheirLimits() {
    const QString name = file("options.ini");
    {
        Settings settings(name);
        QCOMPARE(settings.guidanceOptions({}).prepareDistanceM, guidance::GuidanceOptions().prepareDistanceM);
        settings.setOption(QStringLiteral("prepare-distance"), 9.5);
        settings.setOption(QStringLiteral("avoid-stairs"), 1.0);
        settings.setOption(QStringLiteral("object-points"), 12.0);
        settings.setOption(QStringLiteral("walking-speed"), 1e9);
    }
    Settings again(name);
    QCOMPARE(again.guidanceOptions({}).prepareDistanceM, 9.5);
    QCOMPARE(again.guidanceOptions({}).actDistanceM, guidance::GuidanceOptions().actDistanceM);
    QVERIFY(again.routeOptions({}).avoidStairs);
    QVERIFY(!again.routeOptions({}).avoidElevator);
    QCOMPARE(again.recogniserOptions({}).minInliers, 12);
    QCOMPARE(again.routeOptions({}).walkingSpeed, 2.0);
    again.setOption(QStringLiteral("avoid-stairs"), std::nullopt);
    QVERIFY(!again.routeOptions({}).avoidStairs);
    // The program's own figures lie inside the limits of the forms, and what the forms allow makes sense.
    const auto within = [](const auto& fields, auto usual) {
        for (const auto& field : fields) {
            if (!field.yesOrNo() && (field.in(usual) < field.low || field.in(usual) > field.high))
                return false;
            for (const double value : {field.low, field.high}) {
                auto options = usual;
                field.put(options, value);
                if (!options.check()) return false;
            }
        }
        return true;
    };
    QVERIFY(within(guidanceFields(), guidance::GuidanceOptions()));
    QVERIFY(within(routeFields(), routing::RouteOptions()));
    QVERIFY(within(recogniserFields(), recognition::RecogniserOptions()));
}

void SettingsTest::everyUserHasSettingsOfTheirOwn() {
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("users.ini"));
    {
        Settings settings(name);
        settings.setUnit(DistanceUnit::Steps);
        QSignalSpy told(&settings, &Settings::guidanceChanged);
        QVERIFY(settings.useProfile(QStringLiteral("Ana")));
        QCOMPARE(told.count(), 1);
        QCOMPARE(settings.unit(), DistanceUnit::Steps); // begins as they were
        settings.setUnit(DistanceUnit::Feet);
        QVERIFY(settings.useProfile(QString()));
        QCOMPARE(settings.unit(), DistanceUnit::Steps);
        QVERIFY(settings.useProfile(QStringLiteral("Ana")));
        QVERIFY(!settings.useProfile(QStringLiteral("../ana")));
        QVERIFY(!settings.useProfile(QStringLiteral(".hidden")));
    }
    const Settings again(name);
    QCOMPARE(again.profile(), QStringLiteral("Ana"));
    QCOMPARE(again.unit(), DistanceUnit::Feet);
    QCOMPARE(again.profiles(), (QStringList{QString(), QStringLiteral("Ana")}));
}

} // namespace farol::ui

QTEST_GUILESS_MAIN(farol::ui::SettingsTest)
#include "test_settings.moc"
