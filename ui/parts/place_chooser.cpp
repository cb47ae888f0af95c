#include "ui/parts/place_chooser.h"

#include "ui/convert/convert.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

namespace farol::ui {

PlaceChooser::PlaceChooser(RegionModel& regions, Purpose purpose, QWidget* parent)
    : QWidget(parent),
      m_regions(regions),
      m_purpose(purpose),
      m_label(new QLabel(this)),
      m_edit(new QLineEdit(this)),
      m_hint(new QLabel(this)) {
    m_filter.setSourceModel(&m_regions);
    auto* completer = new QCompleter(this);
    completer->setModel(&m_filter);
    completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion); // the filter has already chosen
    completer->setMaxVisibleItems(12);
    m_edit->setCompleter(completer);
    m_edit->setClearButtonEnabled(true);
    m_edit->installEventFilter(this);
    m_label->setBuddy(m_edit);
    m_hint->setVisible(false);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_label);
    layout->addWidget(m_edit, 1);
    layout->addWidget(m_hint);
    setFocusProxy(m_edit);

    connect(m_edit, &QLineEdit::textEdited, this, [this](const QString& text) {
        m_filter.setTyped(text);
        tell(!text.isEmpty() && m_filter.rowCount() == 0 ? tr("No such place") : QString());
        if (text.isEmpty()) choose(std::nullopt);
    });
    connect(m_edit, &QLineEdit::returnPressed, this, &PlaceChooser::confirmTyped);
    connect(completer, qOverload<const QModelIndex&>(&QCompleter::activated), this,
            [this](const QModelIndex& index) {
                choose(RegionId(toUtf8(index.data(RegionModel::IdRole).toString())));
            });
    connect(&m_regions, &QAbstractItemModel::modelReset, this, [this] { setChosen(std::nullopt); });
    retranslate();
}

void PlaceChooser::setChosen(const std::optional<RegionId>& region) {
    m_chosen = region;
    m_edit->setText(region ? m_regions.labelOf(*region) : QString());
    m_edit->setCursorPosition(0);
    m_filter.setTyped({});
    tell({});
}

void PlaceChooser::choose(const std::optional<RegionId>& region) {
    const bool same = region == m_chosen;
    setChosen(region);
    if (!same) Q_EMIT placeChosen(region);
}

void PlaceChooser::confirmTyped() {
    const QString text = m_edit->text();
    if (m_edit->completer()->popup()->isVisible() && m_edit->completer()->popup()->currentIndex().isValid())
        return;
    if (text.trimmed().isEmpty()) return choose(std::nullopt);
    if (m_chosen && text == m_regions.labelOf(*m_chosen)) return;
    m_filter.setTyped(text);
    // The first of several is not taken by itself: it could be the wrong room.
    if (m_filter.rowCount() == 1) {
        choose(RegionId(toUtf8(m_filter.index(0, 0).data(RegionModel::IdRole).toString())));
    } else if (m_filter.rowCount() == 0) {
        tell(tr("No such place"));
    } else {
        tell(tr("%n places fit: choose one", nullptr, m_filter.rowCount()));
        openList();
    }
}

void PlaceChooser::openList() {
    if (m_regions.rowCount() > 0) m_edit->completer()->complete();
}

void PlaceChooser::focusAndOpen() {
    m_edit->setFocus(Qt::ShortcutFocusReason);
    m_edit->selectAll();
    m_filter.setTyped({});
    openList();
}

QString PlaceChooser::hint() const {
    return m_hint->text();
}

void PlaceChooser::tell(const QString& hint) {
    m_hint->setText(hint);
    m_hint->setVisible(!hint.isEmpty());
    m_edit->setAccessibleDescription(hint);
}

bool PlaceChooser::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_edit && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Down && !m_edit->completer()->popup()->isVisible()) {
            if (m_chosen && m_edit->text() == m_regions.labelOf(*m_chosen)) m_filter.setTyped({});
            openList();
            return true;
        }
        if (key->key() == Qt::Key_Escape) setChosen(m_chosen);
    }
    if (watched == m_edit && event->type() == QEvent::FocusOut &&
        static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason)
        setChosen(m_chosen); // what was typed and not confirmed counts for nothing
    return QWidget::eventFilter(watched, event);
}

void PlaceChooser::nameClearButton(const QLineEdit& edit) {
    for (QToolButton* button : edit.findChildren<QToolButton*>())
        button->setAccessibleName(tr("Clear the line"));
}

void PlaceChooser::retranslate() {
    nameClearButton(*m_edit);
    switch (m_purpose) {
    case Purpose::Destination:
        m_label->setText(tr("&Go to:"));
        m_edit->setAccessibleName(tr("Destination"));
        m_edit->setPlaceholderText(tr("type a name or room number"));
        m_edit->setToolTip(tr("Where to go: type part of a name, room number or level, then choose"));
        break;
    case Purpose::Start:
        m_label->setText(tr("Start &at:"));
        m_edit->setAccessibleName(tr("Start"));
        m_edit->setPlaceholderText(tr("not known, Farol looks for it"));
        m_edit->setToolTip(tr("Where the walk starts, if you know it"));
        break;
    case Purpose::From:
        m_label->setText(tr("F&rom:"));
        m_edit->setAccessibleName(tr("From"));
        m_edit->setPlaceholderText(tr("type a name or room number"));
        m_edit->setToolTip(
            tr("Where the route begins: type part of a name, room number or level, then choose"));
        break;
    case Purpose::To:
        m_label->setText(tr("&To:"));
        m_edit->setAccessibleName(tr("To"));
        m_edit->setPlaceholderText(tr("type a name or room number"));
        m_edit->setToolTip(
            tr("Where the route ends: type part of a name, room number or level, then choose"));
        break;
    case Purpose::Side: // the form around it names the side
        m_label->hide();
        m_edit->setPlaceholderText(tr("none"));
        m_edit->setToolTip(tr("Type part of a name, room number or level, then choose"));
        break;
    }
}

void PlaceChooser::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
