#include "ui/training/training_actions.h"

#include "ui/convert/glyphs.h"
#include "ui/parts/naming.h"

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>
#include <QWidget>

namespace farol::ui {

TrainingActions::TrainingActions(QWidget& page, QUndoStack& steps)
    : QObject(&page), m_page(page), m_menu(new QMenu(&page)), m_bar(new QToolBar(&page)) {
    open = add(); // its key is the window's: it opens on the page that is shown
    fresh = add({QKeySequence::New});
    saveAs = add({Qt::CTRL | Qt::SHIFT | Qt::Key_S});
    m_menu->addSeparator();
    undo = add({QKeySequence::Undo});
    redo = add({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    m_menu->addSeparator();
    teach = add({Qt::CTRL | Qt::Key_T});
    addViews = add({Qt::CTRL | Qt::SHIFT | Qt::Key_T});
    edit = add({Qt::Key_F2});
    merge = add();
    split = add();
    removeViews = add();
    remove = add({QKeySequence::Delete});
    m_menu->addSeparator();
    place = add();
    check = add({Qt::Key_F7});
    walkHere = add();
    m_bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_bar->setIconSize({20, 20});
    m_bar->setMovable(false);
    m_bar->addActions({open, fresh});
    m_bar->addSeparator();
    m_bar->addActions({undo, redo});
    m_bar->addSeparator();
    m_bar->addActions({teach, addViews, edit, remove});
    m_bar->addSeparator();
    m_bar->addActions({place, check});
    for (QToolButton* button : m_bar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
    connect(undo, &QAction::triggered, &steps, &QUndoStack::undo);
    connect(redo, &QAction::triggered, &steps, &QUndoStack::redo);
    refreshIcons();
    retranslate();
}

QAction* TrainingActions::add(const QList<QKeySequence>& shortcuts) {
    auto* action = new QAction(this);
    action->setShortcuts(shortcuts);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_menu->addAction(action);
    m_page.addAction(action);
    return action;
}

QList<QAction*> TrainingActions::withKeys() const {
    QList<QAction*> found;
    for (QAction* action : m_menu->actions())
        if (!action->shortcut().isEmpty()) found << action;
    return found;
}

void TrainingActions::refreshIcons() {
    const QPalette palette = m_page.palette();
    open->setIcon(glyphIcon(Glyph::Library, palette));
    fresh->setIcon(glyphIcon(Glyph::Save, palette));
    undo->setIcon(glyphIcon(Glyph::Undo, palette));
    redo->setIcon(glyphIcon(Glyph::Redo, palette));
    teach->setIcon(glyphIcon(Glyph::Camera, palette));
    addViews->setIcon(glyphIcon(Glyph::ZoomIn, palette));
    edit->setIcon(glyphIcon(Glyph::Edit, palette));
    remove->setIcon(glyphIcon(Glyph::Remove, palette));
    place->setIcon(glyphIcon(Glyph::AddLandmark, palette));
    check->setIcon(glyphIcon(Glyph::Check, palette));
}

void TrainingActions::retranslate() {
    const auto& name = nameAction;
    m_menu->setTitle(tr("&Landmarks"));
    m_bar->setWindowTitle(tr("Landmarks"));
    m_bar->setAccessibleName(tr("Landmarks"));
    name(open, tr("&Open library…"), tr("Open"), tr("Open a landmark library"));
    name(fresh, tr("&New library…"), tr("New"), tr("Make an empty landmark library"));
    name(saveAs, tr("Save &as…"), tr("Save as"),
         tr("Write the library into another file; every change is saved by itself"));
    name(undo, tr("&Undo"), tr("Undo"), tr("Take back the last change"));
    name(redo, tr("&Redo"), tr("Redo"), tr("Make the change again that was taken back"));
    name(teach, tr("&Teach a landmark"), tr("Teach"), tr("Teach Farol a new landmark, step by step"));
    name(addViews, tr("Add &views"), tr("Add views"), tr("Teach more views of the chosen landmark"));
    name(edit, tr("&Change…"), tr("Change"), tr("Change the name, kind or size of the chosen landmark"));
    name(merge, tr("&Merge with…"), tr("Merge"), tr("Make the chosen landmark and another one the same"));
    name(split, tr("&Split…"), tr("Split"), tr("Make the chosen views a landmark of their own"));
    name(removeViews, tr("Delete the chosen vie&ws"), tr("Delete views"),
         tr("Forget the chosen views of the landmark"));
    name(remove, tr("&Delete"), tr("Delete"), tr("Forget the chosen landmark"));
    name(place, tr("&Put on the map…"), tr("On the map"), tr("Put the chosen landmark on the map"));
    name(check, tr("C&heck all"), tr("Check"),
         tr("Look how well each landmark is found and which are taken for each other"));
    name(walkHere, tr("Wal&k with this library"), tr("Walk"), tr("Use this library on the Walk page"));
}

} // namespace farol::ui
