#pragma once
// The trained appearances: templates with their views (paper section 2, "Training Module"). A value: training
// adds to it, the store saves it, the recogniser builds its index from it.

#include "core/base/error.h"
#include "core/base/ids.h"
#include "core/base/kind.h"
#include "core/recognition/feature_extractor.h"

#include <opencv2/core.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace farol::recognition {

/// One photograph of a template, with what was extracted from it. `outline` in pixels of the photograph;
/// keypoints likewise. `jpeg` is the photograph itself, kept so that another extractor can be trained from
/// it.
struct View {
    std::string jpeg;
    ImageSize size;
    Quad outline{};
    Features features;
};

struct Template {
    TemplateId id;
    Kind kind = Kind::Other;
    std::string unknownKind; ///< as it stands in the file when the list of kinds does not have it (kind is
                             ///< Other then)
    std::string name;        ///< for people; the id when empty
    std::optional<double> widthM, heightM; ///< real size
    std::vector<View> views;
};

/// Were both made from the same photographs (of the same training: copies of a library share their
/// features)?
bool sameLook(const Template& a, const Template& b);

struct LandmarkLibrary {
    ExtractorOptions extractor; ///< with which all features were made
    std::vector<Template> templates;

    const Template* find(const TemplateId& id) const;
    std::size_t viewCount() const;
};

/// Reads the `templates`, `views` and `farol` layers of a library file or of a map that holds one. Conflict
/// when it was made with another extractor than `wanted`, or without one wanted by an extractor that this
/// program does not have (both named in the message); UnsupportedFormat for a later version; Corrupt for
/// damaged descriptor blobs (template and view named).
Result<LandmarkLibrary> loadLibrary(const std::string& path,
                                    const std::optional<ExtractorOptions>& wanted = std::nullopt);
/// The same without features, whatever extractor made them: what a library is trained again from.
Result<LandmarkLibrary> loadPhotographs(const std::string& path);
/// In one transaction, other layers of the file untouched; the old file stays whole on failure.
Result<void> saveLibrary(const LandmarkLibrary& library, const std::string& path);

} // namespace farol::recognition
