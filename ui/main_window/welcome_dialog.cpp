#include "ui/main_window/welcome_dialog.h"

#include "ui/settings/settings.h"

#include <QCommandLinkButton>
#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

namespace farol::ui {

WelcomeDialog::WelcomeDialog(Settings& settings, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Welcome to Farol"));
    auto* layout = new QVBoxLayout(this);
    auto* title = new QLabel(tr("Welcome to Farol"), this);
    QFont large = title->font();
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * 1.5);
    title->setFont(large);
    auto* text =
        new QLabel(tr("Farol guides a blind person through a building with one camera. It needs a map of the "
                      "building, and landmarks that it was taught. What do you want to do?"),
                   this);
    text->setWordWrap(true);
    layout->addWidget(title);
    layout->addWidget(text);
    addChoice(tr("&Guide somebody"), tr("Open a map and a camera, and choose where to go"),
              &WelcomeDialog::walkWanted);
    addChoice(tr("Work on a &map"), tr("Bring in a floor plan, check it, and put landmarks on it"),
              &WelcomeDialog::mapWanted);
    addChoice(tr("Teach &landmarks"), tr("Photograph what Farol shall know again"),
              &WelcomeDialog::landmarksWanted);
    addChoice(tr("Read the &help"), tr("What each page is for, and its keys; F1 at any time"),
              &WelcomeDialog::helpWanted);
    auto* kiosk = new QLabel(
        tr("For a blind user who is alone, start “farol --kiosk”: full screen, by keys and speech."), this);
    kiosk->setWordWrap(true);
    layout->addWidget(kiosk);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::finished, &settings, &Settings::setFirstRunDone);
    setMinimumWidth(520);
}

void WelcomeDialog::addChoice(const QString& text, const QString& about, void (WelcomeDialog::*chosen)()) {
    auto* button = new QCommandLinkButton(text, about, this);
    button->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    button->setAccessibleDescription(about);
    layout()->addWidget(button);
    connect(button, &QCommandLinkButton::clicked, this, [this, chosen] {
        accept();
        Q_EMIT(this->*chosen)();
    });
}

} // namespace farol::ui
