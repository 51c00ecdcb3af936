// Sutherland and Hodgman 1974: any contour clipped to a convex one (Skvortsov, section 2.2, figure 4).
//
// Idea: the convex window is the intersection of the half-planes left of its sides. So clip by one after another,
// exactly (half_plane_clip.h), and round the crossings at the end.
#include <oblast/classics.h>

#include "base/call_memory.h"
#include "classics/arrangement.h"
#include "classics/half_plane_clip.h"
#include "classics/round_clip.h"
#include "classics/settle.h"
#include "noding/simple_ring.h"
#include "window/contours.h"

namespace oblast {
using namespace internal;

namespace {

using classics::ConvexWindow;
using classics::Ring;

constexpr const char* name = "Sutherland-Hodgman";
constexpr const char* instead = "Weiler-Atherton or overlay";

/// The subject as regular contours with the interior on the left.
class Subject {
 public:
  Subject(const RegionView& regions, const CallOptions& options)
      : operand_{regions, 0, name, instead}, options_(options) {
    for (std::size_t p = 0; p < regions.polygon_count(); ++p) read(p);
    if (regions.polygon_count() < 2) return;
    const classics::OwnMeetings own = classics::require_regular(operand_, rings);
    bool interior_left = true;
    classics::require_one_side(operand_, rings, own, "the polygon overlaps another one", interior_left);
  }

  Array<Ring> rings;

 private:
  void read(std::size_t p) {
    const RegionView& regions = operand_.regions;
    const std::uint32_t begin = regions.polygon_begin(p), end = regions.polygon_end(p);
    if (end - begin == 1) {
      Ring ring = classics::clean_ring(regions.contour(begin));
      ring.contour = begin;
      if (ring.size() < 3) return;
      const RingShape shape = ring_shape(ring.points);
      if (shape != RingShape::tangled) {
        if (shape == RingShape::clockwise) classics::reverse(ring);
        rings.push_back(std::move(ring));
        return;
      }
    }
    resolve(begin, end);
  }

  /// Resolves a general polygon to a regular one with the same region, under even-odd.
  void resolve(std::uint32_t begin, std::uint32_t end) {
    if (begin == end) return;
    const RegionSet regular =
        unite(operand_.regions.contours_between(begin, end), classics::overlay_options(options_, FillRule::even_odd()));
    for (std::size_t c = 0; c < regular.contour_ends.size(); ++c) {
      rings.push_back(classics::clean_ring(regular.view().contour(c)));
      rings.back().contour = begin;
    }
  }

  classics::Operand operand_;
  const CallOptions& options_;
};

RegionSet run_sutherland_hodgman(const RegionView& regions, const RegionView& window_regions,
                                 const CallOptions& options, ClassicReport& done) {
  const ConvexWindow window(classics::Operand{window_regions, 1, name, instead}.one_convex_contour());
  const Subject subject(regions, options);
  done.steps = window.sides.size();
  if (window.safe_magnitudes && classics::has_safe_magnitudes(subject.rings)) {
    classics::HalfPlaneClip clip(subject.rings, window);
    window::Contours contours;
    if (clip.run() && classics::round_clip(clip, subject.rings, window, contours, done.meetings))
      return contours.to_region_set();
  }
  return classics::settle(regions, window_regions, Operation::intersection, done, classics::overlay_options(options));
}

}  // namespace

RegionSet sutherland_hodgman(const RegionView& regions, const RegionView& window, ClassicReport* report,
                             const CallOptions& options) {
  return classics::classic_call(regions, window, report, options, [&](ClassicReport& done) {
    return run_sutherland_hodgman(regions, window, options, done);
  });
}

}  // namespace oblast
