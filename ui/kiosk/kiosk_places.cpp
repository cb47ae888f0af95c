#include "ui/kiosk/kiosk_places.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"
#include "ui/speech/phrasebook.h"
#include "ui/speech/spoken.h"

#include <algorithm>
#include <array>
#include <utility>

namespace farol::ui {

using building::Region;
using building::RegionKind;

namespace {

/// A place without a name and number is nothing that one could ask for.
bool canBeNamed(const Region& region) {
    return !region.name.empty() || !region.ref.empty();
}

QString nameAndNumber(const Region& region) {
    QString name = spoken::name(building::spokenName(region, toUtf8(installedLanguage())));
    const QString ref = spoken::name(region.ref);
    if (!ref.isEmpty() && !name.contains(ref, Qt::CaseInsensitive)) name += QLatin1Char(' ') + ref;
    return name;
}

} // namespace

KioskPlaces::KioskPlaces() {
    m_filter.setSourceModel(&m_regions);
}

void KioskPlaces::setBuilding(std::shared_ptr<const building::Building> building) {
    m_building = std::move(building);
    m_regions.setBuilding(m_building);
    m_filter.setTyped({});
    m_categories.clear();
    m_typed.clear();
    std::vector<RegionId> all;
    for (int row = 0; row < m_regions.rowCount(); ++row) {
        const auto id = m_regions.idAt(row);
        if (id && canBeNamed(*m_building->region(*id))) all.push_back(*id);
    }
    if (!all.empty()) addCategories(all);
    setCategory(0);
}

void KioskPlaces::addCategories(const std::vector<RegionId>& all) {
    m_categories.push_back({tr("All places"), all});
    const auto add = [&](const QString& words, auto belongs) {
        Category category{words, {}};
        for (const RegionId& id : all)
            if (belongs(*m_building->region(id))) category.places.push_back(id);
        if (!category.places.empty() && category.places.size() < all.size())
            m_categories.push_back(std::move(category));
    };
    const std::array<std::pair<RegionKind, QString>, 8> kinds{{{RegionKind::Room, tr("Rooms")},
                                                               {RegionKind::Toilet, tr("Toilets")},
                                                               {RegionKind::Hall, tr("Halls")},
                                                               {RegionKind::Corridor, tr("Corridors")},
                                                               {RegionKind::Elevator, tr("Lifts")},
                                                               {RegionKind::Stairwell, tr("Stairs")},
                                                               {RegionKind::Outside, tr("Ways out")},
                                                               {RegionKind::Other, tr("Other places")}}};
    for (const auto& [kind, words] : kinds)
        add(words, [wanted = kind](const Region& region) { return region.kind == wanted; });
    if (m_building->levels().size() < 2) return;
    for (const building::Level& level : m_building->levels())
        add(spoken::capitalised(Words::level(*m_building, level.ordinal)),
            [ordinal = level.ordinal](const Region& region) { return region.level == ordinal; });
}

void KioskPlaces::setCategory(int category) {
    m_category = category;
    m_typed.clear();
    m_current = -1;
    m_shown = category >= 0 && category < categories()
                  ? m_categories[static_cast<std::size_t>(category)].places
                  : std::vector<RegionId>();
}

QString KioskPlaces::categoryWordsAt(int category) const {
    if (category < 0 || category >= categories()) return {};
    return m_categories[static_cast<std::size_t>(category)].words;
}

void KioskPlaces::setTyped(const QString& text) {
    if (text.trimmed().isEmpty()) {
        setCategory(m_category);
        m_typed = text;
        return;
    }
    m_typed = text;
    m_current = -1;
    m_filter.setTyped(text);
    m_shown.clear();
    for (int row = 0; row < m_filter.rowCount(); ++row) {
        const RegionId id(toUtf8(m_filter.index(row, 0).data(RegionModel::IdRole).toString()));
        if (canBeNamed(*m_building->region(id))) m_shown.push_back(id);
    }
}

void KioskPlaces::setCurrent(int index) {
    m_current = std::clamp(index, -1, count() - 1);
}

std::optional<RegionId> KioskPlaces::chosen() const {
    if (m_current < 0) return std::nullopt;
    return m_shown[static_cast<std::size_t>(m_current)];
}

QString KioskPlaces::wordsAt(int index) const {
    return index >= 0 && index < count() ? words(m_shown[static_cast<std::size_t>(index)]) : QString();
}

QString KioskPlaces::words(const RegionId& id) const {
    const Region* region = m_building ? m_building->region(id) : nullptr;
    if (!region) return {};
    QString text = nameAndNumber(*region);
    if (m_building->levels().size() > 1)
        text += QStringLiteral(", ") + Words::level(*m_building, region->level);
    const auto alike = [&](const Region& other) {
        return other.id != id && other.level == region->level &&
               nameAndNumber(other) == nameAndNumber(*region);
    };
    const auto& all = m_building->regions();
    if (std::any_of(all.begin(), all.end(), alike)) text += QStringLiteral(", ") + toQString(id.value);
    return text;
}

} // namespace farol::ui
