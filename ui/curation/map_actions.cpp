#include "ui/curation/map_actions.h"

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

MapActions::MapActions(QWidget& page, QUndoStack& steps)
    : QObject(&page), m_page(page), m_steps(steps), m_menu(new QMenu(&page)), m_bar(new QToolBar(&page)) {
    open = add(); // its key is the window's: it opens on the page that is shown
    import = add({Qt::CTRL | Qt::Key_I});
    save = add({QKeySequence::Save});
    saveAs = add({Qt::CTRL | Qt::SHIFT | Qt::Key_S});
    print = add();
    m_menu->addSeparator();
    undo = add({QKeySequence::Undo});
    redo = add({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    m_menu->addSeparator();
    addLandmark = add({Qt::CTRL | Qt::SHIFT | Qt::Key_L});
    addAccess = add({Qt::CTRL | Qt::SHIFT | Qt::Key_D});
    edit = add({Qt::Key_F2});
    remove = add({QKeySequence::Delete});
    m_menu->addSeparator();
    routeFrom = add({Qt::CTRL | Qt::Key_B});
    routeTo = add({Qt::CTRL | Qt::Key_G});
    m_menu->addSeparator();
    find = add({QKeySequence::Find});
    check = add({Qt::Key_F7});
    nextFeature = add({Qt::Key_F4});
    ambiguity = add({Qt::CTRL | Qt::Key_U}, true);
    coverage = add({Qt::CTRL | Qt::SHIFT | Qt::Key_U}, true);
    missing = add({Qt::CTRL | Qt::SHIFT | Qt::Key_N});
    picture = add({Qt::CTRL | Qt::SHIFT | Qt::Key_I});
    m_menu->addSeparator();
    walkHere = add();
    m_bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_bar->setIconSize({20, 20});
    m_bar->setMovable(false);
    m_bar->addActions({open, import, save});
    m_bar->addSeparator();
    m_bar->addActions({undo, redo});
    m_bar->addSeparator();
    m_bar->addActions({addLandmark, addAccess, edit, remove});
    m_bar->addSeparator();
    m_bar->addActions({check, ambiguity, print});
    for (QToolButton* button : m_bar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
    const auto canUndo = [this] {
        undo->setEnabled(m_steps.canUndo());
        redo->setEnabled(m_steps.canRedo());
    };
    connect(&m_steps, &QUndoStack::indexChanged, this, canUndo);
    connect(undo, &QAction::triggered, &m_steps, &QUndoStack::undo);
    connect(redo, &QAction::triggered, &m_steps, &QUndoStack::redo);
    canUndo();
    refreshIcons();
    retranslate();
}

QAction* MapActions::add(const QList<QKeySequence>& shortcuts, bool checkable) {
    auto* action = new QAction(this);
    action->setShortcuts(shortcuts);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setCheckable(checkable);
    m_menu->addAction(action);
    m_page.addAction(action);
    return action;
}

QList<QAction*> MapActions::withKeys() const {
    QList<QAction*> found;
    for (QAction* action : m_menu->actions())
        if (!action->shortcut().isEmpty()) found << action;
    return found;
}

void MapActions::refreshIcons() {
    const QPalette palette = m_page.palette();
    open->setIcon(glyphIcon(Glyph::Map, palette));
    import->setIcon(glyphIcon(Glyph::Import, palette));
    save->setIcon(glyphIcon(Glyph::Save, palette));
    undo->setIcon(glyphIcon(Glyph::Undo, palette));
    redo->setIcon(glyphIcon(Glyph::Redo, palette));
    addLandmark->setIcon(glyphIcon(Glyph::AddLandmark, palette));
    addAccess->setIcon(glyphIcon(Glyph::AddDoor, palette));
    edit->setIcon(glyphIcon(Glyph::Edit, palette));
    remove->setIcon(glyphIcon(Glyph::Remove, palette));
    check->setIcon(glyphIcon(Glyph::Check, palette));
    ambiguity->setIcon(glyphIcon(Glyph::Alike, palette));
    print->setIcon(glyphIcon(Glyph::Print, palette));
}

void MapActions::retranslate() {
    const auto& name = nameAction;
    m_menu->setTitle(tr("&Map"));
    m_bar->setWindowTitle(tr("Map"));
    m_bar->setAccessibleName(tr("Map"));
    name(open, tr("&Open map…"), tr("Open"), tr("Open the map of a building to look at it and change it"));
    name(import, tr("&Import…"), tr("Import"), tr("Bring in a map of another kind"));
    name(save, tr("&Save"), tr("Save"), tr("Write the changes into the map's file"));
    name(saveAs, tr("S&ave as…"), tr("Save as"), tr("Write the map into another file"));
    name(print, tr("&Print as PDF…"), tr("PDF"), tr("Write the plan of each level as a page of a PDF"));
    name(undo, tr("&Undo"), tr("Undo"), tr("Take back the last change"));
    name(redo, tr("&Redo"), tr("Redo"), tr("Make the change again that was taken back"));
    name(addLandmark, tr("Add &landmark"), tr("Landmark"), tr("Put a new landmark on the plan"));
    name(addAccess, tr("Add &door or passage"), tr("Door"), tr("Put a new door or passage on the plan"));
    name(edit, tr("&Change…"), tr("Change"), tr("Change name, kind and the like of what is chosen"));
    name(remove, tr("D&elete"), tr("Delete"), tr("Take the chosen landmark, door or passage off the map"));
    name(routeFrom, tr("Route &from here"), tr("From here"), tr("Let the route begin in the chosen place"));
    name(routeTo, tr("Route &to here"), tr("To here"), tr("Let the route end in the chosen place"));
    name(find, tr("Sea&rch the table"), tr("Search"), tr("Search the table of attributes"));
    name(check, tr("C&heck the map"), tr("Check"), tr("Look for what is wrong with the map as it is now"));
    name(nextFeature, tr("&Next feature"), tr("Next"), tr("Show the next feature of the chosen finding"));
    name(ambiguity, tr("Places that look ali&ke"), tr("Alike"),
         tr("Mark the places that the landmarks cannot tell apart, and those without any"));
    name(coverage, tr("Where landmarks are see&n"), tr("Seen"),
         tr("Mark from where landmarks can be seen, and from where none can"));
    name(missing, tr("&Missing routes…"), tr("Missing routes"),
         tr("List the places between which no route leads, and why"));
    name(picture, tr("Floor-plan ima&ge…"), tr("Image"),
         tr("Lay the image of a floor plan under the floor that is shown"));
    name(walkHere, tr("&Walk with this map"), tr("Walk"), tr("Use the saved map on the Walk page"));
}

} // namespace farol::ui
