#pragma once
// The localisers by name, for --localiser and settings.

#include "core/base/error.h"
#include "core/localisation/localiser.h"

#include <memory>
#include <string>
#include <vector>

namespace farol::localisation {

/// "voting", "voting-literal", "bayes", "bayes-guided" (for those who know the way only from what is said),
/// "bayes-guided-sparse" (the same, for eyes as poor as those of the localisation study).
/// InvalidArgument names them for any other.
Result<std::unique_ptr<Localiser>> makeLocaliser(const std::string& name,
                                                 std::shared_ptr<const building::Building> building);
std::vector<std::string> localiserNames();

} // namespace farol::localisation
