#include "ui/settings/settings.h"

#include "ui/settings/option_fields.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

constexpr int kRecentItems = 8;

const QString kLanguage = QStringLiteral("words/language");
const QString kDirections = QStringLiteral("words/direction-style");
const QString kLocaliser = QStringLiteral("place/localiser");
const QString kVerbosity = QStringLiteral("words/verbosity");
const QString kUnit = QStringLiteral("words/distance-unit");
const QString kTwoKeys = QStringLiteral("kiosk/two-keys");
const QString kEngine = QStringLiteral("voice/engine");
const QString kVoice = QStringLiteral("voice/name");
const QString kRate = QStringLiteral("voice/rate");
const QString kVolume = QStringLiteral("voice/volume");
const QString kMuted = QStringLiteral("voice/muted");
const QString kFollow = QStringLiteral("view/follow-level");
const QString kGrid = QStringLiteral("view/grid");
const QString kRejected = QStringLiteral("view/rejected");
const QString kSpeed = QStringLiteral("walk/speed");
const QString kRecordings = QStringLiteral("walk/recording-folder");
const QString kLook = QStringLiteral("window/look");
const QString kWelcomed = QStringLiteral("window/welcomed");
const QString kProfile = QStringLiteral("profile");
const QString kGeometry = QStringLiteral("window/geometry");

const QStringList kDirectionNames{QStringLiteral("left-right"), QStringLiteral("clock"),
                                  QStringLiteral("degrees")};
const QStringList kVerbosityNames{QStringLiteral("directions"), QStringLiteral("objects"),
                                  QStringLiteral("objects-and-texts")};
const QStringList kLookNames{QStringLiteral("system"), QStringLiteral("light"), QStringLiteral("dark")};
const QStringList kUnitNames{QStringLiteral("metres"), QStringLiteral("feet"), QStringLiteral("steps")};

QString recentKey(RecentKind kind) {
    switch (kind) {
    case RecentKind::Map:
        return QStringLiteral("recent/maps");
    case RecentKind::Library:
        return QStringLiteral("recent/libraries");
    case RecentKind::Source:
        break;
    }
    return QStringLiteral("recent/sources");
}

double numberIn(const QSettings& store, const QString& key, double fallback, double low, double high) {
    bool fine = false;
    const double value = store.value(key, fallback).toDouble(&fine);
    return fine && std::isfinite(value) ? std::clamp(value, low, high) : fallback;
}

template <class Enum>
Enum choiceIn(const QSettings& store, const QString& key, const QStringList& names, Enum fallback) {
    const qsizetype index = names.indexOf(store.value(key).toString());
    return index < 0 ? fallback : static_cast<Enum>(index);
}

} // namespace

Settings::Settings(const QString& file, QObject* parent)
    : QObject(parent),
      m_store(file.isEmpty() ? std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope,
                                                           QStringLiteral("farol"), QStringLiteral("farol"))
                             : std::make_unique<QSettings>(file, QSettings::IniFormat)),
      m_own(file.isEmpty()) {
    m_mainFile = m_store->fileName();
    const QString last = m_store->value(kProfile).toString();
    if (profiles().contains(last)) {
        m_profile = last;
        m_store = openProfile(last);
    }
}

template <class T>
bool Settings::store(const QString& key, const T& value) {
    const QVariant variant = QVariant::fromValue(value);
    if (m_store->value(key) == variant) return false;
    m_store->setValue(key, variant);
    return true;
}

QString Settings::language() const {
    const QString language = m_store->value(kLanguage).toString();
    const auto& all = languages();
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const Language& each) { return each.code == language; });
    return known ? language : QString();
}

void Settings::setLanguage(const QString& language) {
    if (store(kLanguage, language)) Q_EMIT languageChanged();
}

VoiceChoice Settings::voice() const {
    VoiceChoice choice;
    choice.engine = m_store->value(kEngine).toString();
    choice.voice = m_store->value(kVoice).toString();
    choice.rate = numberIn(*m_store, kRate, 0.0, -1.0, 1.0);
    choice.volume = numberIn(*m_store, kVolume, 1.0, 0.0, 1.0);
    choice.language = language();
    return choice;
}

void Settings::setVoice(const VoiceChoice& voice) {
    bool changed = store(kEngine, voice.engine);
    changed = store(kVoice, voice.voice) || changed;
    changed = store(kRate, voice.rate) || changed;
    changed = store(kVolume, voice.volume) || changed;
    if (changed) Q_EMIT voiceChanged();
}

bool Settings::muted() const {
    return m_store->value(kMuted, false).toBool();
}

void Settings::setMuted(bool muted) {
    if (store(kMuted, muted)) Q_EMIT mutedChanged(muted);
}

DirectionStyle Settings::directionStyle() const {
    return choiceIn(*m_store, kDirections, kDirectionNames, DirectionStyle::LeftRight);
}

void Settings::setDirectionStyle(DirectionStyle style) {
    if (store(kDirections, kDirectionNames.at(static_cast<int>(style)))) Q_EMIT guidanceChanged();
}

DistanceUnit Settings::unit() const {
    return choiceIn(*m_store, kUnit, kUnitNames, DistanceUnit::Metres);
}

void Settings::setUnit(DistanceUnit unit) {
    if (store(kUnit, kUnitNames.at(static_cast<int>(unit)))) Q_EMIT guidanceChanged();
}

bool Settings::twoKeys() const {
    return m_store->value(kTwoKeys, false).toBool();
}

void Settings::setTwoKeys(bool twoKeys) {
    store(kTwoKeys, twoKeys);
}

guidance::Verbosity Settings::verbosity() const {
    return choiceIn(*m_store, kVerbosity, kVerbosityNames, guidance::Verbosity::Objects);
}

QStringList Settings::localisers() {
    return {QStringLiteral("bayes-guided"), QStringLiteral("bayes"), QStringLiteral("voting"),
            QStringLiteral("voting-literal")};
}

QString Settings::localiser() const {
    const QString stored = m_store->value(kLocaliser).toString();
    return localisers().contains(stored) ? stored : localisers().constFirst();
}

void Settings::setLocaliser(const QString& name) {
    if (localisers().contains(name)) store(kLocaliser, name);
}

void Settings::setVerbosity(guidance::Verbosity verbosity) {
    if (store(kVerbosity, kVerbosityNames.at(static_cast<int>(verbosity)))) Q_EMIT guidanceChanged();
}

bool Settings::followLevel() const {
    return m_store->value(kFollow, true).toBool();
}

void Settings::setFollowLevel(bool follow) {
    if (store(kFollow, follow)) Q_EMIT displayChanged();
}

bool Settings::showGrid() const {
    return m_store->value(kGrid, true).toBool();
}

void Settings::setShowGrid(bool show) {
    if (store(kGrid, show)) Q_EMIT displayChanged();
}

bool Settings::showRejected() const {
    return m_store->value(kRejected, false).toBool();
}

void Settings::setShowRejected(bool show) {
    if (store(kRejected, show)) Q_EMIT displayChanged();
}

double Settings::speed() const {
    return numberIn(*m_store, kSpeed, 1.0, 0.25, 8.0);
}

void Settings::setSpeed(double speed) {
    store(kSpeed, std::clamp(speed, 0.25, 8.0));
}

QString Settings::recordingFolder() const {
    const QString folder = m_store->value(kRecordings).toString();
    if (!folder.isEmpty()) return folder;
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(documents.isEmpty() ? QDir::homePath() : documents).filePath(QStringLiteral("Farol"));
}

void Settings::setRecordingFolder(const QString& folder) {
    store(kRecordings, folder);
}

QStringList Settings::recent(RecentKind kind) const {
    QStringList items = m_store->value(recentKey(kind)).toStringList();
    items.removeAll(QString());
    return items.mid(0, kRecentItems);
}

void Settings::addRecent(RecentKind kind, const QString& item) {
    if (item.isEmpty()) return;
    QStringList items = recent(kind);
    items.removeAll(item);
    items.prepend(item);
    if (store(recentKey(kind), QStringList(items.mid(0, kRecentItems)))) Q_EMIT recentChanged();
}

void Settings::clearRecent(RecentKind kind) {
    m_store->remove(recentKey(kind));
    Q_EMIT recentChanged();
}

Look Settings::look() const {
    return choiceIn(*m_store, kLook, kLookNames, Look::System);
}

void Settings::setLook(Look look) {
    if (store(kLook, kLookNames.at(static_cast<int>(look)))) Q_EMIT lookChanged();
}

bool Settings::firstRun() const {
    return !m_store->value(kWelcomed, false).toBool() && recent(RecentKind::Map).isEmpty();
}

void Settings::setFirstRunDone() {
    store(kWelcomed, true);
}

std::optional<double> Settings::option(const QString& key) const {
    bool fine = false;
    const double value = m_store->value(QStringLiteral("options/") + key).toDouble(&fine);
    return fine && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void Settings::setOption(const QString& key, const std::optional<double>& value) {
    const QString name = QStringLiteral("options/") + key;
    if (value)
        store(name, *value);
    else
        m_store->remove(name);
}

guidance::GuidanceOptions Settings::guidanceOptions(guidance::GuidanceOptions base) const {
    return changed(*this, base, guidanceFields());
}

routing::RouteOptions Settings::routeOptions(routing::RouteOptions base) const {
    return changed(*this, base, routeFields());
}

recognition::RecogniserOptions Settings::recogniserOptions(recognition::RecogniserOptions base) const {
    return changed(*this, base, recogniserFields());
}

QString Settings::profileFolder() const {
    return QFileInfo(m_mainFile).dir().filePath(QStringLiteral("profiles"));
}

std::unique_ptr<QSettings> Settings::openProfile(const QString& name) const {
    const QString file =
        name.isEmpty() ? m_mainFile : QDir(profileFolder()).filePath(name + QStringLiteral(".ini"));
    return std::make_unique<QSettings>(file, QSettings::IniFormat);
}

QStringList Settings::profiles() const {
    QStringList names{QString()};
    for (const QFileInfo& file :
         QDir(profileFolder()).entryInfoList({QStringLiteral("*.ini")}, QDir::Files, QDir::Name))
        names << file.completeBaseName();
    return names;
}

bool Settings::useProfile(const QString& name) {
    const bool possible = !name.contains(QLatin1Char('/')) && !name.contains(QLatin1Char('\\')) &&
                          !name.startsWith(QLatin1Char('.')) && name.size() <= 80;
    if (!possible) return false;
    if (name == m_profile) return true;
    const bool fresh = !profiles().contains(name);
    if (fresh && !QDir().mkpath(profileFolder())) return false;
    std::unique_ptr<QSettings> next = openProfile(name);
    if (fresh)
        for (const QString& key : m_store->allKeys())
            if (key != kProfile) next->setValue(key, m_store->value(key));
    next->sync();
    if (next->status() != QSettings::NoError) return false;
    m_store->sync();
    m_store = std::move(next);
    m_profile = name;
    QSettings main(m_mainFile, QSettings::IniFormat);
    main.setValue(kProfile, name);
    Q_EMIT profileChanged();
    Q_EMIT languageChanged();
    Q_EMIT voiceChanged();
    Q_EMIT mutedChanged(muted());
    Q_EMIT guidanceChanged();
    Q_EMIT displayChanged();
    Q_EMIT recentChanged();
    Q_EMIT lookChanged();
    return true;
}

QString Settings::workFolder() const {
    if (!m_own) return QFileInfo(m_store->fileName()).absolutePath();
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation))
        .filePath(QStringLiteral("farol"));
}

QByteArray Settings::windowGeometry() const {
    return m_store->value(kGeometry).toByteArray();
}
void Settings::setWindowGeometry(const QByteArray& geometry) {
    store(kGeometry, geometry);
}

QByteArray Settings::splitter(const QString& name) const {
    return m_store->value(QStringLiteral("window/splitter-") + name).toByteArray();
}

void Settings::setSplitter(const QString& name, const QByteArray& state) {
    store(QStringLiteral("window/splitter-") + name, state);
}

namespace {

/// A path is no good key: its slashes make groups.
QString keyOfPictures(const QString& map) {
    const QByteArray hash =
        QCryptographicHash::hash(QFileInfo(map).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1);
    return QStringLiteral("floor-images/") + QString::fromLatin1(hash.toHex());
}

} // namespace

QByteArray Settings::floorPictures(const QString& map) const {
    return m_store->value(keyOfPictures(map)).toByteArray();
}

void Settings::setFloorPictures(const QString& map, const QByteArray& pictures) {
    store(keyOfPictures(map), pictures);
}

} // namespace farol::ui
