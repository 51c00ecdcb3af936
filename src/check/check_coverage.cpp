// Between features: vertices on edges of others, overlaps, gaps.
#include <oblast/check_features.h>

#include "base/public_call.h"
#include "check/coverage_areas.h"
#include "check/feature_form.h"
#include "check/layer_contacts.h"
#include "check/layer_edges.h"

namespace oblast {
using namespace internal;

std::vector<FeatureFault> check_coverage(const FeatureView& features, const CallOptions& options) {
  return public_call(options, features.regions.points.size(), [&](Control&) {
    checking::validate_features(features);
    std::vector<FeatureFault> faults;
    checking::LayerEdges edges(features);
    const checking::LayerContacts contacts = checking::find_contacts(edges);
    edges.sort();
    checking::add_junctions(edges, contacts, faults);
    checking::add_overlaps(features, edges, contacts, faults);
    checking::add_gaps(features, edges, contacts, faults);
    checking::put_in_order(faults);
    return faults;
  });
}

}  // namespace oblast
