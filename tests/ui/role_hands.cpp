#include "tests/ui/role_hands.h"

#include <QAbstractItemView>
#include <QAction>
#include <QCompleter>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>

namespace farol::ui::test {

Hands::Hands(QWidget& window) : m_window(window) {
    connect(&m_shut, &QTimer::timeout, this, [] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (dialog && QTest::currentTestFailed()) dialog->reject();
    });
    m_shut.start(100);
}

void Hands::key(int key, Qt::KeyboardModifiers modifiers) {
    QWidget* top = QApplication::activeModalWidget() ? QApplication::activeModalWidget() : &m_window;
    top->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(top));
    QTest::keyClick(top->focusWidget() ? top->focusWidget() : top, static_cast<Qt::Key>(key), modifiers);
}

void Hands::click(QAction* action) {
    for (QToolButton* button : m_window.findChildren<QToolButton*>())
        if (button->defaultAction() == action && button->isVisible()) return press(*button);
    QFAIL(qPrintable(action->text()));
}

void Hands::press(QAbstractButton& button) {
    QTRY_VERIFY2_WITH_TIMEOUT(button.isVisible() && button.isEnabled(), qPrintable(button.text()), kPatience);
    QTest::mouseClick(&button, Qt::LeftButton);
}

void Hands::type(QWidget* field, const QString& text) {
    QVERIFY(field);
    QTest::mouseClick(field, Qt::LeftButton);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
}

void Hands::choose(PlaceChooser& chooser, const QString& name) {
    type(&chooser.edit(), name);
    chooser.edit().completer()->popup()->hide();
    QTest::keyClick(&chooser.edit(), Qt::Key_Return);
}

QPoint Hands::onScreen(const MapView& plan, Point2 at) const {
    return plan.viewTransform().screenFromMap(at).toPoint();
}

void Hands::clickOn(MapView& plan, Point2 at) {
    QTest::mouseClick(&plan, Qt::LeftButton, {}, onScreen(plan, at));
}

void Hands::drag(QWidget& on, QPoint from, QPoint to) {
    QTest::mousePress(&on, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) QTest::mouseMove(&on, from + (to - from) * i / 10);
    QTest::mouseRelease(&on, Qt::LeftButton, {}, to);
}

void Hands::answerFiles(const QStringList& paths) {
    const QString text =
        paths.size() == 1 ? paths.first() : u'"' + paths.join(QStringLiteral("\" \"")) + u'"';
    answer<QFileDialog>([this, text](QFileDialog& ask) { fill(ask, text); });
}

void Hands::fill(QFileDialog& ask, const QString& text) {
    auto* name = ask.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    QVERIFY2(name, "the dialog is not Qt's own");
    name->setCompleter(nullptr);            // its list comes when it likes, and takes the next key for itself
    const auto hasKeyboard = [&ask, name] { // without it, what the list has chosen is written into the field
        if (!ask.isActiveWindow()) ask.activateWindow();
        name->setFocus(Qt::MouseFocusReason);
        return name->hasFocus();
    };
    QVERIFY(QTest::qWaitFor(hasKeyboard, kPatience));
    type(name, text);
    QCOMPARE(name->text(), text);
    auto* buttons = ask.findChild<QDialogButtonBox*>();
    for (QAbstractButton* button : buttons->buttons())
        if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) return press(*button);
    QFAIL("nothing to accept with");
}

} // namespace farol::ui::test
