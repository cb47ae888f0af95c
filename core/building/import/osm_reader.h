#pragma once
// The features of an OpenStreetMap file: XML or PBF through OGR with our own configuration, or the GeoJSON
// made of it.

#include "core/building/import/tagged_feature.h"

namespace farol::building {

/// Does the head of a member look like OpenStreetMap (0 no, higher is surer)?
int looksLikeOsm(const SourceMember& member, const std::string& head);

Result<std::vector<TaggedFeature>> readOsmFeatures(const SourceListing& source, const SourceMember& member,
                                                   std::vector<Finding>& findings);

} // namespace farol::building
