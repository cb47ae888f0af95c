#pragma once
// The places one can go to, as a list that is heard: one kind or one floor of them, or what fits the typed
// text.

#include "ui/models/region_filter.h"
#include "ui/models/region_model.h"

#include <QCoreApplication>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

class KioskPlaces {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::KioskPlaces)

public:
    KioskPlaces();

    /// Also after a change of language. Forgets what was chosen and typed.
    void setBuilding(std::shared_ptr<const building::Building> building);
    bool any() const { return !m_categories.empty(); } ///< is there a place to go to at all?

    int categories() const { return static_cast<int>(m_categories.size()); }
    int category() const { return m_category; }
    void setCategory(int category);
    QString categoryWords() const { return categoryWordsAt(m_category); }
    QString categoryWordsAt(int category) const; ///< "Rooms"

    void setTyped(const QString& text); ///< over all categories; empty: the category again
    const QString& typed() const { return m_typed; }

    int count() const { return static_cast<int>(m_shown.size()); }
    int current() const { return m_current; } ///< -1: none yet
    void setCurrent(int index);
    std::optional<RegionId> chosen() const;
    QString wordsAt(int index) const;
    /// "Library, level 1": told apart from every other place.
    QString words(const RegionId& region) const;

private:
    struct Category {
        QString words;
        std::vector<RegionId> places;
    };
    void addCategories(const std::vector<RegionId>& all);

    std::shared_ptr<const building::Building> m_building;
    RegionModel m_regions;
    RegionFilter m_filter;
    std::vector<Category> m_categories;
    std::vector<RegionId> m_shown;
    QString m_typed;
    int m_category = 0;
    int m_current = -1;
};

} // namespace farol::ui
