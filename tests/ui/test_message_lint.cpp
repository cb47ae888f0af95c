// Every cue that any map can produce, said in every language and style: what no sentence may ever be.

#include "core/building/sayable.h"
#include "ui/speech/phrasebook.h"

#include <QRegularExpression>
#include <QTest>

#include <map>

using farol::fromDegrees;
using farol::Kind;
using farol::building::RegionKind;
using farol::guidance::Bearing;
using farol::guidance::Cue;
using farol::guidance::CueKind;
using farol::guidance::CueReason;
using farol::guidance::Deviation;
using farol::guidance::Mark;
using farol::guidance::Surrounding;
using farol::guidance::SweepStep;
using farol::routing::Manoeuvre;
using farol::routing::ManoeuvreKind;
using farol::routing::Side;
using farol::routing::Vertical;
using farol::ui::DirectionStyle;
using farol::ui::installedLanguage;
using farol::ui::installTranslation;
using farol::ui::Phrasebook;

namespace {

const std::vector<std::string> kNames{"",
                                      "Library",
                                      "2.14",
                                      "Sala_3",
                                      "  A  ",
                                      "Café.",
                                      "%1 & %n <b>",
                                      "Line\nbreak",
                                      "\"quoted\"...",
                                      "会議室",
                                      "A very long name of a very long room in a long building"};
const std::vector<CueKind> kKinds{
    CueKind::RouteStart, CueKind::Prepare,  CueKind::Act,       CueKind::Reassure,
    CueKind::Arrived,    CueKind::OffRoute, CueKind::Unsure,    CueKind::Located,
    CueKind::Detection,  CueKind::Text,     CueKind::NoRoute,   CueKind::AlreadyThere,
    CueKind::Warning,    CueKind::Around,   CueKind::Itinerary, CueKind::Chime};
const std::vector<ManoeuvreKind> kManoeuvres{
    ManoeuvreKind::Start,  ManoeuvreKind::Door,     ManoeuvreKind::Opening,
    ManoeuvreKind::Stairs, ManoeuvreKind::Elevator, ManoeuvreKind::Escalator,
    ManoeuvreKind::Ramp,   ManoeuvreKind::Turn,     ManoeuvreKind::Arrive};
const std::vector<DirectionStyle> kStyles{DirectionStyle::LeftRight, DirectionStyle::Clock,
                                          DirectionStyle::Degrees};

/// Names are the map's; the rules are for our own words. Each stands for one word.
QString withoutNames(QString text) {
    for (const std::string& name : kNames) {
        QString said = QString::fromStdString(name).replace(QLatin1Char('_'), QLatin1Char(' ')).simplified();
        while (said.endsWith(QLatin1Char('.'))) said.chop(1);
        if (said.size() > 1) text.replace(said, QStringLiteral("Name"));
    }
    return text;
}

qsizetype mostWords(const Cue& cue) {
    switch (cue.kind) {
    case CueKind::Act:
    case CueKind::Prepare:
        return cue.asked ? 36 : 30;
    case CueKind::RouteStart:
    case CueKind::OffRoute:
        return 54;
    case CueKind::Around:
        return 20 + 14 * static_cast<qsizetype>(cue.around.size());
    case CueKind::Itinerary:
        return 20 + 34 * static_cast<qsizetype>(cue.steps.size());
    default:
        return 26;
    }
}

QRegularExpression rule(const char* pattern) {
    return QRegularExpression(QString::fromUtf8(pattern), QRegularExpression::CaseInsensitiveOption |
                                                              QRegularExpression::UseUnicodePropertiesOption);
}

/// Articles that have to melt into the word before them, vowels that have to go, one of several things.
const QRegularExpression& badGrammar() {
    static const std::map<QString, QRegularExpression> kRules{
        {"en", rule("\\ba [aeiou]\\w|\\ban [^aeiou]|\\b1 (met(re|er)s|steps|feet)")},
        {"pt", rule("\\b(de|em|por) (o|a|os|as|um|uma)\\b|\\b1 (metros|passos|pés)")},
        {"es",
         rule("\\b(de|a) el\\b|\\bde usted\\b.*\\btu\\b|\\b1 (metros?|pasos?|pies?)|\\b(tú|tu|tus)\\b")},
        {"fr", rule("\\b(de|à) (le|les)\\b|\\b(le|la|de|que|ne|je|me) [aeéèêiou](?!nze)|\\b1 mètres|"
                    "[^\u00a0 ][:?!]|\\b(tu|ton|ta|tes)\\b")},
        {"de", rule("\\b(in|zu|an|von|bei) dem (?!Name)|\\bzu der\\b|\\b1 "
                    "(Metern|Schritte)|\\b(du|dir|dich|dein\\w*)\\b|"
                    "\\b(in|zu) (ein|etwa ein) (Meter|Schritt)")}};
    static const QRegularExpression kNone(QStringLiteral("(?!)"));
    const auto found = kRules.find(installedLanguage());
    return found != kRules.end() ? found->second : kNone;
}

QString fault(const Cue& cue, const QString& said) {
    const QString text = withoutNames(said);
    static const QRegularExpression placeholder = rule("%[0-9nL]|\\(s\\)");
    static const QRegularExpression spaces = rule("  |\\n|\\t");
    static const QRegularExpression emptyName =
        rule("\\.\\.|,\\.|:\\.|;\\.| [.,:;]|:,|,,|: *:|[,:;] *$|\\( *\\)");
    static const QRegularExpression noWord =
        rule("\\b(nan|inf|null|undefined|unnamed|tbd|input name here)\\b");
    static const QRegularExpression jargon = rule(
        "\\b(region|fix|cue|vote|manoeuvre|access|portal|node|polygon|id|região|manobra|acesso|voto|"
        "región|maniobra|acceso|nodo|région|manœuvre|accès|nœud|manöver|zugang|stimme|knoten|polygono?)\\b");
    static const QRegularExpression code = rule("\\d{4,}|[0-9a-f]{8}|_");
    static const QRegularExpression metres = rule("\\bmet(re|ro|er|ern|ers|res|ros|r|rs)\\b|mètre");
    if (text.isEmpty()) return {};
    if (text.contains(placeholder)) return QStringLiteral("a placeholder is left");
    if (text.contains(spaces)) return QStringLiteral("spaces");
    if (text.contains(emptyName)) return QStringLiteral("an empty name");
    if (!text.endsWith(QLatin1Char('.')) && !text.endsWith(QLatin1Char(':'))) return QStringLiteral("no end");
    if (text.contains(noWord)) return QStringLiteral("no word for ears");
    if (text.contains(jargon)) return QStringLiteral("jargon");
    if (text.contains(code)) return QStringLiteral("digits read as a code");
    if (text.contains(badGrammar())) return QStringLiteral("grammar");
    if (!cue.sure && text.contains(metres)) return QStringLiteral("metres of a guess");
    const qsizetype words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts).size();
    if (words > mostWords(cue)) return QStringLiteral("%1 words").arg(words);
    return {};
}

struct Lint {
    int said = 0;
    int faults = 0;

    void check(const Cue& cue) {
        for (DirectionStyle style : kStyles) {
            const QString text = Phrasebook(style).sentence(cue);
            ++said;
            const QString wrong = fault(cue, text);
            if (wrong.isEmpty()) continue;
            if (++faults <= 10)
                qWarning("%s (%s): %s", qUtf8Printable(wrong), cueKindName(cue.kind).c_str(),
                         qUtf8Printable(text));
        }
    }
};

Manoeuvre manoeuvreOf(ManoeuvreKind kind, int variant) {
    static const double kTurns[] = {0.0, 90.0, -45.0, 180.0, 20.0, -120.0};
    Manoeuvre manoeuvre;
    manoeuvre.kind = kind;
    manoeuvre.turn = fromDegrees(kTurns[variant % 6]);
    manoeuvre.vertical =
        std::vector{Vertical::None, Vertical::Up, Vertical::Down}[static_cast<std::size_t>(variant % 3)];
    if (variant % 4 == 1) manoeuvre.steps = 9;
    if (variant % 4 == 2) manoeuvre.steps = 40;
    if (variant % 2 == 1) manoeuvre.behind = fromDegrees(kTurns[(variant + 2) % 6]);
    if (variant % 5 == 3) manoeuvre.side = Side::Left;
    if (variant % 5 == 4) manoeuvre.side = Side::Right;
    if (manoeuvre.side != Side::None) manoeuvre.number = variant % 11;
    manoeuvre.alongWall = manoeuvre.side != Side::None && variant % 3 == 0;
    return manoeuvre;
}

void decorate(Cue& cue, const std::string& name, int variant) {
    cue.regionName = cue.intoName = cue.text = name;
    cue.levelName = variant % 3 == 0 ? "" : variant % 3 == 1 ? "-1" : name;
    cue.sure = variant % 4 != 3;
    cue.facingWay = variant % 3 != 2;
    cue.staying = variant % 13 == 12;
    cue.routeVersion = variant % 2 == 0 ? 1 : 0;
    cue.asked = variant % 7 == 6;
    if (variant % 3 == 1) cue.distanceM = 0.4 + 7.0 * variant;
    if (variant % 5 == 4) cue.firstM = 6.5 + variant;
    cue.soon = variant % 5 != 1;
    if (variant % 5 == 2) cue.hour = 1 + variant % 12;
    if (variant % 6 == 5) cue.turnFirst = fromDegrees(-100.0);
    if (variant % 4 == 1) cue.mark = Mark{Kind::Extinguisher, variant % 8 == 1 ? Side::Left : Side::None};
    cue.deviation = std::vector{Deviation::LeftRoute, Deviation::WrongWay,
                                Deviation::Missed}[static_cast<std::size_t>(variant % 3)];
    cue.regionKind = cue.intoKind = static_cast<RegionKind>(variant % 8);
    cue.fromKind = static_cast<RegionKind>((variant / 2) % 8);
    cue.sweep = static_cast<SweepStep>(variant % 7);
    cue.reason = static_cast<CueReason>(variant % 9);
    cue.zone = {static_cast<farol::Column>(variant % 3), static_cast<farol::Row>((variant / 3) % 3)};
    cue.objectKind = farol::allKinds()[static_cast<std::size_t>(variant) % farol::allKinds().size()];
    cue.bearing = static_cast<Bearing>(variant % 4);
}

} // namespace

/// Of the kinds that tell of no manoeuvre one is enough.
std::vector<ManoeuvreKind> manoeuvresOf(CueKind kind) {
    bool tells = kind == CueKind::RouteStart || kind == CueKind::Prepare || kind == CueKind::Act ||
                 kind == CueKind::OffRoute;
    return tells ? kManoeuvres : std::vector<ManoeuvreKind>{ManoeuvreKind::Door};
}

class TestMessageLint : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyCueIsFitToBeHeard_data();
    void everyCueIsFitToBeHeard();
    void answersAreFitToBeHeard_data() { everyCueIsFitToBeHeard_data(); }
    void answersAreFitToBeHeard();
    void placeholdersOfTheMapAreNeverSpoken();
    void stairsSayUpOrDown();
    void leftAndRightAreNotMixedUp();
};

void TestMessageLint::everyCueIsFitToBeHeard_data() {
    QTest::addColumn<QString>("language");
    for (const farol::ui::Language& each : farol::ui::languages())
        QTest::newRow(qPrintable(each.code)) << each.code;
}

void TestMessageLint::everyCueIsFitToBeHeard() {
    QFETCH(QString, language);
    QVERIFY(installTranslation(language));
    Lint lint;
    for (CueKind kind : kKinds)
        for (const std::string& name : kNames)
            for (ManoeuvreKind what : manoeuvresOf(kind))
                for (int variant = 0; variant < 60; ++variant) {
                    Cue cue;
                    cue.kind = kind;
                    decorate(cue, name, variant);
                    if (variant % 10 != 9) cue.manoeuvre = manoeuvreOf(what, variant);
                    // Along a wall one thing is enough to remember.
                    bool alongWall = cue.manoeuvre && cue.manoeuvre->alongWall;
                    if (alongWall) cue.soon = false;
                    if (alongWall && kind == CueKind::Act) continue;
                    if (variant % 3 == 0 && !alongWall)
                        cue.next = manoeuvreOf(
                            kManoeuvres[static_cast<std::size_t>(variant) % kManoeuvres.size()], variant + 1);
                    lint.check(cue);
                }
    qInfo("%d sentences", lint.said);
    QCOMPARE(lint.faults, 0);
}

void TestMessageLint::answersAreFitToBeHeard() {
    QFETCH(QString, language);
    QVERIFY(installTranslation(language));
    Lint lint;
    for (const std::string& name : kNames)
        for (int variant = 0; variant < 120; ++variant) {
            Cue cue;
            cue.kind = CueKind::Around;
            decorate(cue, name, variant);
            for (int i = 0; i < variant % 7; ++i) {
                Surrounding what;
                if (i % 3 != 2) what.access = kManoeuvres[static_cast<std::size_t>(1 + (i + variant) % 6)];
                what.kind =
                    farol::allKinds()[static_cast<std::size_t>(i + variant) % farol::allKinds().size()];
                what.vertical = static_cast<Vertical>(i % 3);
                what.name = i % 2 == 0 ? name : "";
                what.behind = static_cast<RegionKind>((i + variant) % 8);
                if (i % 4 != 3) what.direction = fromDegrees(37.0 * (i + variant));
                cue.around.push_back(what);
            }
            lint.check(cue);
            cue.kind = CueKind::Itinerary;
            for (int i = 0; i < variant % 14; ++i) {
                Cue step;
                step.kind = CueKind::Act;
                decorate(step, name, variant + i);
                step.asked = false;
                step.sure = true;
                step.manoeuvre =
                    manoeuvreOf(kManoeuvres[static_cast<std::size_t>(1 + (i + variant) % 7)], variant + i);
                cue.steps.push_back(step);
            }
            lint.check(cue);
        }
    QCOMPARE(lint.faults, 0);
}

/// What guidance hands on is empty where the map has no name that can be said; then the kind is said, or
/// nothing.
void TestMessageLint::placeholdersOfTheMapAreNeverSpoken() {
    QVERIFY(installTranslation(QStringLiteral("en")));
    farol::building::Region region;
    region.id = farol::RegionId("region_00017");
    for (const char* name :
         {"input name here", "unnamed", "TBD", "", "3d2f9a0b-77c1-4e4e-9d5a-0a1b2c3d4e5f"}) {
        region.name = name;
        Cue cue;
        cue.kind = CueKind::Located;
        cue.regionName = sayableName(region);
        cue.regionKind = RegionKind::Corridor;
        QCOMPARE(Phrasebook().sentence(cue), QStringLiteral("You are here: a corridor."));
    }
}

void TestMessageLint::stairsSayUpOrDown() {
    QVERIFY(installTranslation(QStringLiteral("en")));
    for (CueKind kind : {CueKind::Prepare, CueKind::Act, CueKind::RouteStart, CueKind::OffRoute})
        for (Vertical vertical : {Vertical::Up, Vertical::Down}) {
            Cue cue;
            cue.kind = kind;
            cue.manoeuvre = manoeuvreOf(ManoeuvreKind::Stairs, 1);
            cue.manoeuvre->vertical = vertical;
            const QString text = Phrasebook().sentence(cue);
            QVERIFY2(
                text.contains(vertical == Vertical::Up ? QStringLiteral(" up") : QStringLiteral(" down")),
                qUtf8Printable(text));
            QVERIFY2(text.contains(QStringLiteral("9 steps")), qUtf8Printable(text));
        }
}

void TestMessageLint::leftAndRightAreNotMixedUp() {
    struct Words {
        const char *language, *left, *right;
    };
    for (const Words& words : {Words{"en", "left", "right"}, Words{"pt", "esquerda", "direita"},
                               Words{"es", "izquierda", "derecha"}, Words{"fr", "gauche", "droite"},
                               Words{"de", "links", "rechts"}}) {
        QVERIFY(installTranslation(QString::fromLatin1(words.language)));
        for (Side side : {Side::Left, Side::Right}) {
            Cue cue;
            cue.kind = CueKind::Act;
            cue.routeVersion = 1;
            cue.manoeuvre = manoeuvreOf(ManoeuvreKind::Door, 0);
            cue.manoeuvre->side = side;
            cue.manoeuvre->turn = fromDegrees(side == Side::Left ? 90.0 : -90.0);
            cue.manoeuvre->behind = fromDegrees(0.0);
            const QString text = Phrasebook().sentence(cue);
            QVERIFY2(text.contains(QString::fromUtf8(side == Side::Left ? words.left : words.right)),
                     qUtf8Printable(text));
            QVERIFY2(!text.contains(QString::fromUtf8(side == Side::Left ? words.right : words.left)),
                     qUtf8Printable(text));
        }
    }
}

QTEST_GUILESS_MAIN(TestMessageLint)
#include "test_message_lint.moc"
