// Areas of a coverage that several features cover, or that they enclose and none covers.
#pragma once

#include <oblast/check_features.h>

#include <vector>

#include "check/layer_contacts.h"
#include "check/layer_edges.h"

namespace oblast::internal::checking {

/// Adds a fault for each connected area that two features or more cover; and one for each crossing of two borders whose
/// area rounding closed. REQUIRES: edges are sorted. Cost: that of `partition`.
void add_overlaps(const FeatureView& features, const LayerEdges& edges, const LayerContacts& contacts,
                  std::vector<FeatureFault>& faults);

/// Adds a fault for each bounded area that no feature covers, and whose outer border is made of edges of more than one
/// feature. REQUIRES: edges are sorted. Cost: that of `overlay`.
void add_gaps(const FeatureView& features, const LayerEdges& edges, const LayerContacts& contacts,
              std::vector<FeatureFault>& faults);

}  // namespace oblast::internal::checking
