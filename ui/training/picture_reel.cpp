#include "ui/training/picture_reel.h"

#include "core/base/file.h"
#include "core/capture/picture.h"
#include "ui/convert/convert.h"
#include "ui/models/core_words.h"

#include <QBuffer>
#include <QCollator>
#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace farol::ui {

namespace {

constexpr int kPullMs = 33;
constexpr std::size_t kKept = 48; // pictures of a video that one can go back to

PictureReel::Picture pictureOf(const cv::Mat& image, std::string bytes, const QString& name) {
    auto picture = std::make_shared<ReelPicture>();
    picture->image = image;
    picture->shown = toQImage(image);
    picture->bytes = std::move(bytes);
    picture->name = name;
    return picture;
}

Result<PictureReel::Picture> readFilePicture(const QString& path) {
    auto bytes = readFile(std::filesystem::path(toUtf8(path)));
    if (!bytes) return bytes.error();
    auto image = capture::decodePicture(*bytes, toUtf8(path));
    if (!image) return image.error();
    return pictureOf(*image, std::move(*bytes), QFileInfo(path).fileName());
}

QStringList picturesIn(const QString& folder) {
    // A recorded walk keeps its pictures in a folder of their own.
    const QDir frames(QDir(folder).filePath(QStringLiteral("frames")));
    const bool recorded = QFileInfo::exists(QDir(folder).filePath(QStringLiteral("recording.json")));
    const QDir from = recorded && frames.exists() ? frames : QDir(folder);
    QStringList names;
    for (const QString& name : from.entryList(QDir::Files))
        if (capture::hasPictureName(toUtf8(name))) names << name;
    QCollator collator(QLocale::c());
    collator.setNumericMode(true);
    std::sort(names.begin(), names.end(), collator);
    for (QString& name : names) name = from.filePath(name);
    return names;
}

} // namespace

std::string ReelPicture::file() const {
    if (!bytes.empty()) return bytes;
    QByteArray jpeg;
    QBuffer buffer(&jpeg);
    buffer.open(QIODevice::WriteOnly);
    shown.save(&buffer, "JPG", 95);
    return jpeg.toStdString();
}

PictureReel::PictureReel(OpenSource open, QObject* parent)
    : QObject(parent), m_open(std::move(open)), m_background(this) {
    if (!m_open)
        m_open = [](const std::string& name, const capture::SourceOptions& options) {
            return capture::openSource(name, options);
        };
    m_pull.setInterval(kPullMs);
    connect(&m_pull, &QTimer::timeout, this, &PictureReel::pull);
}

PictureReel::~PictureReel() {
    if (m_stream) m_stream->source->requestStop();
}

void PictureReel::begin(const QString& name) {
    close();
    m_name = name;
}

void PictureReel::close() {
    ++m_serial;
    m_pull.stop();
    if (m_stream) m_stream->source->requestStop(); // the job that reads lets go of it
    m_stream.reset();
    m_files.clear();
    m_kept.clear();
    m_current.reset();
    m_index = -1;
    m_live = m_held = m_busy = m_ended = false;
    m_name.clear();
    Q_EMIT pictureChanged();
    Q_EMIT stateChanged();
}

void PictureReel::openFiles(const QStringList& files) {
    if (files.isEmpty()) return;
    begin(files.size() == 1 ? QFileInfo(files.first()).fileName() : QFileInfo(files.first()).path());
    m_files = files;
    go(0);
}

void PictureReel::openSource(const QString& name) {
    if (QFileInfo(name).isDir()) {
        const QStringList files = picturesIn(name);
        if (files.isEmpty())
            return void(
                Q_EMIT failed(tr("There are no pictures in %1.").arg(QDir::toNativeSeparators(name))));
        return openFiles(files);
    }
    begin(name);
    m_busy = true;
    Q_EMIT stateChanged();
    m_background.run(
        [open = m_open, source = toUtf8(name)]() -> Result<std::shared_ptr<Stream>> {
            auto made = open(source, {});
            if (!made) return made.error();
            auto stream = std::make_shared<Stream>();
            stream->source = std::move(*made);
            return stream;
        },
        [this, serial = m_serial](Result<std::shared_ptr<Stream>> result) {
            opened(serial, std::move(result));
        });
}

void PictureReel::opened(std::uint64_t serial, Result<std::shared_ptr<Stream>> result) {
    if (serial != m_serial) return;
    m_busy = false;
    if (!result) {
        m_name.clear();
        Q_EMIT stateChanged();
        return void(Q_EMIT failed(CoreWords::problem(result.error())));
    }
    m_stream = std::move(*result);
    m_live = m_stream->source->live();
    if (!m_live) return readFrame();
    m_background.run([stream = m_stream] {
        while (auto frame = stream->source->next()) stream->newest.put(std::move(*frame));
    });
    m_pull.start();
    Q_EMIT stateChanged();
}

void PictureReel::pull() {
    if (!m_stream || m_held) return;
    if (auto frame = m_stream->newest.tryTake()) show(pictureOf(frame->image, {}, m_name));
}

void PictureReel::readFrame() {
    m_busy = true;
    Q_EMIT stateChanged();
    m_background.run(
        [stream = m_stream]() -> Picture {
            const auto frame = stream->source->next();
            if (!frame) return nullptr;
            return pictureOf(frame->image, {}, clockText(frame->capturedAt));
        },
        [this, serial = m_serial](Picture picture) {
            if (serial != m_serial) return;
            m_busy = false;
            if (!picture) {
                m_ended = true;
                return void(Q_EMIT stateChanged());
            }
            m_kept.push_back(picture);
            if (m_kept.size() > kKept) m_kept.pop_front();
            m_index = static_cast<int>(m_kept.size()) - 1;
            show(std::move(picture));
        });
}

void PictureReel::show(Picture picture) {
    m_current = std::move(picture);
    Q_EMIT pictureChanged();
    Q_EMIT stateChanged();
}

void PictureReel::hold(bool held) {
    m_held = held;
    Q_EMIT stateChanged();
}

void PictureReel::go(int index) {
    if (m_files.isEmpty() || index < 0 || index >= m_files.size()) return;
    m_index = index;
    const std::uint64_t serial = ++m_serial;
    m_busy = true;
    Q_EMIT stateChanged();
    m_background.run([path = m_files.at(index)] { return readFilePicture(path); },
                     [this, serial](Result<Picture> picture) {
                         if (serial != m_serial) return;
                         m_busy = false;
                         if (picture) return show(std::move(*picture));
                         m_current.reset();
                         Q_EMIT pictureChanged();
                         Q_EMIT stateChanged();
                         Q_EMIT failed(CoreWords::problem(picture.error()));
                     });
}

bool PictureReel::hasNext() const {
    if (!m_files.isEmpty()) return m_index + 1 < m_files.size();
    return m_stream && !m_live && (m_index + 1 < static_cast<int>(m_kept.size()) || !m_ended);
}

bool PictureReel::hasPrevious() const {
    return !m_live && m_index > 0;
}

void PictureReel::next() {
    if (!hasNext() || (m_busy && m_files.isEmpty())) return;
    if (!m_files.isEmpty()) return go(m_index + 1);
    if (m_index + 1 >= static_cast<int>(m_kept.size())) return readFrame();
    ++m_index;
    show(m_kept[static_cast<std::size_t>(m_index)]);
}

void PictureReel::previous() {
    if (!hasPrevious() || (m_busy && m_files.isEmpty())) return;
    if (!m_files.isEmpty()) return go(m_index - 1);
    --m_index;
    show(m_kept[static_cast<std::size_t>(m_index)]);
}

} // namespace farol::ui
