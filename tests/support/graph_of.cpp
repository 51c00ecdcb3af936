// The stages one after the other.
#include "support/graph_of.h"

#include "engines/leonov_nikitin/label.h"
#include "verify/text_regions.h"

namespace oblast::testing {
using namespace internal;

Linked linked_of(const RegionView& a, const RegionView& b, Operation operation, const Options& options) {
  Linked l;
  l.graph = graph_of(a, &b, options);
  l.selection = select(l.graph, leonov_nikitin::label(l.graph), operation, options);
  l.contours = link(l.graph, l.selection, options.contours);
  l.rings = contours_to_rings(l.graph, l.selection, l.contours);
  return l;
}

Linked linked_of(const Question& question) {
  const RegionSet a = verify::regions_of(question.a), b = verify::regions_of(question.b);
  return linked_of(a, b, question.operation, question.options);
}

}  // namespace oblast::testing
