// What core says of a map, read on the Map page in every language.

#include "core/base/base_sayings.h"
#include "core/base/file.h"
#include "core/building/checks.h"
#include "core/building/geopackage.h"
#include "core/building/import/importer.h"
#include "core/building/info.h"
#include "core/capture/frame_source.h"
#include "core/capture/sayings.h"
#include "core/recognition/landmark_library.h"
#include "core/recognition/sayings.h"
#include "core/recognition/training.h"
#include "core/session/sayings.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/curation/map_page.h"
#include "ui/curation/report_panel.h"
#include "ui/models/core_words.h"
#include "ui/speech/phrasebook.h"

#include <QFile>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include <cerrno>
#include <set>

namespace farol::ui {

using building::allSentences;
using building::Argument;
using building::Finding;
using building::Sentence;
using building::SentenceText;

class CoreWordsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { installTranslation(QStringLiteral("en")); }
    void everySentenceIsTranslated_data() { addLanguages(); }
    void everySentenceIsTranslated();
    void everySayingIsTranslated_data() { addLanguages(); }
    void everySayingIsTranslated();
    void englishIsAsCoreHasIt();
    void placesAreFilledInTheReadersWay();
    void theMapCheckIsReadWholly_data() { addLanguages(); }
    void theMapCheckIsReadWholly();
    void anImportIsReadWhollyInPortuguese();
    void whyAMapDoesNotOpenIsReadInPortuguese();
    void problemsKeepTheirPlaces();
    void aPlaceThatIsNotFoundIsToldInPortuguese();
    void everySayingIsKnownAgain();
    void librariesAndSourcesAreToldInPortuguese();

private:
    static void addLanguages();
    static void readEach(const building::Building& map, const std::vector<Finding>& findings);
    static std::vector<const char*> allSayings();
    static QString englishIn(const QString& text, const Finding* finding);
    static QString translated(const SentenceText& row, int count) {
        return QCoreApplication::translate("core", row.text, nullptr, count);
    }
    /// The places of a text in a row; "%n" only where `counts` asks for it.
    static QStringList placesOf(const QString& text) {
        static const QRegularExpression place(QStringLiteral("%[1-9n]"));
        QStringList places;
        for (auto found = place.globalMatch(text); found.hasNext();) places << found.next().captured();
        places.sort();
        return places;
    }
};

void CoreWordsTest::addLanguages() {
    QTest::addColumn<QString>("language");
    for (const Language& language : languages())
        if (language.code != QLatin1String("en")) QTest::newRow(qPrintable(language.code)) << language.code;
}

void CoreWordsTest::everySentenceIsTranslated() {
    QFETCH(QString, language);
    QVERIFY(installTranslation(language));
    for (const SentenceText& row : allSentences()) {
        if (row.sentence == Sentence::Nothing) continue;
        QStringList wanted = placesOf(QString::fromUtf8(row.text));
        wanted.removeAll(QStringLiteral("%n"));
        for (const int count : {1, 5}) {
            const QString text = translated(row, row.counts() ? count : -1);
            QVERIFY2(!text.isEmpty(), row.text);
            QVERIFY2(text != QString::fromUtf8(row.text) || row.sentence == Sentence::InContext, row.text);
            QVERIFY2(placesOf(text) == wanted, qPrintable(text));
            QVERIFY2(!row.counts() || text.contains(QString::number(count)), qPrintable(text));
            QVERIFY2(text.front() == text.front().toLower() || language == QLatin1String("de"),
                     qPrintable(text)); // German writes its nouns so
            QVERIFY2(!text.endsWith(QLatin1Char('.')), qPrintable(text));
        }
    }
}

/// All that modules other than that of maps say.
std::vector<const char*> CoreWordsTest::allSayings() {
    std::vector<const char*> all = baseSayings();
    for (const std::vector<const char*>& more :
         {capture::sayings(), recognition::sayings(), session::sayings()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

void CoreWordsTest::everySayingIsTranslated() {
    QFETCH(QString, language);
    QVERIFY(installTranslation(language));
    std::set<std::string> texts;
    for (const SentenceText& row : allSentences()) texts.insert(row.text);
    for (const char* english : allSayings()) {
        QVERIFY2(texts.insert(english).second, english); // stands in one table only
        const QString text = QCoreApplication::translate("core", english);
        QVERIFY2(text != QString::fromUtf8(english), english);
        QVERIFY2(placesOf(text) == placesOf(QString::fromUtf8(english)), qPrintable(text));
        QVERIFY2(text.front() == text.front().toLower() || language == QLatin1String("de"), qPrintable(text));
        QVERIFY2(!text.endsWith(QLatin1Char('.')), qPrintable(text));
    }
}

void CoreWordsTest::everySayingIsKnownAgain() {
    QVERIFY(installTranslation(QStringLiteral("pt")));
    for (const char* english : allSayings()) {
        const std::vector<std::string> places{"x7", "y8", "z9"};
        QString wanted = toQString(withPlaces(toUtf8(QCoreApplication::translate("core", english)), places));
        if (!wanted.endsWith(QLatin1Char('?'))) wanted += QLatin1Char('.');
        wanted[0] = wanted[0].toUpper();
        const bool frame = QRegularExpression(QStringLiteral("^(%1, .*%2|template %1)$"))
                               .match(QString::fromUtf8(english))
                               .hasMatch();
        if (!frame) QCOMPARE(CoreWords::problem({ErrorCode::Io, withPlaces(english, places), ""}), wanted);
    }
}

void CoreWordsTest::librariesAndSourcesAreToldInPortuguese() {
    QVERIFY(installTranslation(QStringLiteral("pt")));
    QTemporaryDir folder;
    const std::string missing = toUtf8(folder.filePath(QStringLiteral("no.mp4")));
    QCOMPARE(
        CoreWords::problem(capture::openSource(missing).error()),
        toQString(missing) +
            QStringLiteral(": não existe esse ficheiro nem essa pasta (uma fonte é camera:0, um ficheiro "
                           "de vídeo, uma pasta de imagens ou um endereço http ou rtsp)."));
    QCOMPARE(CoreWords::problem(capture::openSource(toUtf8(folder.path())).error()),
             folder.path() + QStringLiteral(": não há imagens nesta pasta (jpg, png, bmp, webp ou tif)."));
    QCOMPARE(CoreWords::problem(recognition::loadLibrary(missing).error()),
             toQString(missing) + QStringLiteral(": não existe esse ficheiro."));
    recognition::LandmarkLibrary library;
    recognition::TrainingRequest request;
    request.id = TemplateId("door-1");
    request.kind = Kind::Door;
    QCOMPARE(CoreWords::problem(recognition::addView(library, request, "x", std::nullopt).error()),
             QStringLiteral("ponto de referência door-1: não se consegue ler a fotografia como imagem."));
    QCOMPARE(
        CoreWords::problem({ErrorCode::Corrupt,
                            "the keypoints are of another kind; the library is damaged: restore it or "
                            "train this view again",
                            "l.gpkg, template door-1, view 2"}),
        QStringLiteral("l.gpkg, ponto de referência door-1, fotografia 2: os pontos-chave são de outro "
                       "tipo; a biblioteca está danificada: reponha-a ou treine de novo esta fotografia."));
    QCOMPARE(CoreWords::problem({ErrorCode::InvalidArgument,
                                 "this template is of kind door, not place; use another template name", ""}),
             QStringLiteral("Este ponto de referência é do tipo %1, não %2; use outro nome.")
                 .arg(Phrasebook::kindWord(Kind::Door), Phrasebook::kindWord(Kind::Place)));
    QCOMPARE(CoreWords::problem(systemError(EACCES, "cannot write to disk", "a.gpkg")),
             QStringLiteral("a.gpkg: não se consegue escrever no disco: permissão recusada."));
    QCOMPARE(CoreWords::message("7.jpg cannot be read as a picture; skipped (1 so far)"),
             QStringLiteral("7.jpg: não se consegue ler como imagem; saltou-se (1 até agora)"));
    QCOMPARE(CoreWords::message(
                 "the recording stopped (a/walk.jsonl: cannot write: Permission denied); the walk goes on"),
             QStringLiteral("a gravação parou (a/walk.jsonl: não se consegue escrever: permissão recusada); "
                            "o percurso continua"));
    QCOMPARE(CoreWords::message("camera:0 is back"), QStringLiteral("camera:0 está de volta"));
    QCOMPARE(CoreWords::message("nobody knows this one"), QStringLiteral("nobody knows this one"));
}

void CoreWordsTest::englishIsAsCoreHasIt() {
    QVERIFY(installTranslation(QStringLiteral("en")));
    for (const SentenceText& row : allSentences()) {
        if (!row.counts()) continue;
        const QString one = QString::fromUtf8(row.one ? row.one : row.text);
        QCOMPARE(translated(row, 1), QString(one).replace(QLatin1String("%n"), QLatin1String("1")));
        QCOMPARE(translated(row, 5),
                 QString::fromUtf8(row.text).replace(QLatin1String("%n"), QLatin1String("5")));
    }
}

void CoreWordsTest::placesAreFilledInTheReadersWay() {
    QVERIFY(installTranslation(QStringLiteral("pt")));
    const auto sentence = [](const building::Message& message) { return CoreWords::sentence(message); };
    QCOMPARE(
        sentence(building::said(Sentence::RegionSliver, "%2 a", 0.12)),
        QStringLiteral("O espaço “%2 a” é uma tira com cerca de 0,12\u00a0m de largura: ninguém lá cabe; "
                       "junte-o ao vizinho."));
    const QString parts = sentence(
        building::counted(Sentence::BuildingInParts, 2, 3.0, building::counted(Sentence::CountedRegions, 1)));
    QVERIFY2(parts.contains(QStringLiteral("3 partes; 2 espaços")), qPrintable(parts));
    QVERIFY2(parts.contains(QStringLiteral("(1 espaço)")), qPrintable(parts));
    const QString kinds =
        sentence(building::counted(Sentence::KindUnknown, 1, "cave", Argument::Is::RegionKinds));
    QVERIFY2(kinds.contains(QStringLiteral("corredor (corridor), ")), qPrintable(kinds));
    QCOMPARE(CoreWords::id("house.gpkg, layer rooms"), QStringLiteral("house.gpkg, camada rooms"));
    QVERIFY(installTranslation(QStringLiteral("en")));
    QCOMPARE(sentence(building::counted(Sentence::RegionsUnnamed, 1)),
             QStringLiteral("1 region has neither name nor ref: only its kind is spoken."));
}

/// A piece of English, or nothing.
QString CoreWordsTest::englishIn(const QString& text, const Finding* finding) {
    static const QRegularExpression codes(QStringLiteral("\\([a-z_]+\\)|“other”|« other »|„other“|Rule: "));
    static const QRegularExpression words(
        QStringLiteral("\\b(the|which|regions|access(es)?|landmarks?|levels?|features?|has|have|does|is|were|"
                       "and|of|with|"
                       "without|nobody|draw|warning|English)\\b"),
        QRegularExpression::CaseInsensitiveOption);
    if (finding && text.contains(toQString(finding->message), Qt::CaseInsensitive)) return text;
    QString plain = text;
    plain.remove(codes);
    plain.remove(
        QRegularExpression(QStringLiteral("(?m)^[^\\n]*: [a-z0-9]+(-[a-z0-9]+)+$"))); // the rule's id
    const auto found = words.match(plain);
    return found.hasMatch() ? found.captured() : QString();
}

void CoreWordsTest::readEach(const building::Building& map, const std::vector<Finding>& findings) {
    ReportPanel panel;
    panel.setBuilding(std::make_shared<const building::Building>(map.data()));
    panel.setFindings(findings, false);
    const FindingModel& model = panel.model();
    QStringList shown{panel.summary(), panel.next().text(), panel.again().text(),
                      model.headerData(0, Qt::Horizontal).toString(),
                      model.headerData(1, Qt::Horizontal).toString()};
    for (int branch = 0; branch < model.rowCount(); ++branch) {
        const QModelIndex rule = model.index(branch, 0);
        shown << rule.data().toString();
        for (int row = 0; row < model.rowCount(rule); ++row) {
            const QModelIndex index = model.index(row, 0, rule);
            panel.tree().setCurrentIndex(index);
            const Finding* finding = model.findingAt(index);
            QVERIFY(finding != nullptr);
            const QString words = panel.explanation();
            QString sentence = CoreWords::sentence(finding->said);
            sentence.replace(QChar::Nbsp, QLatin1Char(' ')); // as the field gives it back
            QVERIFY2(words.contains(sentence), qPrintable(words));
            QVERIFY2(englishIn(words, finding).isEmpty(),
                     qPrintable(englishIn(words, finding) + QLatin1String(" in: ") + words));
            if (finding->ids.empty()) shown << index.data().toString();
        }
    }
    for (const QString& text : shown) QVERIFY2(englishIn(text, nullptr).isEmpty(), qPrintable(text));
}

void CoreWordsTest::theMapCheckIsReadWholly() {
    QFETCH(QString, language);
    QVERIFY(installTranslation(language));
    building::BuildingData data = test::handMadeBuilding()->data();
    data.levels.clear();
    data.regions[0].name.clear();
    data.regions[0].ref.clear();
    data.regions[1].name = "__";
    data.regions[1].kindText = "cave";
    data.regions[1].kind = building::RegionKind::Other;
    data.regions[2].polygon.outer.resize(2);
    building::Region narrow = data.regions[3];
    narrow.id = RegionId("n1");
    narrow.polygon.outer = {{50, 0}, {50.1, 0}, {50.1, 9}, {50, 9}};
    data.regions.push_back(narrow);
    data.regions.push_back(narrow); // the same id, the same outline
    data.regions.push_back(data.regions[3]);
    data.regions.back().id = RegionId("n2");
    for (Point2& corner : data.regions.back().polygon.outer) corner.x += 0.7;
    data.accesses[0].regionA = RegionId("x9");
    data.accesses[1].regionB = data.accesses[1].regionA;
    data.accesses[2].kind = building::AccessKind::Other;
    data.accesses[2].kindText = "gate";
    data.landmarks[0].position = {500.0, 500.0};
    data.landmarks[1].region = RegionId("x9");
    data.landmarks[1].kind = Kind::Other;
    data.landmarks[1].kindText = "statue";
    const building::Building map(data);
    const std::vector<Finding> findings = building::checkBuilding(map);
    std::set<std::string> rules;
    for (const Finding& finding : findings) rules.insert(finding.rule);
    QVERIFY2(rules.size() >= 12, qPrintable(QString::number(rules.size())));
    readEach(map, findings);
}

void CoreWordsTest::anImportIsReadWhollyInPortuguese() {
    QVERIFY(installTranslation(QStringLiteral("pt")));
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("r1.geojson")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    // Two rooms that meet without a wall, one of them in the form of an eight; a lift that is a point; steps
    // that end nowhere; a door nowhere.
    file.write(R"({"type":"FeatureCollection","features":[
      {"type":"Feature","id":"way/1","properties":{"name":"K1","level":"0","indoor":"room"},
       "geometry":{"type":"Polygon","coordinates":[[[-7.9,37.0],[-7.8999,37.0],[-7.8999,37.0001],[-7.9,37.0001],[-7.9,37.0]]]}},
      {"type":"Feature","id":"way/2","properties":{"level":"0","indoor":"area"},
       "geometry":{"type":"Polygon","coordinates":[[[-7.8999,37.0],[-7.8998,37.0001],[-7.8998,37.0],[-7.8999,37.0001],[-7.8999,37.0]]]}},
      {"type":"Feature","id":"way/3","properties":{"highway":"steps","level":"0;1"},
       "geometry":{"type":"LineString","coordinates":[[-7.8999,37.0003],[-7.8998,37.0003]]}},
      {"type":"Feature","id":"node/5","properties":{"highway":"elevator","level":"0;1"},
       "geometry":{"type":"Point","coordinates":[-7.8997,37.0001]}},
      {"type":"Feature","id":"node/4","properties":{"door":"yes"},
       "geometry":{"type":"Point","coordinates":[-7.8,37.1]}},
      {"type":"Feature","id":"node/6","properties":{"door":"yes","level":"?"},
       "geometry":{"type":"Point","coordinates":[-7.8,99.1]}}]})");
    file.close();
    Settings settings(folder.filePath(QStringLiteral("settings.ini")));
    MapPage page(settings);
    QSignalSpy opened(&page.document(), &MapDocument::opened);
    page.document().importFrom(file.fileName(), {});
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 60000);
    const std::vector<Finding>& findings = page.document().findings();
    QVERIFY2(findings.size() >= 8, qPrintable(QString::number(findings.size())));
    readEach(*page.document().building(), findings);
}

void CoreWordsTest::whyAMapDoesNotOpenIsReadInPortuguese() {
    QVERIFY(installTranslation(QStringLiteral("pt")));
    QTemporaryDir folder;
    const auto written = [&](const char* name, const QByteArray& content) {
        QFile file(folder.filePath(QLatin1String(name)));
        return file.open(QIODevice::WriteOnly) && file.write(content) == content.size()
                   ? toUtf8(file.fileName())
                   : std::string();
    };
    const auto english = [](const Error& error) { return toQString(error.message); };
    const std::vector<std::string> sources{
        folder.filePath(QStringLiteral("n1.gpkg")).toStdString(),
        written("e1.zip", ""),
        written("t1.txt", "x"),
        written("b1.zip", "PK\3\4 and no more"),
        written("j1.geojson", R"({"type":"FeatureCollection","features":)"),
        written("f1.geojson", R"({"type":"FeatureCollection","features":[]})"),
        written("g1.gml", "<IndoorFeatures xmlns='http://www.opengis.net/indoorgml/1.0/core'><a>")};
    for (const std::string& source : sources) {
        const auto loaded = building::loadBuilding(source);
        QVERIFY(!loaded);
        const auto imported = building::importBuilding(source);
        QVERIFY(!imported);
        for (const Error& error : {loaded.error(), imported.error()}) {
            const QString text = CoreWords::problem(error);
            // In brackets stands what a library says, in its own words.
            const QString own = english(error).section(QStringLiteral(" ("), 0, 0);
            QVERIFY2(!text.contains(own), qPrintable(text));
            QVERIFY2(text.endsWith(QLatin1Char('.')), qPrintable(text));
        }
    }
}

void CoreWordsTest::problemsKeepTheirPlaces() {
    QVERIFY(installTranslation(QStringLiteral("pt")));
    QCOMPARE(CoreWords::problem(
                 {ErrorCode::Corrupt, "width_m is no number", "a.gpkg, layer regions, feature number 3"}),
             QStringLiteral("a.gpkg, camada regions, elemento número 3: width_m não é um número."));
    QCOMPARE(CoreWords::problem({ErrorCode::Io, "cannot be opened (no such table: x)", ""}),
             QStringLiteral("Não se consegue abrir (no such table: x)."));
    QCOMPARE(CoreWords::problem({ErrorCode::Io, "nobody knows this one", ""}),
             QStringLiteral("Nobody knows this one."));
    const QString tried = CoreWords::problem(
        {ErrorCode::UnsupportedFormat,
         building::english(Sentence::UnknownKindOfMap, "a, b and 3 more", "osm, imdf"), ""});
    QVERIFY2(tried.contains(QStringLiteral("experimentou-se a, b e mais 3 como osm, imdf")),
             qPrintable(tried));
    QCOMPARE(CoreWords::remark(
                 "C: house.gpkg, layer accesses: 2 do not join two regions and are not walked through: a, b"),
             QStringLiteral(
                 "C: house.gpkg, camada accesses: 2 não ligam dois espaços e não se passa por eles: a, b."));
    QCOMPARE(CoreWords::remark("a: b"), QStringLiteral("a: b"));
    QVERIFY(installTranslation(QStringLiteral("en")));
    QCOMPARE(CoreWords::problem({ErrorCode::Corrupt, "has no outline", "a.gpkg"}),
             QStringLiteral("a.gpkg: has no outline."));
}

void CoreWordsTest::aPlaceThatIsNotFoundIsToldInPortuguese() {
    QVERIFY(installTranslation(QStringLiteral("pt")));
    building::BuildingData data = test::handMadeBuilding()->data();
    data.regions[0].name = data.regions[1].name = "Office";
    const building::Building map(data);
    const auto told = [&map](const char* where) {
        const auto found = building::resolveWhere(map, where);
        return found ? QString() : CoreWords::problem(found.error());
    };
    QCOMPARE(
        told(" "),
        QStringLiteral("O lugar está vazio: indique o identificador, o nome ou a referência de um espaço, "
                       "ou x,y,piso."));
    QCOMPARE(told("zzzzzzzzzz"),
             QStringLiteral("zzzzzzzzzz: nenhum espaço tem este identificador, nome ou referência."));
    const QString shared = told("Office");
    QVERIFY2(shared.startsWith(QStringLiteral("Office: há vários espaços com este nome: ")),
             qPrintable(shared));
    QVERIFY2(shared.contains(QLatin1String(" (piso ")) && !shared.contains(QLatin1String("level")),
             qPrintable(shared));
    const QString near = told("Offic");
    QVERIFY2(near.contains(QLatin1String("; parecidos: Office")), qPrintable(near));
    QCOMPARE(told("9999,1,0"), QStringLiteral("9999,1,0: nenhum espaço do piso 0 contém este ponto."));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::CoreWordsTest)
#include "test_core_words.moc"
