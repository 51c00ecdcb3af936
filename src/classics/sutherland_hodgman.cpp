// Sutherland and Hodgman 1974: any contour clipped to a convex one (Skvortsov, section 2.2, figure 4).
//
// Idea: the convex window is where the half-planes left of its sides overlap, so clip by one after another
// (half_plane_clip.h, exactly), and round the crossings at the end. Also the prepared window: the same with the
// window's sides at hand, and polygons whose box is outside or inside the window told at once.
#include <oblast/classics.h>

#include <algorithm>

#include "classics/arrangement.h"
#include "classics/contours.h"
#include "classics/half_plane_clip.h"
#include "classics/round_clip.h"
#include "classics/settle.h"
#include "exact/orientation.h"
#include "overlay/simple_ring.h"
#include "overlay/validate.h"

namespace oblast {

struct ClipWindow::Prepared {
  RegionSet regions;  ///< as given, for the settled noding
  classics::ConvexWindow convex;
};

namespace {

using classics::ConvexWindow;
using classics::Ring;

constexpr const char* name = "Sutherland-Hodgman";
constexpr const char* instead = "Weiler-Atherton or overlay";

enum class Place { outside, inside, across };

/// By boxes; `inside` also needs the corners of the box left of every side.
Place place_of(std::span<const Point> contour, const ConvexWindow& window) {
  Point low = contour[0], high = contour[0];
  for (const Point& p : contour) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (high.x < window.low.x || low.x > window.high.x || high.y < window.low.y || low.y > window.high.y)
    return Place::outside;
  for (const classics::Line& side : window.sides)
    for (const Point& corner : {low, Point{high.x, low.y}, high, Point{low.x, high.y}})
      if (exact::orientation(side.p, side.q, corner) <= 0) return Place::across;
  return Place::inside;
}

/// The subject as regular contours with the interior on the left.
class Subject {
 public:
  Subject(const RegionView& regions, const ConvexWindow* skip_outside) : operand_{regions, 0, name, instead} {
    bool all_inside = skip_outside != nullptr;
    std::size_t polygons = 0;
    for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
      if (skip_outside) {
        const Place place = place_of_polygon(p, *skip_outside);
        if (place == Place::outside) continue;
        all_inside &= place == Place::inside;
      }
      ++polygons;
      read(p);
    }
    all_inside_ = all_inside;
    if (polygons < 2) return;
    const classics::OwnMeetings own = classics::require_regular(operand_, rings);
    bool interior_left = true;
    classics::require_one_side(operand_, rings, own, "the polygon overlaps another one", interior_left);
  }

  bool all_inside() const { return all_inside_; }

  std::vector<Ring> rings;

 private:
  Place place_of_polygon(std::size_t p, const ConvexWindow& window) const {
    const RegionView& regions = operand_.regions;
    const std::uint32_t first = regions.polygon_begin(p), last = regions.polygon_end(p);
    if (first == last) return Place::outside;
    const std::uint32_t begin = regions.contour_begin(first), end = regions.contour_end(last - 1);
    return begin == end ? Place::outside : place_of(regions.points.subspan(begin, end - begin), window);
  }

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

  /// A general polygon to the regular one that is the same region, as the library reads polygons anywhere.
  void resolve(std::uint32_t begin, std::uint32_t end) {
    if (begin == end) return;
    const RegionView& regions = operand_.regions;
    const std::uint32_t first_point = regions.contour_begin(begin);
    std::vector<std::uint32_t> ends(regions.contour_ends.begin() + begin, regions.contour_ends.begin() + end);
    for (std::uint32_t& e : ends) e -= first_point;
    Options options;
    options.fill_a = FillRule::even_odd();
    const RegionSet regular = unite({regions.points.subspan(first_point, ends.back()), ends, {}}, options);
    for (std::size_t c = 0; c < regular.contour_ends.size(); ++c) {
      rings.push_back(classics::clean_ring(regular.view().contour(c)));
      rings.back().contour = begin;
    }
  }

  classics::Operand operand_;
  bool all_inside_ = false;
};

RegionSet clip_to(const ConvexWindow& window, const RegionView& window_regions, const RegionView& regions,
                  const Subject& subject, ClassicReport& done) {
  classics::Contours contours;
  if (subject.all_inside()) {
    for (const Ring& ring : subject.rings) {
      for (const Point& p : ring.points) contours.add(p);
      contours.close();
    }
    return contours.to_region_set();
  }
  bool clear = window.safe_magnitudes && classics::has_safe_magnitudes(subject.rings);
  if (clear) {
    classics::HalfPlaneClip clip(subject.rings, window);
    clear = clip.run() && classics::round_clip(clip, subject.rings, window, contours, done.meetings);
    done.steps = window.sides.size();
  }
  return clear ? contours.to_region_set() : classics::settle(regions, window_regions, Operation::intersection, done);
}

ConvexWindow read_window(const RegionView& window) {
  validate(window, 1);
  return ConvexWindow(classics::Operand{window, 1, name, instead}.one_convex_contour());
}

RegionSet rectangle(double x0, double y0, double x1, double y1) {
  if (!(x0 < x1) || !(y0 < y1))
    throw Error(ErrorCode::precondition, "the clip window is empty: it needs x0 < x1 and y0 < y1", {1});
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}};
}

RegionSet copy(const RegionView& v) {
  return {{v.points.begin(), v.points.end()},
          {v.contour_ends.begin(), v.contour_ends.end()},
          {v.polygon_ends.begin(), v.polygon_ends.end()}};
}

}  // namespace

RegionSet sutherland_hodgman(const RegionView& subject, const RegionView& window, ClassicReport* report) {
  ClassicReport unused;
  ClassicReport& done = report ? *report : unused;
  done = {};
  validate(subject, 0);
  const ConvexWindow convex = read_window(window);
  return clip_to(convex, window, subject, Subject(subject, nullptr), done);
}

ClipWindow::ClipWindow(const RegionView& window)
    : prepared_(std::make_unique<const Prepared>(Prepared{copy(window), read_window(window)})) {}

ClipWindow::ClipWindow(double x0, double y0, double x1, double y1) : ClipWindow(rectangle(x0, y0, x1, y1)) {}

ClipWindow::~ClipWindow() = default;
ClipWindow::ClipWindow(ClipWindow&&) noexcept = default;
ClipWindow& ClipWindow::operator=(ClipWindow&&) noexcept = default;

RegionSet ClipWindow::clip(const RegionView& subject, ClassicReport* report) const {
  ClassicReport unused;
  ClassicReport& done = report ? *report : unused;
  done = {};
  validate(subject, 0);
  return clip_to(prepared_->convex, prepared_->regions, subject, Subject(subject, &prepared_->convex), done);
}

}  // namespace oblast
