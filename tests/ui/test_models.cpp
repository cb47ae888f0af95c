// The tables of the live page: what they show, and that they keep Qt's contract of models.

#include "tests/ui/hand_made.h"
#include "ui/models/detection_model.h"
#include "ui/models/floor_model.h"
#include "ui/models/history_model.h"
#include "ui/models/region_filter.h"
#include "ui/models/region_model.h"
#include "ui/models/utterance_model.h"
#include "ui/models/vote_model.h"
#include "ui/models/words.h"

#include <QAbstractItemModelTester>
#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

namespace farol::ui {

using test::handMadeBuilding;
using test::handMadeSnapshot;

class ModelsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyRejectionHasWords();
    void historyIsNewestFirst();
    void votesTellPlacesAndReasons();
    void rowsChangeInPlace();
    void detectionsBeforeWhatWasRejected();
    void anUtteranceKeepsItsRow();
    void aFinishedUtteranceSaidAgainIsANewRow();
    void theLogDoesNotGrowForEver();
    void typingFindsPlaces_data();
    void typingFindsPlaces();
    void theExactNameComesFirst();
    void theFloorIsAListOfItsOwn();
    void everyReasonHasWords();

private:
    static QString text(const QAbstractItemModel& model, int row, int column) {
        return model.index(row, column).data().toString();
    }
    static Utterance utterance(std::uint64_t id, UtteranceState state, const char* words) {
        Utterance made;
        made.cue.id = id;
        made.cue.time = static_cast<double>(id);
        made.text = QString::fromLatin1(words);
        made.state = state;
        return made;
    }
};

void ModelsTest::historyIsNewestFirst() {
    HistoryModel model;
    const QAbstractItemModelTester tester(&model);
    model.show(handMadeSnapshot()->step.history);
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(text(model, 0, HistoryModel::What), Phrasebook::kindWord(Kind::Door));
    QCOMPARE(text(model, 0, HistoryModel::When), QStringLiteral("1:02.5"));
    QCOMPARE(text(model, 1, HistoryModel::When), QStringLiteral("1:00.0"));
    model.show({});
    QCOMPARE(model.rowCount(), 0);
}

void ModelsTest::votesTellPlacesAndReasons() {
    VoteModel model;
    const QAbstractItemModelTester tester(&model);
    model.setBuilding(handMadeBuilding());
    model.show(handMadeSnapshot()->step.fix.votes);
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(text(model, 0, VoteModel::Place), QStringLiteral("Main corridor"));
    QVERIFY(text(model, 0, VoteModel::Why).contains(Words::voteTerm("Pperc")));
    QVERIFY(!text(model, 0, VoteModel::Why).contains(QLatin1String("Pperc")));
    QCOMPARE(model.index(0, 0).data(VoteModel::ShareRole).toDouble(), 1.0);
    QCOMPARE(model.index(1, 0).data(VoteModel::ShareRole).toDouble(), 0.25);
    model.setBuilding(nullptr); // a vote for a place that no map knows is shown by its id
    model.show({{RegionId("gone"), 0.0, {}, {}}});
    QCOMPARE(text(model, 0, VoteModel::Place), QStringLiteral("gone"));
    QCOMPARE(model.index(0, 0).data(VoteModel::ShareRole).toDouble(), 0.0);
}

void ModelsTest::rowsChangeInPlace() {
    VoteModel model;
    const QAbstractItemModelTester tester(&model);
    model.show({{RegionId("a"), 3.0, {}, {}}, {RegionId("b"), 2.0, {}, {}}});
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    const QPersistentModelIndex second = model.index(1, 0);
    model.show({{RegionId("c"), 3.0, {}, {}}, {RegionId("a"), 2.0, {}, {}}, {RegionId("b"), 1.0, {}, {}}});
    QCOMPARE(resets.count(), 0);
    QCOMPARE(changes.count(), 1);
    QVERIFY(second.isValid());
    QCOMPARE(second.row(), 1);
    model.show({{RegionId("c"), 3.0, {}, {}}});
    QCOMPARE(model.rowCount(), 1);
    QVERIFY(!second.isValid());
}

void ModelsTest::detectionsBeforeWhatWasRejected() {
    DetectionModel model;
    const QAbstractItemModelTester tester(&model);
    const auto snapshot = handMadeSnapshot();
    model.show(snapshot->step.percept.detections, snapshot->step.percept.rejections);
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(text(model, 0, DetectionModel::Score), QStringLiteral("91 %"));
    QVERIFY(!text(model, 1, DetectionModel::Score).contains(QLatin1Char('_')));
    model.show(snapshot->step.percept.detections, {});
    QCOMPARE(model.rowCount(), 1);
}

void ModelsTest::anUtteranceKeepsItsRow() {
    UtteranceModel model;
    const QAbstractItemModelTester tester(&model);
    model.note(utterance(1, UtteranceState::Waiting, "Go on."));
    model.note(utterance(2, UtteranceState::Waiting, "Turn left."));
    model.note(utterance(1, UtteranceState::Speaking, "Go on."));
    model.note(utterance(1, UtteranceState::Spoken, "Go on."));
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(model.at(0).state, UtteranceState::Spoken);
    QCOMPARE(model.at(1).state, UtteranceState::Waiting);
    QCOMPARE(text(model, 0, UtteranceModel::State), Words::utteranceState(UtteranceState::Spoken));
}

void ModelsTest::aFinishedUtteranceSaidAgainIsANewRow() {
    UtteranceModel model;
    model.note(utterance(1, UtteranceState::Spoken, "Go on."));
    model.note(utterance(1, UtteranceState::Speaking, "Go on."));
    QCOMPARE(model.rowCount(), 2);
}

void ModelsTest::theLogDoesNotGrowForEver() {
    UtteranceModel model;
    const QAbstractItemModelTester tester(&model);
    for (std::uint64_t i = 0; i < UtteranceModel::kMaxRows + 3; ++i)
        model.note(utterance(i, UtteranceState::Spoken, "Go on."));
    QCOMPARE(model.rowCount(), UtteranceModel::kMaxRows);
    QCOMPARE(model.at(0).cue.id, 3u);
}

void ModelsTest::typingFindsPlaces_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QStringList>("found");
    const auto row = [](const char* name, const QString& typed, const QStringList& ids) {
        QTest::newRow(name) << typed << ids;
    };
    row("nothing: all", QString(),
        {QStringLiteral("r2"), QStringLiteral("c"), QStringLiteral("r1"), QStringLiteral("s0"),
         QStringLiteral("lib"), QStringLiteral("s1")});
    row("part of a name", QStringLiteral("corr"), {QStringLiteral("c")});
    row("without accent and case", QStringLiteral("CAFE"), {QStringLiteral("r2")});
    row("room number", QStringLiteral("1.01"), {QStringLiteral("lib")});
    row("two words in any order", QStringLiteral("above stairs"), {QStringLiteral("s1")});
    row("with the level", QStringLiteral("library level 1"), {QStringLiteral("lib")});
    row("nothing fits", QStringLiteral("swimming pool"), {});
    row("signs are text, not patterns", QStringLiteral(".*"), {});
}

void ModelsTest::typingFindsPlaces() {
    QFETCH(QString, typed);
    QFETCH(QStringList, found);
    RegionModel regions;
    RegionFilter filter;
    const QAbstractItemModelTester tester(&filter);
    filter.setSourceModel(&regions);
    regions.setBuilding(handMadeBuilding());
    filter.setTyped(typed);
    QStringList ids;
    for (int row = 0; row < filter.rowCount(); ++row)
        ids << filter.index(row, 0).data(RegionModel::IdRole).toString();
    found.sort();
    ids.sort();
    QCOMPARE(ids, found);
}

void ModelsTest::theExactNameComesFirst() {
    building::BuildingData data;
    data.levels.push_back({});
    for (const char* name : {"Hall 12", "Room 1", "Room 10", "1"}) {
        building::Region region;
        region.id = RegionId(name);
        region.name = name;
        data.regions.push_back(region);
    }
    RegionModel regions;
    RegionFilter filter;
    filter.setSourceModel(&regions);
    regions.setBuilding(std::make_shared<const building::Building>(std::move(data)));
    filter.setTyped(QStringLiteral("1"));
    QCOMPARE(filter.index(0, 0).data(RegionModel::IdRole).toString(), QStringLiteral("1"));
    QCOMPARE(filter.rowCount(), 4);
}

void ModelsTest::theFloorIsAListOfItsOwn() {
    FloorModel model;
    const QAbstractItemModelTester tester(&model);
    model.setBuilding(handMadeBuilding());
    QCOMPARE(model.rowCount(), 4 + 4 + 2); // places, ways, landmarks of level 0
    QCOMPARE(text(model, 0, FloorModel::Name), QStringLiteral("Main corridor"));
    QVERIFY(text(model, 0, FloorModel::Where).isEmpty());
    model.setMarks(RegionId("c"), RegionId("r2"));
    QVERIFY(!text(model, 0, FloorModel::Where).isEmpty());
    const int cafe = model.rowOf(FloorModel::Sort::Region, 2);
    QVERIFY(cafe >= 0);
    QVERIFY(text(model, cafe, FloorModel::Where) != text(model, 0, FloorModel::Where));
    model.setLevel(1.0);
    QCOMPARE(model.rowCount(), 2 + 1);
    QCOMPARE(model.rowOf(FloorModel::Sort::Region, 2), -1);
}

void ModelsTest::everyReasonHasWords() {
    for (int kind = 0; kind <= static_cast<int>(guidance::CueKind::Warning); ++kind) {
        guidance::Cue cue;
        cue.kind = static_cast<guidance::CueKind>(kind);
        QVERIFY(!Words::cause(cue).isEmpty());
    }
    QVERIFY(Words::sureness(0.9, 0.5) != Words::sureness(0.3, 0.5));
    QVERIFY(Words::sureness(0.3, 0.5) != Words::sureness(0.1, 0.5));
}

// The reasons are stable words in core's sources: each that stands there must have words of its own here.
void ModelsTest::everyRejectionHasWords() {
    const QStringList files{QStringLiteral("core/recognition/door_detector.cpp"),
                            QStringLiteral("core/recognition/stairs_detector.cpp"),
                            QStringLiteral("core/recognition/rectangle_detector.cpp"),
                            QStringLiteral("core/recognition/text_reader.cpp"),
                            QStringLiteral("core/recognition/object_matcher.cpp"),
                            QStringLiteral("core/recognition/place_matcher.cpp"),
                            QStringLiteral("core/recognition/landmark_tracker.cpp"),
                            QStringLiteral("core/recognition/quad_flow.cpp"),
                            QStringLiteral("core/recognition/sign_detector.cpp"),
                            QStringLiteral("core/recognition/network_detector.cpp"),
                            QStringLiteral("core/session/perception.cpp")};
    const QRegularExpression word(QStringLiteral("\"([a-z]+(?:_[a-z]+)+)\""));
    QStringList reasons{QStringLiteral("blurred"),      QStringLiteral("narrow"),
                        QStringLiteral("grid"),         QStringLiteral("cut"),
                        QStringLiteral("contradicted"), QStringLiteral("unconfirmed")};
    for (const QString& name : files) {
        QFile file(QStringLiteral(FAROL_SOURCE_DIR "/") + name);
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(name));
        for (auto found = word.globalMatch(QString::fromUtf8(file.readAll())); found.hasNext();)
            reasons << found.next().captured(1);
    }
    reasons.removeDuplicates();
    QVERIFY(reasons.size() > 40);
    for (const QString& reason : reasons) {
        QVERIFY2(Words::knowsRejection(reason.toStdString()), qPrintable(reason));
    }
}

} // namespace farol::ui

QTEST_GUILESS_MAIN(farol::ui::ModelsTest)
#include "test_models.moc"
