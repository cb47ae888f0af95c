// What the sighted assistant does during a walk: corrects a place, says something, saves what was seen.

#include "ui/convert/convert.h"
#include "ui/live/frame_panel.h"
#include "ui/live/revote_dialog.h"
#include "ui/main_window/figures_dialog.h"
#include "ui/main_window/localiser_menu.h"
#include "ui/main_window/main_window.h"
#include "ui/parts/banner.h"
#include "ui/training/library_panel.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>
#include <QPixmap>
#include <QSaveFile>

namespace farol::ui {

namespace {

const QString kSaved = QStringLiteral("saved");
const QString kCorrected = QStringLiteral("corrected");

bool written(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return false;
    // commit() alone forgets that the last bytes could not be written, and puts a cut file in place.
    if (file.write(bytes) != bytes.size() || !file.flush()) file.cancelWriting();
    return file.commit();
}

} // namespace

void MainWindow::saveFile(const QString& caption, const QString& suggestion, const QString& filter,
                          const std::function<bool(const QString&)>& write) {
    auto* ask = new QFileDialog(this, caption, m_settings.recordingFolder(), filter);
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setAcceptMode(QFileDialog::AcceptSave);
    ask->selectFile(suggestion);
    ask->setDefaultSuffix(QFileInfo(suggestion).suffix());
    connect(ask, &QFileDialog::fileSelected, this, [this, write](const QString& file) {
        const QString shown = QDir::toNativeSeparators(file);
        if (write(file))
            m_page->banners().show(kSaved, {BannerKind::Note, tr("Saved in %1").arg(shown), {}, {}, true});
        else
            m_page->banners().show(kSaved, {BannerKind::Problem,
                                            tr("%1 cannot be written. Choose another folder.").arg(shown),
                                            {},
                                            {},
                                            true});
    });
    ask->open();
}

void MainWindow::connectSupervision() {
    const WindowActions& a = *m_actions;
    const auto tell = [this](BannerKind kind, const QString& text) {
        m_page->banners().show(kCorrected, {kind, text, {}, {}, true});
    };
    connect(a.here, &QAction::triggered, this, [this, tell] {
        const std::optional<RegionId> region = m_page->chosenRegion();
        if (!m_walk.active()) return tell(BannerKind::Warning, tr("There is no walk to correct."));
        if (!region)
            return tell(BannerKind::Warning,
                        tr("Choose a place on the map, or in the list “Where it could be”, first."));
        m_walk.correct(region);
        tell(BannerKind::Note,
             tr("The user is in %1: told by you.").arg(regionName(m_walk.building().get(), *region)));
    });
    connect(a.wrong, &QAction::triggered, this, [this, tell] {
        if (!m_walk.active()) return tell(BannerKind::Warning, tr("There is no walk to correct."));
        m_walk.correct(std::nullopt);
        tell(BannerKind::Note, tr("The place is given up and looked for anew."));
    });
    connect(&m_walk, &Walk::walkBegan, this, [this] {
        m_page->banners().hide(kCorrected);
        m_calibration = {};
    });
    connect(a.figures, &QAction::triggered, this, [this] {
        auto* dialog =
            new FiguresDialog({Figures::votes(m_page->timeline(), m_walk.building().get()),
                               Figures::latency(m_page->timeline()), Figures::calibration(m_calibration),
                               Figures::ranges(m_trainingPage->panel().confusion().checks())},
                              this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    connect(a.sayThis, &QAction::triggered, this, [this] {
        auto* ask = new QInputDialog(this);
        ask->setAttribute(Qt::WA_DeleteOnClose);
        ask->setWindowTitle(tr("Say this"));
        ask->setLabelText(tr("Sentence that is spoken to the user:"));
        ask->setOkButtonText(tr("&Say it"));
        connect(ask, &QInputDialog::textValueSelected, this, [this](const QString& text) {
            if (!text.trimmed().isEmpty()) m_speech.say(text.trimmed());
        });
        ask->open();
        for (QLineEdit* line : ask->findChildren<QLineEdit*>()) line->setMinimumWidth(440); // a sentence
    });
    connect(a.revote, &QAction::triggered, this, [this] {
        QList<std::pair<QString, QString>> names;
        for (const QAction* choice : m_localisers->actions())
            names << std::pair(choice->data().toString(), choice->text().remove(QLatin1Char('&')));
        auto* dialog = new RevoteDialog(m_settings.recordingFolder(), names, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    connect(a.savePicture, &QAction::triggered, this, [this] {
        const QPixmap picture = m_page->framePanel().view().grab();
        saveFile(tr("Save the picture"), QStringLiteral("picture.png"),
                 tr("Pictures (%1)").arg(QStringLiteral("*.png *.jpg")),
                 [picture](const QString& file) { return picture.save(file); });
    });
    connect(a.saveWalk, &QAction::triggered, this, [this] {
        const QByteArray table = m_page->timeline().csv(m_walk.building().get());
        saveFile(tr("Save the walk as table"), QStringLiteral("walk.csv"),
                 tr("Tables (%1)").arg(QStringLiteral("*.csv")),
                 [table](const QString& file) { return written(file, table); });
    });
}

} // namespace farol::ui
