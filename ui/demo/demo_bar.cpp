#include "ui/demo/demo_bar.h"

#include "ui/convert/convert.h"
#include "ui/convert/glyphs.h"
#include "ui/demo/demo.h"

#include <QAction>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <cmath>

namespace farol::ui {

DemoBar::DemoBar(QMainWindow& window, Demo& demo)
    : QObject(&window), m_window(window), m_demo(demo), m_menu(new QMenu(&window)) {
    const auto add = [this](const QKeySequence& key, bool checkable) {
        auto* action = new QAction(&m_window);
        action->setShortcut(key);
        action->setCheckable(checkable);
        m_menu->addAction(action);
        return action;
    };
    wrongTurn = add(Qt::Key_F2, false);
    cover = add(Qt::Key_F3, true);
    lightsOut = add(Qt::Key_F4, true);
    m_menu->addSeparator();
    nextVisitor = add(Qt::Key_F9, false);
    m_window.addToolBarBreak(); // beside the walk's own bar there is no room for it
    m_bar = m_window.addToolBar(QString());
    m_bar->setObjectName(QStringLiteral("demo"));
    m_bar->setMovable(false);
    m_bar->setContextMenuPolicy(Qt::PreventContextMenu);
    m_bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_bar->setIconSize({20, 20});
    m_bar->addActions({wrongTurn, cover, lightsOut, nextVisitor});
    for (QToolButton* button : m_bar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
    connect(wrongTurn, &QAction::triggered, &m_demo, &Demo::wrongTurn);
    connect(cover, &QAction::triggered, &m_demo, &Demo::setCovered);
    connect(lightsOut, &QAction::triggered, &m_demo, &Demo::setLightsOut);
    connect(nextVisitor, &QAction::triggered, &m_demo, &Demo::nextVisitor);
    connect(&m_demo, &Demo::changed, this, &DemoBar::refresh);
    m_window.installEventFilter(this);
    refreshIcons();
    retranslate();
    refresh();
}

void DemoBar::setPageShown(bool shown) {
    m_pageShown = shown;
    refresh();
}

void DemoBar::refresh() {
    const bool usable = m_demo.on() && m_pageShown;
    m_bar->setVisible(usable);
    m_menu->menuAction()->setVisible(usable);
    for (QAction* action : {wrongTurn, cover, lightsOut, nextVisitor}) action->setEnabled(usable);
    cover->setChecked(m_demo.covered());
    lightsOut->setChecked(m_demo.lightsOut());
}

void DemoBar::refreshIcons() {
    const QPalette palette = m_window.palette();
    wrongTurn->setIcon(glyphIcon(Glyph::WrongTurn, palette));
    cover->setIcon(glyphIcon(Glyph::Cover, palette));
    lightsOut->setIcon(glyphIcon(Glyph::Lamp, palette));
    nextVisitor->setIcon(glyphIcon(Glyph::Visitor, palette));
}

bool DemoBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_window && event->type() == QEvent::PaletteChange) refreshIcons();
    return QObject::eventFilter(watched, event);
}

QList<QAction*> DemoBar::withKeys() const {
    return {wrongTurn, cover, lightsOut, nextVisitor};
}

QString DemoBar::news() const {
    if (!m_demo.on() || !m_demo.visit()) return {};
    const building::Building* map = m_demo.building();
    const simulation::Visit& visit = *m_demo.visit();
    const QString goal = regionName(map, visit.to);
    if (m_demo.over() && m_demo.arrived())
        return tr("Visitor %1 arrived at %2 after %3. The next one comes in a moment.")
            .arg(m_demo.visitor())
            .arg(goal, clockText(std::floor(m_demo.seconds())).section(QLatin1Char('.'), 0, 0));
    if (m_demo.over())
        return tr("Visitor %1 did not come to %2 and was fetched. The next one comes in a moment.")
            .arg(m_demo.visitor())
            .arg(goal);
    return tr("A simulated building and camera. Visitor %1 wants to go from %2 to %3 (%4 m) and hears only "
              "what is said. Choose another destination at any time.")
        .arg(m_demo.visitor())
        .arg(regionName(map, visit.from), goal)
        .arg(std::lround(visit.metres));
}

void DemoBar::retranslate() {
    const auto name = [](QAction* action, const QString& text, const QString& brief, const QString& tip) {
        action->setText(text);
        action->setIconText(brief);
        action->setToolTip(
            QStringLiteral("%1 (%2)").arg(tip, action->shortcut().toString(QKeySequence::NativeText)));
        action->setStatusTip(tip);
    };
    m_menu->setTitle(tr("&Demo"));
    m_bar->setWindowTitle(tr("Demo"));
    m_bar->setAccessibleName(tr("Demo"));
    name(wrongTurn, tr("&Wrong turn"), tr("Wrong turn"), tr("The walker takes another way than was said"));
    name(cover, tr("&Cover the camera"), tr("Cover camera"), tr("A hand lies on the simulated camera"));
    name(lightsOut, tr("&Lights out"), tr("Lights out"), tr("Nearly dark in the whole building"));
    name(nextVisitor, tr("&Next visitor"), tr("Next visitor"),
         tr("End this walk; somebody else comes with another destination"));
    refresh();
}

} // namespace farol::ui
