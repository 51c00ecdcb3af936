#include "window/fast_path.h"

#include <array>
#include <cstddef>

#include "base/block_resource.h"
#include "window/window_clip.h"

namespace oblast::internal::window {
namespace {

/// What differs from the defaults is left to the pipeline; so are statistics and progress, which tell of its stages.
bool are_default(const Options& options) {
  return options.engine == Engine::leonov_nikitin && options.collinear == CollinearVertices::keep &&
         options.fill_a.kind == FillRule::Kind::polygons && options.fill_b.kind == FillRule::Kind::polygons &&
         !options.statistics && !options.progress;
}

}  // namespace

std::optional<RegionSet> fast_overlay(const RegionView& a, const RegionView& b, Operation operation,
                                      const Options& options, RegionSet* spare) {
  const bool intersection = operation == Operation::intersection;
  if (operation == Operation::symmetric_difference || !are_default(options)) return {};
  const bool one_b = b.contour_count() == 1, one_a = a.contour_count() == 1;
  if (!one_b && !(intersection && one_a)) return {};

  std::array<std::byte, scratch_bytes> scratch;
  BlockResource blocks;
  std::pmr::monotonic_buffer_resource memory(scratch.data(), scratch.size(), &blocks);
  std::optional<Window> window;
  if (one_b) window = Window::of(b.contour(0), &memory);
  const bool exchanged = !window && intersection && one_a;
  if (exchanged) window = Window::of(a.contour(0), &memory);
  if (!window) return {};
  const RegionView& subject = exchanged ? b : a;
  const SubjectKind kind = kind_of(subject);
  if (!intersection && (kind != SubjectKind::convex || subject.points.size() > Window::most_sides)) return {};
  return WindowClip(subject, kind, *window, &memory).run(operation, spare);
}

}  // namespace oblast::internal::window
