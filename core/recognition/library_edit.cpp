#include "core/recognition/library_edit.h"

#include "core/recognition/sayings.h"
#include "core/recognition/training.h"

#include <algorithm>
#include <utility>

namespace farol::recognition {

namespace {

Error wrong(ErrorCode code, const std::string& message, const TemplateId& id) {
    return {code, message, said(Saying::TemplateNamed, {id.value})};
}

/// The features anew: the views that other views are computed from may have gone, or the kind is another.
Result<Template> trainedAgain(const LandmarkLibrary& library, const Template& entry) {
    LandmarkLibrary alone;
    alone.extractor = library.extractor;
    alone.templates = {entry};
    auto fresh = retrain(alone, library.extractor);
    if (!fresh) return fresh.error();
    if (!fresh->refused.empty()) return fresh->refused.front();
    return std::move(fresh->library.templates.front());
}

bool chosen(const std::vector<std::size_t>& views, std::size_t view) {
    return std::find(views.begin(), views.end(), view) != views.end();
}

/// The two parts of the template's views; an error where one of them would be empty.
Result<std::pair<std::vector<View>, std::vector<View>>> parted(const Template& entry,
                                                               const std::vector<std::size_t>& views) {
    std::vector<View> rest, taken;
    for (std::size_t i = 0; i < entry.views.size(); ++i)
        (chosen(views, i) ? taken : rest).push_back(entry.views[i]);
    if (taken.empty()) return wrong(ErrorCode::InvalidArgument, said(Saying::NoViewChosen), entry.id);
    if (rest.empty()) return wrong(ErrorCode::InvalidArgument, said(Saying::LastView), entry.id);
    return std::pair(std::move(rest), std::move(taken));
}

} // namespace

LibraryStep reversed(LibraryStep step) {
    std::reverse(step.begin(), step.end());
    for (TemplateEdit& edit : step) std::swap(edit.before, edit.after);
    return step;
}

void apply(LandmarkLibrary& library, const LibraryStep& step) {
    for (const TemplateEdit& edit : step) {
        const auto at = library.templates.begin() + static_cast<std::ptrdiff_t>(edit.index);
        if (edit.before && edit.after)
            *at = *edit.after;
        else if (edit.after)
            library.templates.insert(at, *edit.after);
        else if (edit.before)
            library.templates.erase(at);
    }
}

Result<LibraryStep> insertion(const LandmarkLibrary& library, Template fresh) {
    if (fresh.id.empty()) return wrong(ErrorCode::InvalidArgument, said(Saying::NameMissing), fresh.id);
    if (library.find(fresh.id) != nullptr)
        return wrong(ErrorCode::Conflict, said(Saying::NameTaken), fresh.id);
    if (fresh.views.empty()) return wrong(ErrorCode::InvalidArgument, said(Saying::NoView), fresh.id);
    return LibraryStep{{library.templates.size(), std::nullopt, std::move(fresh)}};
}

Result<LibraryStep> change(const LandmarkLibrary& library, std::size_t index, Template after) {
    const Template& before = library.templates[index];
    if (after.id.empty()) return wrong(ErrorCode::InvalidArgument, said(Saying::NameMissing), before.id);
    if (after.id != before.id && library.find(after.id) != nullptr)
        return wrong(ErrorCode::Conflict, said(Saying::NameTaken), after.id);
    for (const auto& size : {after.widthM, after.heightM})
        if (size && !(*size > 0.0 && *size < 1000.0))
            return wrong(ErrorCode::InvalidArgument, said(Saying::SizeNotPositive), after.id);
    if (after.kind != before.kind) after.unknownKind.clear();
    if ((after.kind == Kind::Place) != (before.kind == Kind::Place)) {
        auto again = trainedAgain(library, after);
        if (!again) return again.error();
        after = std::move(*again);
    }
    return LibraryStep{{index, before, std::move(after)}};
}

Result<LibraryStep> merged(const LandmarkLibrary& library, std::size_t into, std::size_t from) {
    const Template& kept = library.templates[into];
    const Template& gone = library.templates[from];
    if (into == from) return wrong(ErrorCode::InvalidArgument, said(Saying::MergedWithItself), kept.id);
    if ((kept.kind == Kind::Place) != (gone.kind == Kind::Place))
        return wrong(ErrorCode::InvalidArgument, said(Saying::MergedPlaceAndObject), kept.id);
    Template after = kept;
    after.views.insert(after.views.end(), gone.views.begin(), gone.views.end());
    if (!after.widthM) after.widthM = gone.widthM;
    if (!after.heightM) after.heightM = gone.heightM;
    return LibraryStep{{into, kept, std::move(after)}, {from, gone, std::nullopt}};
}

Result<LibraryStep> split(const LandmarkLibrary& library, std::size_t index,
                          const std::vector<std::size_t>& views, const TemplateId& id) {
    const Template& entry = library.templates[index];
    auto parts = parted(entry, views);
    if (!parts) return parts.error();
    Template rest = entry, fresh = entry;
    rest.views = std::move(parts->first);
    fresh.views = std::move(parts->second);
    fresh.id = id;
    fresh.name.clear();
    auto step = insertion(library, fresh);
    if (!step) return step.error();
    auto restAgain = trainedAgain(library, rest);
    if (!restAgain) return restAgain.error();
    auto freshAgain = trainedAgain(library, fresh);
    if (!freshAgain) return freshAgain.error();
    return LibraryStep{{index, entry, std::move(*restAgain)},
                       {library.templates.size(), std::nullopt, std::move(*freshAgain)}};
}

Result<LibraryStep> withoutViews(const LandmarkLibrary& library, std::size_t index,
                                 const std::vector<std::size_t>& views) {
    const Template& entry = library.templates[index];
    auto parts = parted(entry, views);
    if (!parts) return parts.error();
    Template rest = entry;
    rest.views = std::move(parts->first);
    auto again = trainedAgain(library, rest);
    if (!again) return again.error();
    return LibraryStep{{index, entry, std::move(*again)}};
}

LibraryStep removal(const LandmarkLibrary& library, std::size_t index) {
    return {{index, library.templates[index], std::nullopt}};
}

} // namespace farol::recognition
