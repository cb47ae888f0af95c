#include "core/localisation/identity.h"

#include "core/base/text.h"

#include <algorithm>

namespace farol::localisation {

namespace {

bool knownByWords(Kind kind) {
    return kind == Kind::Text || kind == Kind::Sign;
}

bool sameText(const std::string& a, const std::string& b, int tolerance) {
    if (a == b) return true;
    if (tolerance <= 0) return false;
    // One letter of a one-letter text is the whole of it.
    auto shorter = static_cast<int>(std::min(a.size(), b.size()));
    return shorter > tolerance && editDistance(a, b) <= tolerance;
}

} // namespace

Identity identityOf(const recognition::Detection& detection) {
    return {detection.kind, detection.templateId, foldedForMatching(detection.text)};
}

Identity identityOf(const building::Landmark& landmark) {
    return {landmark.kind, landmark.templateId, foldedForMatching(landmark.text)};
}

bool sameThing(const Identity& a, const Identity& b, int textTolerance) {
    if (!a.templateId.empty() && !b.templateId.empty()) return a.templateId == b.templateId;
    if (a.kind == Kind::Place || b.kind == Kind::Place) return false;
    // The reader answers "text" whatever the words stand on: a door plate or a sign in the map is meant as
    // well.
    bool read = a.kind == Kind::Text || b.kind == Kind::Text;
    if (read && !a.text.empty() && !b.text.empty()) return sameText(a.text, b.text, textTolerance);
    if (a.kind != b.kind) return false;
    return !knownByWords(a.kind) || sameText(a.text, b.text, textTolerance);
}

} // namespace farol::localisation
