#include "app/farol-cli/evaluate/evaluation.h"

namespace farol::cli {

const std::vector<Evaluation>& evaluations() {
    static const std::vector<Evaluation> kAll{
        {"doors", "doors of photographs and of the corridor walk", evaluateDoors},
        {"guidance", "does a walker who hears nothing but cues arrive?", evaluateGuidance},
        {"localisation", "where am I: four localisers on recorded walks", evaluateLocalisation},
        {"places", "which floor: places of a tower, its publishers' split", evaluatePlaces},
        {"recognition", "trained planes in composed frames, 100 and 1000 templates", evaluateRecognition},
        {"scenes", "how alike frames of one scene and of different ones are", evaluateScenes},
        {"signs", "exit signs of photographs, and what is mistaken for signs", evaluateSigns},
        {"stairs", "stairs of photographs, and what is mistaken for them", evaluateStairs},
        {"text", "floor plates, room numbers and blurred signs", evaluateText},
    };
    return kAll;
}

} // namespace farol::cli
