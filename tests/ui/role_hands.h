#pragma once
// Hands of a person at the workstation: real keys and mouse events on the window that is shown, and answers
// to the dialogs that keep the one who opened them waiting.

#include "ui/map/map_view.h"
#include "ui/parts/place_chooser.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QTimer>

#include <functional>

class QAction;

namespace farol::ui::test {

constexpr int kPatience = 60000;

class Hands : public QObject {
public:
    /// Does nothing more once the test has failed, except that it shuts what would wait for ever.
    explicit Hands(QWidget& window);

    void key(int key, Qt::KeyboardModifiers modifiers = {}); ///< where the keyboard is
    void click(QAction* action);                             ///< on its button in a tool bar
    void press(QAbstractButton& button);
    void type(QWidget* field, const QString& text); ///< over what stands in it
    void choose(PlaceChooser& chooser, const QString& name);
    void clickOn(MapView& plan, Point2 at);
    void drag(QWidget& on, QPoint from, QPoint to);
    QPoint onScreen(const MapView& plan, Point2 at) const;

    template <class Dialog>
    static Dialog* open() {
        auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        return dialog && dialog->isVisible() ? dialog : nullptr;
    }

    /// Once a dialog of the kind is there. To be said before what opens it, if that waits for the answer.
    template <class Dialog>
    void answer(std::function<void(Dialog&)> with) {
        auto* watch = new QTimer(this);
        connect(watch, &QTimer::timeout, this, [watch, with = std::move(with)] {
            auto* dialog = open<Dialog>();
            if (!dialog) return;
            watch->stop(); // what follows runs the event loop
            with(*dialog);
            watch->deleteLater();
        });
        watch->start(20);
    }
    /// Types a name into the next dialog that asks for a file or a folder.
    void answerFile(const QString& path) { answerFiles({path}); }
    void answerFiles(const QStringList& paths);

private:
    void fill(QFileDialog& ask, const QString& text);

    QWidget& m_window;
    QTimer m_shut;
};

} // namespace farol::ui::test
