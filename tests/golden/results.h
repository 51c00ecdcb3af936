// The results of an input that its digests include.
#pragma once

#include <oblast/buffer.h>
#include <oblast/features.h>
#include <oblast/options.h>
#include <oblast/region_set.h>
#include <oblast/zones.h>

#include <initializer_list>
#include <span>

#include "golden/digest.h"
#include "golden/digest_file.h"

namespace oblast::golden {

/// All four operations on A and B.
InputAndResult four_operations(const RegionView& a, const RegionView& b, const Options& options);
/// A op B op C ...; the union of A if it is the only operand.
InputAndResult folded(std::span<const RegionSet> operands, Operation operation, const Options& options);
/// The union of A under each rule.
InputAndResult unions(const RegionView& a, std::initializer_list<FillRule> rules);
/// Hull, layers under either rule, and the triangulation of A.
InputAndResult hull_layers_triangulation(const RegionView& a);
/// Identity and union of two layers, dissolve and depth of A by groups, partition by both. Each polygon is a feature.
InputAndResult rows(const RegionView& a, const RegionView& b, const Options& options);
/// The zone of the shapes.
InputAndResult buffer_zone(const ShapeView& shapes, double distance, const BufferOptions& options);
/// The zones of the shapes, each an object, in the frame of zones().
InputAndResult proximity_zones(const ShapeView& shapes, const ZoneOptions& options);

}  // namespace oblast::golden
