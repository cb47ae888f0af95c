#pragma once
// What is said of a landmark library and of training: the module's table of sentences (core/base/saying.h).

#include <string>
#include <vector>

namespace farol::recognition {

enum class Saying {
    LibraryVersion,
    LibraryLater,
    LibraryNone,
    LibraryNotRead,
    LibraryNotSaved,
    LibraryNoGeoPackage,
    TemplateNoName,
    TemplateTwice,
    ViewWithoutTemplate,
    PhotographMissing,
    ExtractorNotRead,
    ExtractorUnusable,
    ExtractorOther,
    ExtractorUnknown,
    ExtractorVersion,
    ExtractorSize,
    ExtractorKeypoints,
    ExtractorContrast,
    ViewDamaged,
    ViewOutline,
    ViewWidth,
    ViewSize,
    ViewChecksum,
    KeypointsBegin,
    KeypointsSize,
    KeypointsLength,
    KeypointsOther,
    KeypointValue,
    DescriptorsBegin,
    DescriptorsSize,
    DescriptorsLength,
    DescriptorsOther,
    DescriptorsCount,
    LayerNotReplaced,
    LayerNotMade,
    FieldNotMade,
    VersionNotReplaced,
    LayerNotFarols,
    NoViewChosen,
    LastView,
    NameMissing,
    NameTaken,
    NoView,
    SizeNotPositive,
    MergedWithItself,
    MergedPlaceAndObject,
    OutlineNumbers,
    OutlineLeaves,
    OutlineOrder,
    OutlineTurned,
    OutlineSmall,
    NameNeeded,
    KindOther,
    FewInPicture,
    FewInOutline,
    PhotographNoPicture,
    PhotographUnusable,
    // Where: names, no sentences.
    TemplateNamed,
    TemplateOf,
    ViewOf,
    SomeViewOf,
    RowOf,
};

std::string said(Saying saying, const std::vector<std::string>& places = {});
std::vector<const char*> sayings();

} // namespace farol::recognition
