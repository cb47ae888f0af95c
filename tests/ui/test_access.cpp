// A tour of every page, dialog and step. For who uses a screen reader or the keyboard alone each control has
// a name and a role, and Tab comes to each of them and round again; the list is printed. For who reads, no
// text is clipped, in any language, at two sizes of the window. Where FAROL_SHOTS names a folder, everything
// is also saved as a picture, light and dark, to be looked at.

#include "tests/ui/clipped_text.h"
#include "tests/ui/desk_tour.h"
#include "ui/convert/palettes.h"
#include "ui/speech/phrasebook.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QMetaEnum>
#include <QTest>

#include <cstdio>

namespace farol::ui {

namespace {

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
    void everyControlIsNamedAndReached();
    void noTextIsClipped_data();
    void noTextIsClipped();

private:
    void look(QWidget& top, const char* name);
    void walkByTab(QWidget& top, const char* name);
    void shots(QWidget& top, const QString& name);

    test::DeskTour m_tour;
    int m_controls = 0;
};

/// Names and roles, as a screen reader gets them.
void AccessTest::look(QWidget& top, const char* name) {
    const QList<QWidget*> all = controls(top);
    QVERIFY2(!all.isEmpty(), name);
    m_controls += static_cast<int>(all.size());
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
                 qPrintable(QStringLiteral("%1: Tab comes to %2 (%3) twice")
                                .arg(QLatin1String(name), focus->accessibleName(),
                                     QLatin1String(focus->metaObject()->className()))));
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

void AccessTest::shots(QWidget& top, const QString& name) {
    const QDir folder(qEnvironmentVariable("FAROL_SHOTS"));
    if (qEnvironmentVariableIsEmpty("FAROL_SHOTS")) return;
    folder.mkpath(name.section(QLatin1Char('/'), 0, 0));
    for (const bool dark : {false, true}) {
        QApplication::setPalette(dark ? darkPalette() : lightPalette());
        QApplication::processEvents();
        const QString file =
            QStringLiteral("%1-%2%3.png").arg(name).arg(top.width()).arg(QLatin1String(dark ? "-dark" : ""));
        top.grab().save(folder.filePath(file));
    }
    QApplication::setPalette(QPalette());
}

void AccessTest::everyControlIsNamedAndReached() {
    int views = 0;
    const QString wrong = m_tour.go(QStringLiteral("en"), [&](QWidget& top, const QString& name) {
        if (QTest::currentTestFailed()) return;
        ++views;
        if (name.startsWith(QLatin1String("kiosk")))
            return; // every key speaks there, Tab too: see its own test
        look(top, qPrintable(name));
        if (!QTest::currentTestFailed()) walkByTab(top, qPrintable(name));
    });
    if (QTest::currentTestFailed()) return;
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    std::printf("%d controls in %d views\n", m_controls, views);
    QVERIFY(views > 40);
}

void AccessTest::noTextIsClipped_data() {
    QTest::addColumn<QString>("language");
    for (const Language& language : languages()) QTest::newRow(qPrintable(language.code)) << language.code;
}

void AccessTest::noTextIsClipped() {
    QFETCH(QString, language);
    QStringList clipped;
    const QString wrong = m_tour.go(language, [&](QWidget& top, const QString& name) {
        const bool isDialog = qobject_cast<QDialog*>(&top) != nullptr;
        for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
            if (!isDialog) {
                top.resize(size);
                QTRY_COMPARE(top.size(), size); // else something in it asks for more room
                QApplication::processEvents();
            }
            for (const QString& text : test::clippedTexts(top))
                clipped << QStringLiteral("%1 %2 %3: %4").arg(language, name).arg(top.width()).arg(text);
            shots(top, language + QLatin1Char('/') + name);
            if (isDialog) break;
        }
        if (!isDialog) top.resize(1280, 800);
    });
    clipped.removeDuplicates();
    for (const QString& line : clipped) std::printf("%s\n", qPrintable(line));
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    QVERIFY2(clipped.isEmpty(), qPrintable(clipped.value(0)));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::AccessTest)
#include "test_access.moc"
