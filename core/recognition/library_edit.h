#pragma once
// Changes to a library as values: what stood there, and what stands there now. An editor keeps them for undo
// and redo; nothing here knows of windows.

#include "core/base/error.h"
#include "core/recognition/landmark_library.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace farol::recognition {

/// One template put in, changed or taken out at `index`.
struct TemplateEdit {
    std::size_t index = 0;
    std::optional<Template> before; ///< empty: it was not there
    std::optional<Template> after;  ///< empty: it is gone
};

/// What the user sees as one step; made in this order.
using LibraryStep = std::vector<TemplateEdit>;

LibraryStep reversed(LibraryStep step);
void apply(LandmarkLibrary& library, const LibraryStep& step);

/// Behind the others. Conflict where its id is taken.
Result<LibraryStep> insertion(const LandmarkLibrary& library, Template fresh);
/// Name, id, kind, size or views. Conflict where the id is taken. A change between a place and an object
/// makes the features anew from the photographs, and fails where they do not serve.
Result<LibraryStep> change(const LandmarkLibrary& library, std::size_t index, Template after);
/// The views of `from` become views of `into`, which keeps its name; places and objects do not mix.
Result<LibraryStep> merged(const LandmarkLibrary& library, std::size_t into, std::size_t from);
/// Some views, but not all, become a template of their own.
Result<LibraryStep> split(const LandmarkLibrary& library, std::size_t index,
                          const std::vector<std::size_t>& views, const TemplateId& id);
/// The template without some of its views, but not without all.
Result<LibraryStep> withoutViews(const LandmarkLibrary& library, std::size_t index,
                                 const std::vector<std::size_t>& views);
LibraryStep removal(const LandmarkLibrary& library, std::size_t index);

} // namespace farol::recognition
