#include "ui/training/library_model.h"

#include "ui/convert/convert.h"
#include "ui/convert/kind_style.h"
#include "ui/speech/phrasebook.h"
#include "ui/training/training_words.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>

#include <algorithm>
#include <utility>

namespace farol::ui {

using recognition::Template;
using recognition::TemplateCheck;

namespace {

constexpr int kPictureHeight = 36;

/// The same photograph has the same key, however often the library is copied.
QString pictureKey(const Template& entry) {
    const std::string& jpeg = entry.views.front().jpeg;
    const QByteArrayView head(jpeg.data(), static_cast<qsizetype>(std::min<std::size_t>(jpeg.size(), 4096)));
    return QStringLiteral("%1/%2/%3").arg(toQString(entry.id.value)).arg(jpeg.size()).arg(qHash(head));
}

QImage pictureOf(const recognition::View& view) {
    const QImage whole =
        QImage::fromData(QByteArray::fromRawData(view.jpeg.data(), static_cast<qsizetype>(view.jpeg.size())));
    if (whole.isNull()) return {};
    const ImageBox box = boundingBox(view.outline);
    const QRect part = QRectF(box.x, box.y, box.width, box.height).toAlignedRect() & whole.rect();
    return (part.isEmpty() ? whole : whole.copy(part))
        .scaled(2 * kPictureHeight, kPictureHeight, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

QString quoted(QString text) {
    return QLatin1Char('"') + text.replace(QLatin1Char('"'), QLatin1String("\"\"")) + QLatin1Char('"');
}

} // namespace

LibraryModel::LibraryModel(QObject* parent) : QAbstractTableModel(parent), m_background(this) {}

void LibraryModel::setLibrary(Library library) {
    beginResetModel();
    m_library = std::move(library);
    std::erase_if(m_checks, [this](const TemplateCheck& check) {
        const Template* entry = m_library ? m_library->find(check.id) : nullptr;
        return entry == nullptr || static_cast<int>(entry->views.size()) != check.views;
    });
    endResetModel();
    makePictures();
}

void LibraryModel::makePictures() {
    const std::uint64_t job = ++m_job;
    if (!m_library) return;
    QHash<QString, recognition::View> wanted;
    for (const Template& entry : m_library->templates)
        if (!entry.views.empty() && !m_pictures.contains(pictureKey(entry)))
            wanted.insert(
                pictureKey(entry),
                {entry.views.front().jpeg, entry.views.front().size, entry.views.front().outline, {}});
    if (wanted.isEmpty()) return;
    m_background.run(
        [wanted] {
            QHash<QString, QImage> made;
            for (auto one = wanted.begin(); one != wanted.end(); ++one)
                made.insert(one.key(), pictureOf(one.value()));
            return made;
        },
        [this, job](QHash<QString, QImage> made) {
            m_pictures.insert(made);
            if (job == m_job && rowCount() > 0)
                Q_EMIT dataChanged(index(0, Name), index(rowCount() - 1, Name), {Qt::DecorationRole});
        });
}

void LibraryModel::setChecks(const std::vector<TemplateCheck>& checks) {
    m_checks = checks;
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, Health), index(rowCount() - 1, Health));
}

const TemplateCheck* LibraryModel::check(const TemplateId& id) const {
    const auto found = std::find_if(m_checks.begin(), m_checks.end(),
                                    [&](const TemplateCheck& one) { return one.id == id; });
    return found == m_checks.end() ? nullptr : &*found;
}

int LibraryModel::rowOf(const TemplateId& id) const {
    for (int row = 0; row < rowCount(); ++row)
        if (m_library->templates[static_cast<std::size_t>(row)].id == id) return row;
    return -1;
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_library ? 0 : static_cast<int>(m_library->templates.size());
}

int LibraryModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString LibraryModel::text(const Template& entry, int column) const {
    const QLocale locale;
    switch (column) {
    case Name:
        return toQString(entry.name.empty() ? entry.id.value : entry.name);
    case KindWord:
        return entry.unknownKind.empty() ? Phrasebook::kindWord(entry.kind) : toQString(entry.unknownKind);
    case Size: {
        if (!entry.widthM && !entry.heightM) return entry.kind == Kind::Place ? QString() : tr("not known");
        const auto side = [&](const std::optional<double>& metres) {
            return metres ? locale.toString(*metres, 'f', 2) : tr("?");
        };
        return tr("%1 × %2 m").arg(side(entry.widthM), side(entry.heightM));
    }
    case Views:
        return locale.toString(static_cast<int>(entry.views.size()));
    case Health:
        return check(entry.id) ? TrainingWords::verdict(*check(entry.id)) : tr("not checked");
    default:
        return {};
    }
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Template& entry = m_library->templates[static_cast<std::size_t>(index.row())];
    if (role == Qt::DecorationRole && index.column() == Name && !entry.views.empty()) {
        const auto found = m_pictures.find(pictureKey(entry));
        return found == m_pictures.end() ? QVariant() : QVariant(*found);
    }
    if (role == Qt::TextAlignmentRole && index.column() == Views)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole) {
        if (index.column() == Health && check(entry.id))
            return TrainingWords::health(*check(entry.id), entry.kind).join(QLatin1Char('\n'));
        if (index.column() == Name) return tr("In maps called “%1”").arg(toQString(entry.id.value));
    }
    return role == Qt::DisplayRole || role == Qt::ToolTipRole ? text(entry, index.column()) : QVariant();
}

QVariant LibraryModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Name:
        return tr("Landmark");
    case KindWord:
        return tr("Kind");
    case Size:
        return tr("Real size");
    case Views:
        return tr("Views");
    case Health:
        return tr("How well it is found");
    default:
        return {};
    }
}

void ConfusionModel::setChecks(std::vector<TemplateCheck> checks) {
    beginResetModel();
    m_checks = std::move(checks);
    endResetModel();
}

int ConfusionModel::times(int row, int column) const {
    const TemplateCheck& shown = m_checks[static_cast<std::size_t>(row)];
    const auto found = shown.confusedWith.find(m_checks[static_cast<std::size_t>(column)].id.value);
    return found == shown.confusedWith.end() ? 0 : found->second;
}

int ConfusionModel::confusions() const {
    int pairs = 0;
    for (const TemplateCheck& check : m_checks) pairs += static_cast<int>(check.confusedWith.size());
    return pairs;
}

QByteArray ConfusionModel::csv() const {
    QStringList header{QStringLiteral("template"),    QStringLiteral("views"),
                       QStringLiteral("tested"),      QStringLiteral("found"),
                       QStringLiteral("smallest_px"), QStringLiteral("farthest_m"),
                       QStringLiteral("widest_deg")};
    for (const TemplateCheck& check : m_checks) header << quoted(toQString(check.id.value));
    QStringList lines{header.join(QLatin1Char(','))};
    for (int row = 0; row < rowCount(); ++row) {
        const TemplateCheck& check = m_checks[static_cast<std::size_t>(row)];
        QStringList cells{quoted(toQString(check.id.value)),
                          QString::number(check.views),
                          QString::number(check.tested),
                          QString::number(check.found),
                          check.smallestPx > 0.0 ? QString::number(check.smallestPx) : QString(),
                          check.farthestM ? QString::number(*check.farthestM, 'f', 2) : QString(),
                          check.widestDegrees >= 0.0 ? QString::number(check.widestDegrees) : QString()};
        for (int column = 0; column < columnCount(); ++column) cells << QString::number(times(row, column));
        lines << cells.join(QLatin1Char(','));
    }
    return lines.join(QLatin1Char('\n')).toUtf8() + '\n';
}

int ConfusionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_checks.size());
}

int ConfusionModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_checks.size());
}

QVariant ConfusionModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const TemplateCheck& shown = m_checks[static_cast<std::size_t>(index.row())];
    const bool self = index.row() == index.column();
    const int count = times(index.row(), index.column());
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignCenter);
    if (role == Qt::DisplayRole) {
        if (self) return shown.tested > 0 ? tr("%1/%2").arg(shown.found).arg(shown.tested) : tr("–");
        return count > 0 ? QString::number(count) : QString();
    }
    if (role == Qt::BackgroundRole && (self || count > 0)) {
        const bool dark = isDark(QGuiApplication::palette());
        if (self && shown.tested == 0) return QColor(dark ? 0x3a4048 : 0xe4e6ea); // neither found nor lost
        const bool fine = self && shown.found == shown.tested;
        if (fine) return QColor(dark ? 0x1d4d33 : 0xcfeedd);
        return QColor(dark ? 0x6b2a22 : 0xf7c9c2);
    }
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
        const QString name = toQString(shown.id.value);
        const QString other = toQString(m_checks[static_cast<std::size_t>(index.column())].id.value);
        if (self) return tr("%1: found in %2 of %3 views").arg(name).arg(shown.found).arg(shown.tested);
        return tr("%1 taken for %2: %n time(s)", nullptr, count).arg(name, other);
    }
    return {};
}

QVariant ConfusionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (section < 0 || section >= rowCount()) return {};
    const QString name = toQString(m_checks[static_cast<std::size_t>(section)].id.value);
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) return name;
    if (role != Qt::DisplayRole) return {};
    return orientation == Qt::Vertical ? tr("%1  %2").arg(section + 1).arg(name)
                                       : QString::number(section + 1);
}

} // namespace farol::ui
