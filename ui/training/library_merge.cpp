#include "ui/training/library_merge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace farol::ui {

using recognition::LandmarkLibrary;
using recognition::Template;

namespace {

// What went through a file once has lost its last digits.
bool near(double a, double b) {
    return std::abs(a - b) <= 1e-3;
}

bool sameSize(const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() == b.has_value() && (!a || near(*a, *b));
}

bool same(const Template& a, const Template& b) {
    if (a.kind != b.kind || a.unknownKind != b.unknownKind || a.name != b.name ||
        a.views.size() != b.views.size())
        return false;
    if (!sameSize(a.widthM, b.widthM) || !sameSize(a.heightM, b.heightM)) return false;
    for (std::size_t i = 0; i < a.views.size(); ++i) {
        if (a.views[i].jpeg != b.views[i].jpeg) return false;
        for (std::size_t corner = 0; corner < a.views[i].outline.size(); ++corner) {
            const auto& p = a.views[i].outline[corner];
            const auto& q = b.views[i].outline[corner];
            if (!near(p.x, q.x) || !near(p.y, q.y)) return false;
        }
    }
    return true;
}

bool same(const Template* a, const Template* b) {
    return a == nullptr || b == nullptr ? a == b : same(*a, *b);
}

/// Of one id, each may be missing. False: both have changed it, and not alike.
bool choose(const Template* base, const Template* mine, const Template* theirs, const Template*& chosen) {
    chosen = same(base, mine) ? theirs : mine;
    return same(base, mine) || same(base, theirs) || same(mine, theirs);
}

} // namespace

std::optional<LandmarkLibrary> mergedLibraries(const LandmarkLibrary& base, const LandmarkLibrary& mine,
                                               const LandmarkLibrary& theirs) {
    if (!(mine.extractor == theirs.extractor)) return std::nullopt;
    const auto known = [&theirs](const Template& entry) { return theirs.find(entry.id) != nullptr; };
    if (!base.templates.empty() && std::none_of(base.templates.begin(), base.templates.end(), known))
        return std::nullopt; // another library altogether lies there now
    LandmarkLibrary merged;
    merged.extractor = theirs.extractor;
    const Template* chosen = nullptr;
    for (const Template& entry : theirs.templates) {
        if (!choose(base.find(entry.id), mine.find(entry.id), &entry, chosen)) return std::nullopt;
        if (chosen) merged.templates.push_back(*chosen);
    }
    for (const Template& entry : mine.templates) {
        if (theirs.find(entry.id) != nullptr) continue;
        if (!choose(base.find(entry.id), &entry, nullptr, chosen)) return std::nullopt;
        if (chosen) merged.templates.push_back(*chosen);
    }
    return merged;
}

} // namespace farol::ui
