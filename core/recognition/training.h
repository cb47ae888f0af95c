#pragma once
// From photographs to templates (paper section 2: templates are photographed at about 2 m from several
// sides).

#include "core/base/error.h"
#include "core/recognition/landmark_library.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace farol::recognition {

struct TrainingRequest {
    TemplateId id;
    Kind kind = Kind::Other;
    std::string name;
    std::optional<double> widthM, heightM;
};

/// Adds one photograph (JPEG or PNG bytes) to a template of the library, which is made when it is new. An
/// outline must be convex and inside the picture; without one the whole picture counts (kind place: always
/// the whole). InvalidArgument when the outline is wrong or the kind differs from the template's; Corrupt
/// when the picture cannot be decoded; NotFound when too few features lie inside the outline (the message
/// says how many, and what to do).
Result<void> addView(LandmarkLibrary& library, const TrainingRequest& request,
                     const std::string& pictureBytes, const std::optional<Quad>& outline);

struct Retrained {
    LandmarkLibrary library;
    std::vector<Error> refused; ///< views that do not serve the new extractor
};

/// The same templates with another extractor, from their photographs (see loadPhotographs). `progress` is
/// told views done and in all.
Result<Retrained> retrain(const LandmarkLibrary& photographs, const ExtractorOptions& extractor,
                          const std::function<void(std::size_t, std::size_t)>& progress = {});

/// False when there is no such template.
bool removeTemplate(LandmarkLibrary& library, const TemplateId& id);

} // namespace farol::recognition
