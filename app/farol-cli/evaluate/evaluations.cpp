#include "app/farol-cli/evaluate/evaluation.h"

namespace farol::cli {

const std::vector<Evaluation>& evaluations() {
    static const std::vector<Evaluation> kAll{
        {"localisation", "where am I: four localisers on recorded walks", evaluateLocalisation},
        {"text", "floor plates, room numbers and blurred signs", evaluateText},
    };
    return kAll;
}

} // namespace farol::cli
