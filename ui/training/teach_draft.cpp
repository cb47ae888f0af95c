#include "ui/training/teach_draft.h"

#include "core/base/file.h"
#include "ui/convert/convert.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

#include <cmath>

namespace farol::ui {

namespace {

const QString kDraft = QStringLiteral("draft.json");
constexpr int kMostPrograms = 9;

QString pictureName(const std::string& bytes) {
    const QByteArrayView view(bytes.data(), static_cast<qsizetype>(bytes.size()));
    const QByteArray hash = QCryptographicHash::hash(view.toByteArray(), QCryptographicHash::Sha1);
    return QStringLiteral("view-%1.picture").arg(QString::fromLatin1(hash.toHex().left(16)));
}

Result<void> written(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush() && file.commit())
        return {};
    return Error{ErrorCode::Io,
                 toUtf8(QCoreApplication::translate("farol::ui::DraftStore",
                                                    "what you are teaching cannot be kept on disk (%1); it "
                                                    "would be lost with the program")
                            .arg(file.errorString())),
                 toUtf8(QDir::toNativeSeparators(path))};
}

QJsonArray outlineJson(const Quad& outline) {
    QJsonArray numbers;
    for (const ImagePoint& p : outline) {
        numbers.append(p.x);
        numbers.append(p.y);
    }
    return numbers;
}

std::optional<Quad> outlineFrom(const QJsonArray& numbers) {
    if (numbers.size() != 8) return std::nullopt;
    Quad outline;
    for (int i = 0; i < 4; ++i) {
        outline[static_cast<std::size_t>(i)] = {numbers[2 * i].toDouble(), numbers[2 * i + 1].toDouble()};
    }
    return outline;
}

double sizeFrom(const QJsonValue& value) {
    const double metres = value.toDouble();
    return std::isfinite(metres) && metres > 0.0 && metres < 1000.0 ? metres : 0.0;
}

} // namespace

/// The first that nobody uses and that holds something; else the first that nobody uses.
DraftStore::DraftStore(const QString& folder) : m_folder(folder) {
    QDir().mkpath(QFileInfo(folder).absolutePath());
    for (int i = 1; i <= kMostPrograms; ++i) {
        const QString name = i == 1 ? folder : QStringLiteral("%1-%2").arg(folder).arg(i);
        auto lock = std::make_unique<QLockFile>(name + QStringLiteral(".lock"));
        lock->setStaleLockTime(0); // one that has crashed is known by its process
        qint64 holder = 0;
        QString host, program;
        const bool mine =
            lock->tryLock(0) || lock->error() != QLockFile::LockFailedError ||
            (lock->getLockInfo(&holder, &host, &program) && holder == QCoreApplication::applicationPid());
        if (!mine) continue;
        const bool holds = QFile::exists(QDir(name).filePath(kDraft));
        if (m_lock && !holds) continue;
        m_folder = name;
        m_lock = std::move(lock);
        if (holds) return;
    }
}

Result<void> DraftStore::save(const TeachDraft& draft) const {
    const QDir folder(m_folder);
    if (!folder.mkpath(QStringLiteral(".")))
        return Error{ErrorCode::Io,
                     toUtf8(QCoreApplication::translate(
                         "farol::ui::DraftStore", "the folder for what you are teaching cannot be made; "
                                                  "it would be lost with the program")),
                     toUtf8(QDir::toNativeSeparators(m_folder))};
    QStringList wanted{kDraft};
    QJsonArray views;
    for (const DraftView& view : draft.views) {
        const QString name = pictureName(view.bytes);
        wanted << name;
        if (!folder.exists(name)) {
            auto done = written(folder.filePath(name), QByteArray::fromStdString(view.bytes));
            if (!done) return done;
        }
        views.append(QJsonObject{{QStringLiteral("picture"), name},
                                 {QStringLiteral("outline"), outlineJson(view.outline)}});
    }
    const std::string_view kind = kindName(draft.kind);
    const QJsonObject json{
        {QStringLiteral("library"), draft.library},
        {QStringLiteral("id"), draft.id},
        {QStringLiteral("name"), draft.name},
        {QStringLiteral("extends"), draft.extends},
        {QStringLiteral("width_m"), draft.widthM},
        {QStringLiteral("height_m"), draft.heightM},
        {QStringLiteral("step"), draft.step},
        {QStringLiteral("views"), views},
        {QStringLiteral("kind"), QString::fromLatin1(kind.data(), static_cast<qsizetype>(kind.size()))}};
    auto done = written(folder.filePath(kDraft), QJsonDocument(json).toJson());
    if (!done) return done;
    for (const QString& name : folder.entryList(QDir::Files))
        if (!wanted.contains(name)) QFile::remove(folder.filePath(name));
    return {};
}

std::optional<TeachDraft> DraftStore::load() const {
    QFile file(QDir(m_folder).filePath(kDraft));
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    if (json.isEmpty()) return std::nullopt;
    TeachDraft draft;
    draft.library = json[QStringLiteral("library")].toString();
    draft.id = json[QStringLiteral("id")].toString();
    draft.name = json[QStringLiteral("name")].toString();
    draft.extends = json[QStringLiteral("extends")].toBool();
    draft.kind = kindFromName(toUtf8(json[QStringLiteral("kind")].toString())).value_or(Kind::Other);
    draft.widthM = sizeFrom(json[QStringLiteral("width_m")]);
    draft.heightM = sizeFrom(json[QStringLiteral("height_m")]);
    draft.step = json[QStringLiteral("step")].toInt();
    for (const QJsonValue& value : json[QStringLiteral("views")].toArray()) {
        const QJsonObject view = value.toObject();
        const QString name = QFileInfo(view[QStringLiteral("picture")].toString()).fileName();
        auto bytes = readFile(std::filesystem::path(toUtf8(QDir(m_folder).filePath(name))));
        const auto outline = outlineFrom(view[QStringLiteral("outline")].toArray());
        if (bytes && outline && pictureName(*bytes) == name)
            draft.views.push_back({std::move(*bytes), *outline});
    }
    return draft;
}

void DraftStore::clear() const {
    QDir folder(m_folder);
    for (const QString& name : folder.entryList(QDir::Files)) QFile::remove(folder.filePath(name));
}

} // namespace farol::ui
