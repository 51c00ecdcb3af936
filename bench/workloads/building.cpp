// Functions that the workload generators share.
#include "workloads/workloads.h"

namespace oblast::bench {

const NamedWorkload* find_workload(std::string_view name) {
  for (const auto list : {general_workloads(), window_workloads(), ioverlay_workloads()}) {
    for (const NamedWorkload& workload : list) {
      if (name == workload.name) return &workload;
    }
  }
  return nullptr;
}

void add_hole(RegionSet& regions, std::span<const Point> contour) {
  regions.points.insert(regions.points.end(), contour.begin(), contour.end());
  regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
  regions.polygon_ends.back() = static_cast<std::uint32_t>(regions.contour_ends.size());
}

void add_polygon(RegionSet& regions, std::span<const Point> contour) {
  regions.polygon_ends.push_back(0);
  add_hole(regions, contour);
}

void add_rectangle(RegionSet& regions, double x0, double y0, double x1, double y1) {
  const Point corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  add_polygon(regions, corners);
}

Workload single(Operation operation, RegionSet a, RegionSet b, OperandKind kind_a, OperandKind kind_b,
                FillRule::Kind fill) {
  if (kind_a != OperandKind::crossing) orient(a);
  if (kind_b != OperandKind::crossing) orient(b);
  Workload workload;
  workload.operation = operation;
  workload.fill = fill;
  workload.a.kind = kind_a;
  workload.b.kind = kind_b;
  workload.a.add(a);
  workload.b.add(b);
  return workload;
}

}  // namespace oblast::bench
