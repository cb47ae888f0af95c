#include "ui/live/walk_timeline.h"

#include "ui/convert/convert.h"

#include <QBuffer>
#include <QStringList>
#include <opencv2/imgproc.hpp>

namespace farol::ui {

namespace {

constexpr int kKeptWidth = 480;

QByteArray reducedJpeg(const cv::Mat& image) {
    QImage picture = toQImage(image);
    if (picture.isNull()) return {};
    if (picture.width() > kKeptWidth) picture = picture.scaledToWidth(kKeptWidth);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "JPG", 75);
    return bytes;
}

QString quoted(QString text) {
    return QLatin1Char('"') + text.replace(QLatin1Char('"'), QLatin1String("\"\"")) + QLatin1Char('"');
}

} // namespace

void WalkTimeline::clear() {
    m_moments.clear();
    m_said.clear();
    m_spacing = 0.2;
    Q_EMIT changed();
}

void WalkTimeline::noteSaid(const QString& text) {
    m_said << text;
}

void WalkTimeline::add(const session::Snapshot& snapshot) {
    const session::NavigationStep& step = snapshot.step;
    if (!m_moments.empty() && step.percept.time < m_moments.back().time + m_spacing) return;
    Moment moment;
    moment.time = step.percept.time;
    moment.confidence = step.fix.confidence;
    moment.region = step.fix.region;
    moment.latencyMs = snapshot.times.ageMs;
    moment.said = std::exchange(m_said, {});
    auto light = std::make_shared<session::Snapshot>(snapshot);
    light->frame.image.release();
    moment.light = std::move(light);
    moment.picture = reducedJpeg(snapshot.frame.image);
    m_moments.push_back(std::move(moment));
    if (m_moments.size() > kMost) { // every other one goes, but nothing that was said
        std::vector<Moment> kept;
        for (std::size_t i = 0; i < m_moments.size(); ++i) {
            if (i % 2 == 0)
                kept.push_back(std::move(m_moments[i]));
            else
                kept.back().said << m_moments[i].said;
        }
        m_moments = std::move(kept);
        m_spacing *= 2.0;
    }
    Q_EMIT changed();
}

std::shared_ptr<const session::Snapshot> WalkTimeline::snapshotAt(std::size_t index) const {
    const Moment& moment = m_moments[index];
    auto whole = std::make_shared<session::Snapshot>(*moment.light);
    const QImage picture = QImage::fromData(moment.picture).convertToFormat(QImage::Format_BGR888);
    if (picture.isNull()) return whole;
    const cv::Mat small(picture.height(), picture.width(), CV_8UC3, const_cast<uchar*>(picture.constBits()),
                        static_cast<std::size_t>(picture.bytesPerLine()));
    const ImageSize size = whole->step.percept.size;
    if (size.width > 0 && size.height > 0)
        cv::resize(small, whole->frame.image,
                   cv::Size(size.width, size.height)); // outlines are in its pixels
    else
        whole->frame.image = small.clone();
    return whole;
}

QByteArray WalkTimeline::csv(const building::Building* building) const {
    QStringList lines{QStringLiteral("seconds,picture,region,name,confidence,level,x,y,understood_ms,said")};
    const auto number = [](double value, int digits) { return QString::number(value, 'f', digits); };
    for (const Moment& moment : m_moments) {
        const localisation::Fix& fix = moment.light->step.fix;
        QStringList cells{number(moment.time, 3), quoted(toQString(moment.light->step.percept.name))};
        cells << quoted(moment.region ? toQString(moment.region->value) : QString());
        cells << quoted(moment.region ? regionName(building, *moment.region) : QString());
        cells << number(moment.confidence, 3) << (fix.level ? QString::number(*fix.level) : QString());
        cells << (fix.position ? number(fix.position->x, 2) : QString());
        cells << (fix.position ? number(fix.position->y, 2) : QString());
        cells << number(moment.latencyMs, 1) << quoted(moment.said.join(QLatin1Char(' ')));
        lines << cells.join(QLatin1Char(','));
    }
    return lines.join(QLatin1Char('\n')).toUtf8() + '\n';
}

} // namespace farol::ui
