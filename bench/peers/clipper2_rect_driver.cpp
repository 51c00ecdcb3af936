// Clipper2's clip by a rectangle (RectClip64), on the integers of clipper2_driver.cpp. It returns separate contours.
#include <clipper2/clipper.h>

#include <cmath>

#include "driver/rectangle.h"

namespace {

using namespace oblast;
namespace clipper = Clipper2Lib;

struct Clipper2Rect {
  static std::string name() { return "clipper2-rect"; }
  static std::string version() { return CLIPPER2_VERSION; }

  struct Prepared {
    clipper::Paths64 a;
    clipper::Rect64 window;
  };

  explicit Clipper2Rect(const bench::Settings& settings) : settings_(settings) {
    if (!settings.integer) scale_ = std::exp2(47 - std::ceil(std::log2(settings.largest)));
  }

  Prepared prepare(const RegionView& a, const RegionView& b) {
    const bench::Rectangle r = bench::clip_rectangle(settings_, b);
    Prepared prepared{clipper::Paths64(a.contour_count()), {scaled(r.x0), scaled(r.y0), scaled(r.x1), scaled(r.y1)}};
    for (std::size_t c = 0; c < prepared.a.size(); ++c) {
      for (const Point& p : a.contour(c)) prepared.a[c].emplace_back(scaled(p.x), scaled(p.y));
    }
    return prepared;
  }

  void run(const Prepared& input, RegionSet& result) {
    for (const clipper::Path64& path : clipper::RectClip(input.window, input.a)) {
      for (const clipper::Point64& p : path) {
        result.points.push_back({static_cast<double>(p.x) / scale_, static_cast<double>(p.y) / scale_});
      }
      result.contour_ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    }
  }

 private:
  std::int64_t scaled(double coordinate) const { return std::llround(coordinate * scale_); }

  bench::Settings settings_;
  double scale_ = 1;
};

}  // namespace

int main(int argc, char** argv) { return bench::drive<Clipper2Rect>(argc, argv); }
