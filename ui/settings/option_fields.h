#pragma once
// The figures of core's option structs that a user may change: for the forms, the settings file and the walk.

#include "core/guidance/cue_scheduler.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/routing/route.h"

#include <QCoreApplication>
#include <QString>

#include <variant>
#include <vector>

namespace farol::ui {

class Settings;

/// A figure, a whole number or a yes. `key` is stable and stands in the settings file.
template <class Options>
struct OptionField {
    const char* key;
    const char* label; ///< to be translated by OptionFields::tr
    const char* unit;  ///< the same in every language; empty: none
    std::variant<double Options::*, int Options::*, bool Options::*> member;
    double low = 0.0, high = 1.0, step = 1.0;

    double in(const Options& options) const {
        return std::visit([&](auto at) { return static_cast<double>(options.*at); }, member);
    }
    void put(Options& options, double value) const {
        std::visit([&](auto at) { options.*at = static_cast<std::decay_t<decltype(options.*at)>>(value); },
                   member);
    }
    bool yesOrNo() const { return std::holds_alternative<bool Options::*>(member); }
    bool whole() const { return std::holds_alternative<int Options::*>(member); }
};

class OptionFields {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::OptionFields)
};

const std::vector<OptionField<guidance::GuidanceOptions>>& guidanceFields();
const std::vector<OptionField<routing::RouteOptions>>& routeFields();
const std::vector<OptionField<recognition::RecogniserOptions>>& recogniserFields();

/// `base` with what the user changed, kept inside the field's limits.
template <class Store, class Options>
Options changed(const Store& store, Options base, const std::vector<OptionField<Options>>& fields) {
    for (const OptionField<Options>& field : fields)
        if (const auto value = store.option(QString::fromLatin1(field.key)))
            field.put(base, std::min(std::max(*value, field.low), field.high));
    return base;
}

} // namespace farol::ui
