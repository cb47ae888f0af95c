#pragma once
// The pictures that a landmark is taught from: a camera, chosen files, a folder, a recorded walk or a video.
// Opened and read in the background. GUI thread.

#include "core/base/latest_value.h"
#include "core/capture/frame_source.h"
#include "ui/convert/background.h"

#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace farol::ui {

struct ReelPicture {
    cv::Mat image;
    QImage shown;
    std::string bytes; ///< of the file; empty where the picture came from no file of its own
    QString name;

    /// The file as it is, else the picture as a JPEG.
    std::string file() const;
};

class PictureReel : public QObject {
    Q_OBJECT

public:
    using Picture = std::shared_ptr<const ReelPicture>;
    using OpenSource = std::function<Result<std::unique_ptr<capture::FrameSource>>(
        const std::string&, const capture::SourceOptions&)>;

    /// `open` is replaced by tests; empty: the real ones.
    explicit PictureReel(OpenSource open = {}, QObject* parent = nullptr);
    ~PictureReel() override;

    void openFiles(const QStringList& files);
    /// A camera, an address, a video; a folder of pictures or of a recorded walk.
    void openSource(const QString& name);
    void close();

    void next();
    void previous();
    void go(int index);   ///< of files
    void hold(bool held); ///< a camera: the picture that is shown stays

    const Picture& current() const { return m_current; }
    bool live() const { return m_stream && m_live; }
    bool held() const { return m_held; }
    bool busy() const { return m_busy; }
    int index() const { return m_index; }
    int count() const { return static_cast<int>(m_files.size()); } ///< 0: not known
    bool hasNext() const;
    bool hasPrevious() const;
    const QString& name() const { return m_name; }

Q_SIGNALS:
    void pictureChanged();
    void stateChanged();
    void failed(const QString& message);

private:
    struct Stream {
        std::unique_ptr<capture::FrameSource> source;
        LatestValue<capture::Frame> newest;
    };

    void begin(const QString& name);
    void opened(std::uint64_t serial, Result<std::shared_ptr<Stream>> result);
    void readFrame();
    void pull();
    void show(Picture picture);

    OpenSource m_open;
    QString m_name;
    QStringList m_files;
    std::shared_ptr<Stream> m_stream;
    std::deque<Picture> m_kept; ///< of a video: the last ones, to go back to
    int m_index = -1;           ///< in the files, or in those kept
    Picture m_current;
    bool m_live = false, m_held = false, m_busy = false, m_ended = false;
    std::uint64_t m_serial = 0;
    QTimer m_pull;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
