// Room numbers, levels and short forms as voices read them aright.

#include "ui/speech/pronounced.h"

#include <QTest>

using farol::ui::spoken::pronounced;

class TestPronounced : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readsAsPeopleSay_data();
    void readsAsPeopleSay();
    void ordersAreLeftAlone();
};

void TestPronounced::readsAsPeopleSay_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("read");
    auto add = [](const char* language, const char* text, const char* read) {
        QTest::newRow(text) << QString::fromUtf8(language) << QString::fromUtf8(text)
                            << QString::fromUtf8(read);
    };
    add("en", "Room 2.04", "Room 2.04");
    add("en", "Room 2-14", "Room 2 14");
    add("en", "Room 1.204", "Room 1.204");
    add("en", "Lab. 3", "Lab 3");
    add("en", "No. 5", "number 5");
    add("pt", "Sala 2.04", "Sala 2.04");
    add("pt", "Sala 2-14", "Sala 2 14");
    add("pt_BR", "Sala 1.204", "Sala 1 204");
    add("pt", "1.º andar", "primeiro andar");
    add("pt", "Está aqui: Hall, 12.º piso.", "Está aqui: Hall, 12 piso.");
    add("pt", "3.ª porta", "terceira porta");
    add("pt", "Gabinete N.º 5", "Gabinete número 5");
    add("pt", "Dra. Costa", "Dra Costa");
    add("es", "2.ª planta", "segunda planta");
    add("es", "1er piso", "primer piso");
    add("fr", "2e étage", "deuxième étage");
    add("fr", "1er étage", "1er étage"); // which French voices know
    add("de", "1. Stock", "erster Stock");
    add("de", "2. OG", "zweites OG");
    add("de", "Zimmer 2-14", "Zimmer 2 14");
}

void TestPronounced::readsAsPeopleSay() {
    QFETCH(QString, language);
    QFETCH(QString, text);
    QTEST(pronounced(text, language), "read");
}

/// Stops between sentences, figures and hours are as they were.
void TestPronounced::ordersAreLeftAlone() {
    for (const char* text :
         {"In about 6 metres, turn right.", "Take the stairs up. 9 steps. At the top: level 2, Gallery.",
          "Turn 90 degrees to the left.", "You are here: Level minus 1."})
        QCOMPARE(pronounced(QString::fromUtf8(text), QStringLiteral("en")), QString::fromUtf8(text));
    const QString german = QStringLiteral("Gehen Sie die Treppe hinauf. 9 Stufen. Oben: Ebene 2.");
    QCOMPARE(pronounced(german, QStringLiteral("de")), german);
}

QTEST_GUILESS_MAIN(TestPronounced)
#include "test_pronounced.moc"
