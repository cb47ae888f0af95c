// Every sentence that can be spoken, in every language, word for word; and rules that all of them keep.

#include "tests/ui/representative_cues.h"
#include "ui/speech/phrasebook.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

using farol::fromDegrees;
using farol::guidance::Cue;
using farol::guidance::CueKind;
using farol::test::NamedCue;
using farol::test::representativeCues;
using farol::ui::DirectionStyle;
using farol::ui::DistanceUnit;
using farol::ui::installTranslation;
using farol::ui::Phrasebook;

namespace {

/// About twelve seconds.
constexpr qsizetype kMostLetters = 180;

struct Said {
    QString label;
    QString text;
    Cue cue;
};

/// In the other units.
void addMeasured(std::vector<Said>& all, const NamedCue& entry) {
    for (auto [unit, name] : {std::pair(DistanceUnit::Feet, "feet"), {DistanceUnit::Steps, "steps"}}) {
        Phrasebook words;
        words.setUnit(unit);
        all.push_back({entry.label + QStringLiteral(" [%1]").arg(QLatin1String(name)),
                       words.sentence(entry.cue), entry.cue});
    }
}

std::vector<Said> everything() {
    static const QStringList kMeasured{QStringLiteral("start, door"), QStringLiteral("reassure, metres"),
                                       QStringLiteral("third door on the left")};
    std::vector<Said> all;
    for (const NamedCue& entry : representativeCues()) {
        all.push_back({entry.label, Phrasebook(DirectionStyle::LeftRight).sentence(entry.cue), entry.cue});
        if (kMeasured.contains(entry.label)) addMeasured(all, entry);
        if (!entry.styled) continue;
        all.push_back({entry.label + QStringLiteral(" [clock]"),
                       Phrasebook(DirectionStyle::Clock).sentence(entry.cue), entry.cue});
        all.push_back({entry.label + QStringLiteral(" [degrees]"),
                       Phrasebook(DirectionStyle::Degrees).sentence(entry.cue), entry.cue});
    }
    return all;
}

QStringList goldenLines(const QString& language) {
    QFile file(QStringLiteral(FAROL_SOURCE_DIR "/tests/ui/golden/cues_%1.txt").arg(language));
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

} // namespace

class TestPhrasebook : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sentencesAreThoseOnFile_data() { languages(); }
    void sentencesAreThoseOnFile();
    void sentencesKeepTheRules_data() { languages(); }
    void sentencesKeepTheRules();
    void figuresComeFromTheCueOnly_data() { languages(); }
    void figuresComeFromTheCueOnly();
    void othersHoldNoEnglish_data() { languages(); }
    void othersHoldNoEnglish();
    void everyLanguageHasItsOwnWords();
    void namesFromTheMapAreLeftAlone();
    void distancesAreRounded_data();
    void distancesAreRounded();
    void brokenNumbersAreNotSpoken();
    void languagesAreFoundByLocale();

private:
    static void languages() {
        QTest::addColumn<QString>("language");
        for (const farol::ui::Language& each : farol::ui::languages())
            QTest::newRow(qPrintable(each.code)) << each.code;
    }
};

void TestPhrasebook::sentencesAreThoseOnFile() {
    QFETCH(QString, language);
    QVERIFY(installTranslation(language));
    QStringList lines;
    for (const Said& said : everything()) lines << said.label + QStringLiteral(": ") + said.text;
    const QString actualName = QStringLiteral("cues_%1.actual.txt").arg(language);
    const QStringList expected = goldenLines(language);
    if (lines != expected) {
        QFile actual(actualName);
        QVERIFY(actual.open(QIODevice::WriteOnly));
        actual.write(lines.join(QLatin1Char('\n')).toUtf8() + '\n');
        qWarning("what is said now stands in %s", qUtf8Printable(QFileInfo(actual).absoluteFilePath()));
    }
    for (qsizetype i = 0; i < qMin(lines.size(), expected.size()); ++i) QCOMPARE(lines[i], expected[i]);
    QCOMPARE(lines.size(), expected.size());
}

void TestPhrasebook::sentencesKeepTheRules() {
    QFETCH(QString, language);
    QVERIFY(installTranslation(language));
    static const QRegularExpression jargon(
        QStringLiteral(
            "\\b(region|fix|cue|vote|manoeuvre|access|portal|node|null|nan|região|manobra|acesso|voto)\\b"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    for (const Said& said : everything()) {
        const QByteArray what = (said.label + QStringLiteral(": ") + said.text).toUtf8();
        QVERIFY2(!said.text.isEmpty(), what);
        QVERIFY2(!said.text.contains(QRegularExpression(QStringLiteral("%[0-9nL]|\\(s\\)"))), what);
        QVERIFY2(said.text.endsWith(QLatin1Char('.')), what);
        QVERIFY2(!said.text.contains(QRegularExpression(QStringLiteral("\\.\\.|  |,\\.|:\\.| [.,:]"))), what);
        QVERIFY2(said.text.at(0).isUpper() || said.text.at(0).isDigit(), what);
        QVERIFY2(said.text.size() <= kMostLetters || said.cue.kind == CueKind::Itinerary, what);
        QVERIFY2(!jargon.match(said.text).hasMatch(), what);
    }
}

void TestPhrasebook::figuresComeFromTheCueOnly() {
    QFETCH(QString, language);
    QVERIFY(installTranslation(language));
    static const QRegularExpression metres(QStringLiteral("met(re|ro)|mètre|Meter"));
    for (const Said& said : everything()) {
        const QByteArray what = (said.label + QStringLiteral(": ") + said.text).toUtf8();
        if (!said.cue.distanceM && !said.cue.firstM) QVERIFY2(!said.text.contains(metres), what);
        // A doubtful place has no trustworthy distance.
        if (!said.cue.sure) QVERIFY2(!said.text.contains(metres), what);
    }
}

/// A sentence of its own in each language: nothing was copied from another one.
void TestPhrasebook::everyLanguageHasItsOwnWords() {
    QMap<QString, QString> saidIn;
    for (const farol::ui::Language& each : farol::ui::languages()) {
        QVERIFY(installTranslation(each.code));
        QCOMPARE(farol::ui::installedLanguage(), each.code);
        const QString words = Phrasebook().turnWords(fromDegrees(90));
        QVERIFY2(!saidIn.contains(words),
                 qPrintable(each.code + QStringLiteral(" as ") + saidIn.value(words)));
        saidIn.insert(words, each.code);
    }
}

void TestPhrasebook::othersHoldNoEnglish() {
    QFETCH(QString, language);
    if (language == QLatin1String("en")) return;
    QVERIFY(installTranslation(language));
    static const QRegularExpression english(
        QStringLiteral(
            "\\b(the|you|your|is|and|then|turn|left|right|up|down|door|stairs|lift|go|take|of|it|probably|"
            "ahead|"
            "metre|metres|step|steps|soon|first|next|at|from|behind|clock|degrees|level|choose|where)\\b"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    for (Said& said : everything()) {
        if (said.cue.kind == CueKind::Text) continue; // read from a wall, in the wall's language
        QVERIFY2(!english.match(said.text).hasMatch(), said.text.toUtf8());
    }
}

void TestPhrasebook::namesFromTheMapAreLeftAlone() {
    QVERIFY(installTranslation(QStringLiteral("en")));
    Cue cue;
    cue.kind = CueKind::Located;
    cue.regionName = "Room %1 %2\nDr. Silva.";
    cue.levelName = "%1";
    QCOMPARE(Phrasebook().sentence(cue), QStringLiteral("You are here: Room %1 %2 Dr. Silva, level %1."));
    cue.levelName = "Floor -1"; // voices read the sign as a dash
    QCOMPARE(Phrasebook().sentence(cue),
             QStringLiteral("You are here: Room %1 %2 Dr. Silva, Floor minus 1."));
    cue.kind = CueKind::Act;
    cue.manoeuvre.emplace().kind = farol::routing::ManoeuvreKind::Door;
    cue.intoName = "%2 Gabinete do Senhor Reitor";
    QCOMPARE(Phrasebook().sentence(cue),
             QStringLiteral("Go through the door. Next: %2 Gabinete do Senhor Reitor."));
}

void TestPhrasebook::distancesAreRounded_data() {
    QTest::addColumn<double>("metres");
    QTest::addColumn<QString>("said");
    QTest::newRow("very near") << 0.2 << QStringLiteral("about 1 metre.");
    QTest::newRow("near") << 6.4 << QStringLiteral("about 6 metres.");
    QTest::newRow("middle") << 12.4 << QStringLiteral("about 10 metres.");
    QTest::newRow("far") << 87.0 << QStringLiteral("about 90 metres.");
    QTest::newRow("very far") << 431.0 << QStringLiteral("about 450 metres.");
}

void TestPhrasebook::distancesAreRounded() {
    QFETCH(double, metres);
    QFETCH(QString, said);
    QVERIFY(installTranslation(QStringLiteral("en")));
    Cue cue;
    cue.kind = CueKind::Reassure;
    cue.distanceM = metres;
    QCOMPARE(Phrasebook().sentence(cue), QStringLiteral("Keep moving forward for ") + said);
}

void TestPhrasebook::brokenNumbersAreNotSpoken() {
    QVERIFY(installTranslation(QStringLiteral("en")));
    Cue cue;
    cue.kind = CueKind::Prepare;
    cue.manoeuvre.emplace().kind = farol::routing::ManoeuvreKind::Door;
    cue.manoeuvre->turn = {qQNaN()};
    for (double metres : {qQNaN(), qInf(), -3.0}) {
        cue.distanceM = metres;
        QCOMPARE(Phrasebook().sentence(cue), QStringLiteral("Soon, go through the door."));
    }
    cue.manoeuvre->steps = -4;
    cue.manoeuvre->kind = farol::routing::ManoeuvreKind::Stairs;
    cue.manoeuvre->vertical = farol::routing::Vertical::Up;
    QCOMPARE(Phrasebook().sentence(cue), QStringLiteral("Soon: stairs up."));
    cue.manoeuvre.reset();
    QCOMPARE(Phrasebook().sentence(cue), QString());
}

void TestPhrasebook::languagesAreFoundByLocale() {
    for (const char* portuguese : {"pt", "pt_PT", "pt_BR", "pt-PT"}) {
        QVERIFY2(installTranslation(QLatin1String(portuguese)), portuguese);
        QCOMPARE(Phrasebook().turnWords(fromDegrees(90)), QStringLiteral("vire à esquerda"));
    }
    QVERIFY(installTranslation(QStringLiteral("en_GB")));
    QCOMPARE(Phrasebook().turnWords(fromDegrees(90)), QStringLiteral("turn left"));
    for (const char* none : {"fi", "", "../pt"}) {
        QVERIFY2(!installTranslation(QLatin1String(none)), none);
        QCOMPARE(Phrasebook().turnWords(fromDegrees(-90)), QStringLiteral("turn right"));
    }
}

QTEST_GUILESS_MAIN(TestPhrasebook)
#include "test_phrasebook.moc"
