#include "ui/main_window/help_dialog.h"

#include "ui/convert/glyphs.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QListWidget>
#include <QSplitter>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace farol::ui {

namespace {

QString picture(const char* name) {
    return QStringLiteral("<img src=\"glyph:%1\" width=\"20\" height=\"20\">").arg(QLatin1String(name));
}

struct Named {
    const char* name;
    Glyph glyph;
};

constexpr Named kPictures[]{{"map", Glyph::Map},   {"library", Glyph::Library},  {"camera", Glyph::Camera},
                            {"play", Glyph::Play}, {"here", Glyph::AddLandmark}, {"wrong", Glyph::Clear},
                            {"say", Glyph::Sound}, {"record", Glyph::Record},    {"check", Glyph::Check},
                            {"undo", Glyph::Undo}, {"alike", Glyph::Alike}};

} // namespace

HelpDialog::HelpDialog(QWidget* parent)
    : QDialog(parent), m_chapters(new QListWidget(this)), m_text(new QTextBrowser(this)) {
    setWindowTitle(tr("Help"));
    m_chapters->setAccessibleName(tr("Chapters"));
    m_chapters->setToolTip(tr("What the help is about"));
    m_chapters->addItems({tr("Walk page"), tr("Map page"), tr("Landmarks page"), tr("Kiosk")});
    m_text->setAccessibleName(tr("Text of the chapter"));
    m_text->setTabChangesFocus(true);
    m_text->setOpenExternalLinks(true);
    drawPictures();
    auto* halves = new QSplitter(Qt::Horizontal, this);
    halves->addWidget(m_chapters);
    halves->addWidget(m_text);
    halves->setStretchFactor(1, 1);
    halves->setSizes({250, 560});
    halves->setChildrenCollapsible(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_chapters, &QListWidget::currentRowChanged, this, &HelpDialog::showChapter);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(halves, 1);
    layout->addWidget(buttons);
    m_chapters->setCurrentRow(0);
    resize(840, 560);
}

void HelpDialog::showPage(Page page) {
    m_chapters->setCurrentRow(static_cast<int>(page));
}

void HelpDialog::drawPictures() {
    for (const Named& one : kPictures)
        m_text->document()->addResource(QTextDocument::ImageResource,
                                        QUrl(QStringLiteral("glyph:%1").arg(QLatin1String(one.name))),
                                        glyphIcon(one.glyph, palette()).pixmap(20, 20));
}

void HelpDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) { // from light to dark while it is open
        drawPictures();
        showChapter(m_chapters->currentRow());
    }
    QDialog::changeEvent(event);
}

QString HelpDialog::text() const {
    return m_text->toPlainText();
}

void HelpDialog::showChapter(int chapter) {
    QStringList parts;
    const auto item = [&](const char* glyph, const QString& text) {
        parts << QStringLiteral("<table cellspacing=\"0\" cellpadding=\"4\"><tr><td valign=\"middle\">%1</td>"
                                "<td valign=\"middle\">%2</td></tr></table>")
                     .arg(picture(glyph), text);
    };
    const auto plain = [&](const QString& text) { parts << QStringLiteral("<p>%1</p>").arg(text); };
    parts
        << QStringLiteral("<h2>%1</h2>").arg(m_chapters->item(std::max(0, chapter))->text().toHtmlEscaped());
    switch (chapter) {
    case 1:
        plain(tr("Here a map of a building is opened or brought in, looked at, checked and changed. The plan "
                 "and the table show the same: what is chosen in one is chosen in the other."));
        item("check", tr("F7 looks for what is wrong with the map and says what to do about each finding."));
        item("alike",
             tr("Ctrl+U marks places that the landmarks cannot tell apart. A landmark there helps most."));
        plain(tr(
            "Ctrl+Shift+U marks from where no landmark is seen, and Ctrl+Shift+N lists the routes that are "
            "missing. Ctrl+Shift+I lays the image of a floor plan under the floor: click two points of it "
            "and where they belong."));
        item("here", tr("Ctrl+Shift+L puts a landmark on the plan, Ctrl+Shift+D a door. Drag what is chosen, "
                        "or move it with Alt and the arrows."));
        item("undo", tr("Ctrl+Z takes every step back. Nothing is written until you save with Ctrl+S."));
        break;
    case 2:
        plain(tr(
            "Here Farol is taught what it shall know again. Every change is saved by itself and can be taken "
            "back with Ctrl+Z; a landmark that is not finished is kept, also when the computer stops."));
        item("camera", tr("Ctrl+T teaches a landmark in four steps: what it is, its views, a trial, its "
                          "place on the map."));
        plain(tr("Take a view from the front, from the left, from the right and from farther away. The coach "
                 "says what is wrong with a picture and which one comes next. Drag the four corners onto the "
                 "landmark; by keys, 1 to 4 choose a corner and the arrows move it."));
        item(
            "check",
            tr("F7 checks the whole library: how well each landmark is found, how far away, how far aside, "
               "and which are taken for each other. Merge what is the same, and add views to what is lost."));
        break;
    case 3:
        plain(
            tr("The kiosk is for a blind user who is alone: “farol --kiosk” fills the screen and says "
               "everything. Arrows and Enter choose a destination, F searches by name, digits by number; F1 "
               "says all keys, Escape goes back."));
        plain(tr(
            "Space repeats, W says where you are, A what is around you, N what comes next, L the whole "
            "way. M is quiet, plus and minus change the speed of the voice, F2 the language, F4 goes over to "
            "two keys only. Hold Escape to leave."));
        break;
    default:
        plain(tr("Here somebody is guided, and you watch: what the camera sees, the place on the map, what "
                 "is said, and why."));
        item("map", tr("Ctrl+O opens the map of the building."));
        item("library", tr("Ctrl+L opens the landmarks that belong to it."));
        item("camera",
             tr("Ctrl+P chooses a camera, a video or a folder of pictures, and Ctrl+G where to go."));
        item("play", tr("F5 starts and holds the walk, F8 goes on by one picture."));
        item("here",
             tr("When the place shown is not right, choose the right one on the map and press Ctrl+H."));
        item("wrong", tr("Ctrl+W gives the place up, so that it is looked for anew."));
        item("say", tr("Ctrl+E speaks a sentence that you type."));
        item("record", tr("Ctrl+Shift+R records the next walk. A recorded walk can be worked out anew in "
                          "another way and compared, from the Walk menu."));
        plain(tr("The timeline at the bottom looks back: drag it, or use the arrow keys. “Why there” "
                 "explains the vote of the place that is chosen in the list."));
        break;
    }
    m_text->setHtml(parts.join(QString()));
}

} // namespace farol::ui
