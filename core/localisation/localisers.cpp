#include "core/localisation/localisers.h"

#include "core/localisation/bayes_localiser.h"
#include "core/localisation/voting_localiser.h"

namespace farol::localisation {

std::vector<std::string> localiserNames() {
    return {"voting", "voting-literal", "bayes", "bayes-guided", "bayes-guided-sparse"};
}

Result<std::unique_ptr<Localiser>> makeLocaliser(const std::string& name,
                                                 std::shared_ptr<const building::Building> building) {
    if (name == "bayes") return makeBayesLocaliser(std::move(building));
    if (name == "bayes-guided" || name == "bayes-guided-sparse") {
        BayesOptions options;
        options.walking = WalkingOptions::obedient();
        if (name == "bayes-guided") {
            options.sensors = SensorOptions::ofCamera();
            // Speeds told by pictures scatter by some 45 %, those of people who walk by about half of that.
            options.walking.paceTrust = 0.4;
        }
        return makeBayesLocaliser(std::move(building), options);
    }
    if (name == "voting") return makeVotingLocaliser(std::move(building));
    if (name == "voting-literal")
        return makeVotingLocaliser(std::move(building), VotingOptions::literal(), name);
    return Error{ErrorCode::InvalidArgument,
                 "there is no localiser of this name; there are voting, voting-literal, bayes, bayes-guided "
                 "and bayes-guided-sparse",
                 name};
}

} // namespace farol::localisation
