#include "ui/main_window/help_dialog.h"

#include "ui/convert/glyphs.h"
#include "ui/kiosk/kiosk_machine.h"
#include "ui/main_window/page_picture.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QListWidget>
#include <QSplitter>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace farol::ui {

namespace {

constexpr int kViewWidth = 520; // pixels, of a page's picture

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

QString item(const char* glyph, const QString& text) {
    return QStringLiteral("<table cellspacing=\"0\" cellpadding=\"4\"><tr><td valign=\"middle\">%1</td>"
                          "<td valign=\"middle\">%2</td></tr></table>")
        .arg(picture(glyph), text);
}

QString plain(const QString& text) {
    return QStringLiteral("<p>%1</p>").arg(text);
}

} // namespace

HelpDialog::HelpDialog(const std::vector<QWidget*>& pages, QWidget* parent)
    : QDialog(parent),
      m_pages(pages.begin(), pages.end()),
      m_chapters(new QListWidget(this)),
      m_text(new QTextBrowser(this)) {
    m_chapters->addItems({QString(), QString(), QString(), QString()});
    m_text->setTabChangesFocus(true);
    m_text->setOpenExternalLinks(true);
    drawPictures();
    auto* halves = new QSplitter(Qt::Horizontal, this);
    halves->addWidget(m_chapters);
    halves->addWidget(m_text);
    halves->setStretchFactor(1, 1);
    halves->setSizes({230, 580});
    halves->setChildrenCollapsible(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_chapters, &QListWidget::currentRowChanged, this, &HelpDialog::showChapter);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(halves, 1);
    layout->addWidget(buttons);
    m_chapters->setCurrentRow(0);
    retranslate();
    resize(870, 640);
}

void HelpDialog::retranslate() {
    setWindowTitle(tr("Help"));
    m_chapters->setAccessibleName(tr("Chapters"));
    m_chapters->setToolTip(tr("What the help is about"));
    const QStringList titles{tr("Walk page"), tr("Map page"), tr("Landmarks page"), tr("Kiosk")};
    for (int i = 0; i < titles.size(); ++i) m_chapters->item(i)->setText(titles[i]);
    m_text->setAccessibleName(tr("Text of the chapter"));
    showChapter(m_chapters->currentRow());
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
    } else if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QDialog::changeEvent(event);
}

QString HelpDialog::text() const {
    return m_text->toPlainText();
}

void HelpDialog::showChapter(int chapter) {
    const QString title = m_chapters->item(std::max(0, chapter))->text().toHtmlEscaped();
    const QString text = chapter == 1   ? mapChapter()
                         : chapter == 2 ? landmarksChapter()
                         : chapter == 3 ? kioskChapter()
                                        : walkChapter();
    m_text->setHtml(QStringLiteral("<h2>%1</h2>").arg(title) + text);
}

/// The page itself, smaller, with the names of its parts below.
QString HelpDialog::pageView(Page page) {
    const auto index = static_cast<std::size_t>(page);
    if (index >= m_pages.size() || !m_pages[index]) return {};
    const PagePicture view = pictureOf(*m_pages[index], kViewWidth);
    if (view.picture.isNull()) return {};
    const QUrl url(QStringLiteral("page:%1").arg(index));
    m_text->document()->addResource(QTextDocument::ImageResource, url, view.picture);
    QStringList names;
    for (qsizetype i = 0; i < view.parts.size(); ++i)
        names << QStringLiteral("<b>%1</b>&nbsp;%2")
                     .arg(i + 1)
                     .arg(view.parts[i].toHtmlEscaped().replace(QLatin1Char(' '), QStringLiteral("&nbsp;")));
    return QStringLiteral("<p><img src=\"%1\" width=\"%2\"></p><p>%3</p>")
        .arg(url.toString())
        .arg(kViewWidth)
        .arg(names.join(QStringLiteral("&nbsp;&nbsp; ")));
}

QString HelpDialog::walkChapter() {
    return plain(
               tr("Here somebody is guided, and you watch: what the camera sees, the place on the map, what "
                  "is said, and why.")) +
           pageView(Page::Walk) + item("map", tr("Ctrl+O opens the map of the building.")) +
           item("library", tr("Ctrl+L opens the landmarks that belong to it.")) +
           item("camera",
                tr("Ctrl+P chooses a camera, a video or a folder of pictures, and Ctrl+G where to go.")) +
           item("play", tr("F5 starts and holds the walk, F8 goes on by one picture.")) +
           item("here",
                tr("When the place shown is not right, choose the right one on the map and press Ctrl+H.")) +
           item("wrong", tr("Ctrl+W gives the place up, so that it is looked for anew.")) +
           item("say", tr("Ctrl+E speaks a sentence that you type.")) +
           item("record", tr("Ctrl+Shift+R records the next walk. A recorded walk can be worked out anew in "
                             "another way and compared, from the Walk menu.")) +
           plain(tr("The timeline at the bottom looks back: drag it, or use the arrow keys. “Why there” "
                    "explains the vote of the place that is chosen in the list."));
}

QString HelpDialog::mapChapter() {
    return plain(tr(
               "Here a map of a building is opened or brought in, looked at, checked and changed. The plan "
               "and the table show the same: what is chosen in one is chosen in the other.")) +
           pageView(Page::Map) +
           item("check",
                tr("F7 looks for what is wrong with the map and says what to do about each finding.")) +
           item(
               "alike",
               tr("Ctrl+U marks places that the landmarks cannot tell apart. A landmark there helps most.")) +
           plain(
               tr("Ctrl+Shift+U marks from where no landmark is seen, and Ctrl+Shift+N lists the routes that "
                  "are missing. Ctrl+Shift+I lays the image of a floor plan under the floor: click two "
                  "points of it "
                  "and where they belong.")) +
           item("here",
                tr("Ctrl+Shift+L puts a landmark on the plan, Ctrl+Shift+D a door. Drag what is chosen, "
                   "or move it with Alt and the arrows.")) +
           item("undo", tr("Ctrl+Z takes every step back. Nothing is written until you save with Ctrl+S."));
}

QString HelpDialog::landmarksChapter() {
    return plain(
               tr("Here Farol is taught what it shall know again. Every change is saved by itself and can be "
                  "taken back with Ctrl+Z; a landmark that is not finished is kept, also when the computer "
                  "stops.")) +
           pageView(Page::Landmarks) +
           item("camera", tr("Ctrl+T teaches a landmark in four steps: what it is, its views, a trial, its "
                             "place on the map.")) +
           plain(tr(
               "Take a view from the front, from the left, from the right and from farther away. The coach "
               "says what is wrong with a picture and which one comes next. Drag the four corners onto the "
               "landmark; by keys, 1 to 4 choose a corner and the arrows move it.")) +
           item("check",
                tr("F7 checks the whole library: how well each landmark is found, how far away, how "
                   "far aside, and which are taken for each other. Merge what is the same, and add views to "
                   "what is lost."));
}

/// All its keys, each in a frame like a key; as text, so that it can be read aloud.
QString HelpDialog::kioskChapter() {
    const QString frame =
        QStringLiteral("border: 1px solid %1; background-color: %2; padding: 4px")
            .arg(palette().color(QPalette::Text).name(), palette().color(QPalette::Button).name());
    QString keys;
    for (const KioskCommand command : kioskCommands())
        keys += QStringLiteral("<tr><td style=\"%1\"><b>%2</b></td><td style=\"padding: 4px\">%3</td></tr>")
                    .arg(frame, KioskWords::key(command).toHtmlEscaped(),
                         KioskWords::meaning(command).toHtmlEscaped());
    return plain(tr(
               "The kiosk is for a blind user who is alone: “farol --kiosk” fills the screen and says "
               "everything. Arrows and Enter choose a destination, F searches by name, digits by number; F1 "
               "says all keys, Escape goes back.")) +
           QStringLiteral("<table cellspacing=\"4\">%1</table>").arg(keys);
}

} // namespace farol::ui
