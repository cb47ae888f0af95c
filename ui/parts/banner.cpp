#include "ui/parts/banner.h"

#include "ui/convert/glyphs.h"
#include "ui/convert/kind_style.h"

#include <QAccessible>
#include <QAccessibleEvent>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace farol::ui {

Banner::Banner(QWidget* parent)
    : QFrame(parent),
      m_kind(new QLabel(this)),
      m_label(new QLabel(this)),
      m_action(new QPushButton(this)),
      m_close(new QToolButton(this)) {
    setAutoFillBackground(true);
    setFrameShape(QFrame::NoFrame);
    QFont bold = m_kind->font();
    bold.setBold(true);
    m_kind->setFont(bold);
    m_label->setWordWrap(true);
    m_label->setTextFormat(Qt::PlainText);
    m_label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setAutoRaise(true);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 3, 6, 3);
    layout->setSpacing(8);
    layout->addWidget(m_kind);
    layout->addWidget(m_label, 1);
    layout->addWidget(m_action);
    layout->addWidget(m_close);
    connect(m_close, &QToolButton::clicked, this, &Banner::closed);
    connect(m_action, &QPushButton::clicked, this, [this] {
        if (m_text.act) m_text.act();
    });
}

void Banner::show(BannerText text) {
    m_text = std::move(text);
    m_label->setText(m_text.text);
    m_label->setToolTip(m_text.text);
    m_action->setText(m_text.action);
    m_action->setVisible(!m_text.action.isEmpty());
    m_action->setToolTip(m_text.action);
    m_close->setVisible(m_text.closable);
    colour();
    retranslate();
    QWidget::show();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

QString Banner::text() const {
    return m_label->text();
}

void Banner::colour() {
    const bool dark = isDark(parentWidget() ? parentWidget()->palette() : palette());
    QColor back;
    switch (m_text.kind) {
    case BannerKind::Note:
        back = dark ? QColor(0x17324d) : QColor(0xdcebfa);
        break;
    case BannerKind::Warning:
        back = dark ? QColor(0x4d3a0c) : QColor(0xffecc2);
        break;
    case BannerKind::Problem:
        back = dark ? QColor(0x5a1a22) : QColor(0xfbd9dc);
        break;
    }
    QPalette colours = parentWidget() ? parentWidget()->palette() : palette();
    const QColor ink = readableOn(back);
    colours.setColor(QPalette::Window, back);
    colours.setColor(QPalette::WindowText, ink);
    m_kind->setPalette(colours);
    m_label->setPalette(colours);
    QPalette icon = colours;
    icon.setColor(QPalette::ButtonText, ink);
    m_close->setIcon(glyphIcon(Glyph::Clear, icon));
    setPalette(colours);
}

void Banner::retranslate() {
    switch (m_text.kind) {
    case BannerKind::Note:
        m_kind->setText(tr("Note"));
        break;
    case BannerKind::Warning:
        m_kind->setText(tr("Attention"));
        break;
    case BannerKind::Problem:
        m_kind->setText(tr("Problem"));
        break;
    }
    setAccessibleName(QStringLiteral("%1: %2").arg(m_kind->text(), m_text.text));
    m_action->setAccessibleName(m_text.action);
    m_close->setAccessibleName(tr("Close this message"));
    m_close->setToolTip(tr("Close this message"));
}

void Banner::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QFrame::changeEvent(event);
}

BannerStack::BannerStack(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(1);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

void BannerStack::show(const QString& key, BannerText text) {
    Banner* banner = m_banners.value(key);
    if (!banner) {
        banner = new Banner(this);
        m_banners.insert(key, banner);
        m_layout->addWidget(banner);
        connect(banner, &Banner::closed, this, [this, key] { hide(key); });
    }
    banner->show(std::move(text));
}

void BannerStack::hide(const QString& key) {
    Banner* banner = m_banners.take(key);
    if (!banner) return;
    banner->setVisible(false);
    banner->deleteLater(); // its own button may have called us
}

void BannerStack::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange)
        for (Banner* banner : std::as_const(m_banners)) banner->colour();
    QWidget::changeEvent(event);
}

QString BannerStack::text(const QString& key) const {
    const Banner* banner = m_banners.value(key);
    return banner ? banner->text() : QString();
}

} // namespace farol::ui
