#include "core/recognition/sayings.h"

#include "core/base/saying.h"

namespace farol::recognition {

namespace {

constexpr farol::Saying<Saying> kTable[]{
    {Saying::LibraryVersion, SAID("core", "the library's version is not a number: \"%1\"")},
    {Saying::LibraryLater,
     SAID("core",
          "the landmark library is of a later version (%1) than this program knows (%2); update Farol")},
    {Saying::LibraryNone, SAID("core", "holds no landmark library (no layers templates and views)")},
    {Saying::LibraryNotRead, SAID("core", "the landmark library cannot be read")},
    {Saying::LibraryNotSaved, SAID("core", "cannot save the library: %1")},
    {Saying::LibraryNoGeoPackage, SAID("core", "is not a GeoPackage, and a library is kept in one (*.gpkg)")},
    {Saying::TemplateNoName, SAID("core", "a template has no name")},
    {Saying::TemplateTwice, SAID("core", "template %1 stands twice")},
    {Saying::ViewWithoutTemplate, SAID("core", "a view belongs to a template that is not in the library")},
    {Saying::PhotographMissing, SAID("core", "the photograph or its outline is missing")},
    {Saying::ExtractorNotRead, SAID("core", "the extractor's parameters cannot be read: \"%1\"")},
    {Saying::ExtractorUnusable,
     SAID("core", "the library was trained with %1, but %2; train it again from its photographs")},
    {Saying::ExtractorOther, SAID("core", "the library was trained with %1, but %2 is in use; train it again "
                                          "from its photographs, or choose its own extractor")},
    {Saying::ExtractorUnknown, SAID("core", "there is no feature extractor \"%1\"; there are %2")},
    {Saying::ExtractorVersion, SAID("core", "version %1 of %2 is not known, only %3")},
    {Saying::ExtractorSize, SAID("core", "the working size must be between 64 and 4096 pixels")},
    {Saying::ExtractorKeypoints, SAID("core", "the number of keypoints must be between 10 and 20000")},
    {Saying::ExtractorContrast, SAID("core", "the contrast threshold must be between 0 and 1")},
    {Saying::ViewDamaged, SAID("core", "%1; the library is damaged: restore it or train this view again")},
    {Saying::ViewOutline, SAID("core", "the outline \"%1\" is not eight numbers")},
    {Saying::ViewWidth, SAID("core", "the descriptors are not of the width that %1 makes")},
    {Saying::ViewSize, SAID("core", "the photograph's size is missing")},
    {Saying::ViewChecksum, SAID("core", "the checksum does not fit the photograph and its features")},
    {Saying::KeypointsBegin, SAID("core", "the keypoints do not begin as they should")},
    {Saying::KeypointsSize, SAID("core", "the keypoints have an impossible size")},
    {Saying::KeypointsLength, SAID("core", "the keypoints are cut off or too long")},
    {Saying::KeypointsOther, SAID("core", "the keypoints are of another kind")},
    {Saying::KeypointValue, SAID("core", "a keypoint has an impossible value")},
    {Saying::DescriptorsBegin, SAID("core", "the descriptors do not begin as they should")},
    {Saying::DescriptorsSize, SAID("core", "the descriptors have an impossible size")},
    {Saying::DescriptorsLength, SAID("core", "the descriptors are cut off or too long")},
    {Saying::DescriptorsOther, SAID("core", "the descriptors are of another kind")},
    {Saying::DescriptorsCount, SAID("core", "there are not as many descriptors as keypoints")},
    {Saying::LayerNotReplaced, SAID("core", "cannot replace the layer")},
    {Saying::LayerNotMade, SAID("core", "cannot make the layer")},
    {Saying::FieldNotMade, SAID("core", "cannot make the field %1")},
    {Saying::VersionNotReplaced, SAID("core", "cannot replace the version")},
    {Saying::LayerNotFarols,
     SAID("core", "the layer has no fields key and value: this is not one of Farol's files")},
    {Saying::NoViewChosen, SAID("core", "no view is chosen")},
    {Saying::LastView, SAID("core", "a template needs at least one view; delete it instead")},
    {Saying::NameMissing, SAID("core", "a template needs a name of its own")},
    {Saying::NameTaken, SAID("core", "this name is taken by another template")},
    {Saying::NoView, SAID("core", "a template needs at least one view")},
    {Saying::SizeNotPositive, SAID("core", "a real size must be a positive number of metres")},
    {Saying::MergedWithItself, SAID("core", "a template cannot be merged with itself")},
    {Saying::MergedPlaceAndObject,
     SAID("core", "a place and an object cannot be one template; choose two of the same sort")},
    {Saying::OutlineNumbers, SAID("core", "the outline has a corner that is no number")},
    {Saying::OutlineLeaves, SAID("core", "the outline leaves the picture, which is %1 x %2 pixels")},
    {Saying::OutlineOrder, SAID("core", "the outline's four corners must follow the object's border "
                                        "clockwise from its top left, without crossing")},
    {Saying::OutlineTurned,
     SAID("core",
          "the outline's corners run counter-clockwise; give them clockwise from the object's top left")},
    {Saying::OutlineSmall,
     SAID("core", "the outline is only %1 x %2 pixels; photograph the object from nearer")},
    {Saying::NameNeeded, SAID("core", "a template needs a name")},
    {Saying::KindOther, SAID("core", "this template is of kind %1, not %2; use another template name")},
    {Saying::FewInPicture,
     SAID("core", "only %1 features were found in the picture; at least %2 are needed: take a sharp, well "
                  "lit photograph of something with detail, from nearer")},
    {Saying::FewInOutline,
     SAID("core", "only %1 features were found inside the outline; at least %2 are needed: take a sharp, "
                  "well lit photograph of something with detail, from nearer")},
    {Saying::PhotographNoPicture, SAID("core", "the photograph cannot be read as a picture")},
    {Saying::PhotographUnusable, SAID("core", "the photograph cannot be used: %1")},
    // Where: names, no sentences.
    {Saying::TemplateNamed, SAID("core", "template %1")},
    {Saying::TemplateOf, SAID("core", "%1, template %2")},
    {Saying::ViewOf, SAID("core", "%1, view %2")},
    {Saying::SomeViewOf, SAID("core", "%1, a view of template %2")},
    {Saying::RowOf, SAID("core", "%1, row %2")},
};
static_assert(inOrder(kTable), "said() looks rows up by their number");

} // namespace

std::string said(Saying saying, const std::vector<std::string>& places) {
    return withPlaces(kTable[static_cast<std::size_t>(saying)].english, places);
}

std::vector<const char*> sayings() {
    return englishOf(kTable);
}

} // namespace farol::recognition
