// The simulation of `generate fires`: satellite passes with their lattices, and the fires that they see.
//
// A month has a budget of contours and vertices (Table 1). It is spent in this order: gas flares (points that many
// passes see), long fires (discs that drift and are seen tens of times), patches (seen one to three times; adjacent
// pixels are merged into L and staircase shapes), and small fires (one pixel, seen one to three times) up to the exact
// number of contours. The number of vertices is exact, too: merging stops when its budget is spent, and the rest of the
// budget is spent on pixel corners that are kept on straight sides of merged contours.
#include "oblast/fires.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "oblast/fires_lattice.h"
#include "oblast/fires_plan.h"
#include "oblast/fires_random.h"

namespace oblast::app {

namespace {

constexpr double west = 30, east = 180, south = 50, north = 72;
constexpr double swath_half_width = 32;  // degrees of longitude: about 1,800 km at 60 degrees north

struct Pass {
  std::string name;
  double centre;  // longitude
  Lattice lattice;
  std::vector<std::vector<OutlineVertex>> outlines;
};

double clamp(double value, double low, double high) { return std::min(std::max(value, low), high); }

// A bell curve without libm: the sum of three uniform numbers, within +-1.5.
// Each number is drawn in a statement, here and below, because compilers choose the order of operands.
double bell(Random& random) {
  double sum = random.uniform();
  sum += random.uniform();
  return sum + random.uniform() - 1.5;
}

bool in_russia(Point p) { return p.x > west + 1 && p.x < east - 1 && p.y > south + 0.5 && p.y < north - 0.5; }

// The regions where fires are frequent are the same in all months: villages, roads and forests.
Point fire_place(std::uint64_t seed, Random& random) {
  while (true) {
    if (random.chance(scattered_share))
      return {random.uniform(west + 1, east - 1), random.uniform(south + 1, north - 3)};
    Random region(mix(seed, 1000 + random.below(fire_region_count)));
    const double x = region.uniform(west, east), y = region.uniform(south, north - 4);
    const double reach_x = region.uniform(0.3, 1.7) * fire_region_km,
                 reach_y = region.uniform(0.3, 1.2) * fire_region_km;
    const Point place{x + bell(random) * reach_x / km_per_degree_lon, y + bell(random) * reach_y / km_per_degree_lat};
    if (in_russia(place)) return place;
  }
}

Point flare_place(std::uint64_t seed, int flare) {
  Random random(mix(seed, 2000 + static_cast<std::uint64_t>(flare)));
  return {random.uniform(66, 84), random.uniform(60, 67)};
}

class Month {
 public:
  Month(const FireMonth& table, const FirePlan& plan, std::uint64_t seed, double scale)
      : table_(table),
        plan_(plan),
        seed_(seed),
        month_seed_(mix(seed, static_cast<std::uint64_t>(table.month))),
        random_(month_seed_),
        files_(scaled(table.files, scale, 1)),
        contours_(std::max(scaled(table.contours, scale, 1), files_)),
        excess_(std::max(0, scaled(table.vertices, scale, 4) - 4 * contours_)) {
    if (table.vertices == 4 * table.contours) excess_ = 0;
  }

  std::vector<FirePass> run() {
    make_passes();
    burn_flares();
    burn_long_fires();
    burn_patches();
    spend_straight_corners();
    burn_small_fires();
    return vectorise();
  }

 private:
  static int scaled(int count, double scale, int least) {
    return std::max(least, static_cast<int>(std::floor(count * scale + 0.5)));
  }

  void make_passes() {
    const double step = table_.days * 1440.0 / files_;
    for (int k = 0; k < files_; ++k) {
      const int minute = static_cast<int>(k * step + random_.uniform() * (step - 1));
      char name[40];
      std::snprintf(name, sizeof name, "fires-2011-%02d-%02d-%02d%02d", table_.month, minute / 1440 + 1,
                    minute % 1440 / 60, minute % 60);
      const double centre = random_.uniform(west - 20, east + 20);
      const int side = random_.chance(0.5) ? 1 : -1;
      const double slope = side * random_.uniform(0.06, 0.35);
      const Point origin{clamp(centre, west, east) + random_.uniform(), 61 + random_.uniform()};
      const double width = random_.uniform(1.0, 2.2), height = random_.uniform(1.0, 1.6);
      passes_.push_back({name, centre, Lattice(origin, slope, width, height), {}});
    }
  }

  bool visible(const Pass& pass, Point place) const { return std::fabs(pass.centre - place.x) < swath_half_width; }

  // A random pass that sees the place; the nearest one if 50 attempts find none (few passes at a small scale).
  Pass& some_pass(Point place) {
    for (int attempt = 0; attempt < 50; ++attempt) {
      Pass& pass = passes_[random_.below(static_cast<std::uint32_t>(passes_.size()))];
      if (visible(pass, place)) return pass;
    }
    return *std::min_element(passes_.begin(), passes_.end(), [&](const Pass& p, const Pass& q) {
      return std::fabs(p.centre - place.x) < std::fabs(q.centre - place.x);
    });
  }

  int left() const { return contours_ - used_; }

  void add_pixel(Pass& pass, Cell cell) {
    pass.outlines.push_back(outline({cell}));
    ++used_;
  }

  // Some pixels of a disc, chosen by a hash of each pixel; the pixel at the centre if none is chosen.
  std::vector<Cell> burning(const Pass& pass, Point centre, double radius_km, double density, std::uint64_t key) const {
    std::vector<Cell> cells = pass.lattice.disc(centre, radius_km);
    std::erase_if(cells, [&](Cell c) {
      const std::uint64_t pixel = mix(mix(key, static_cast<std::uint32_t>(c.i)), static_cast<std::uint32_t>(c.j));
      return unit_interval(pixel) >= density;
    });
    if (cells.empty()) cells.push_back(pass.lattice.cell_at(centre));
    return without_gaps(cells);
  }

  int views_of_small_fire() {
    const double fate = random_.uniform();
    return fate < plan_.seen_thrice ? 3 : fate < plan_.seen_thrice + plan_.seen_twice ? 2 : 1;
  }

  // One pass sees these pixels of a fire. Each becomes a contour, or connected pixels are merged into one.
  void detect(Pass& pass, const std::vector<Cell>& cells, double merged) {
    for (const std::vector<Cell>& component : components(cells)) {
      if (left() <= 0) return;
      if (component.size() == 1 && cells.size() > 1 && random_.chance(merged * stray_pixels_dropped)) continue;
      if (component.size() > 1 && random_.chance(merged)) {
        std::vector<OutlineVertex> contour = outline(component);
        const auto corners =
            std::count_if(contour.begin(), contour.end(), [](const OutlineVertex& v) { return !v.straight; });
        if (corners - 4 <= excess_) {
          excess_ -= static_cast<int>(corners - 4);
          pass.outlines.push_back(std::move(contour));
          ++used_;
          continue;
        }
      }
      for (const Cell cell : component) {
        if (left() <= 0) return;
        add_pixel(pass, cell);
      }
    }
  }

  // A flare is a point: one pixel, sometimes two. The geolocation has an error of a few hundred metres.
  void burn_flares() {
    for (int flare = 0; flare < flare_count; ++flare) {
      const Point place = flare_place(seed_, flare);
      Random own(mix(month_seed_, 3000 + static_cast<std::uint64_t>(flare)));
      const double dim = own.uniform();
      const double share = flare < 2 ? plan_.flare_shares[flare] : 0.18 * dim * dim * dim;
      for (Pass& pass : passes_) {
        if (!visible(pass, place) || !own.chance(share) || used_ * 5 > contours_) continue;
        const Point seen{place.x + 0.3 * bell(own) / km_per_degree_lon, place.y + 0.3 * bell(own) / km_per_degree_lat};
        add_pixel(pass, pass.lattice.cell_at(seen));
      }
    }
  }

  // A disc that drifts and grows. Each view detects some of its pixels.
  void burn_long_fire(int fire) {
    const Point start = fire_place(seed_, random_);
    const double size = random_.uniform();
    const double radius = 0.8 + (plan_.radius_km - 0.8) * size * size;
    const double drift_x = 1.5 * bell(random_) * radius, drift_y = 1.5 * bell(random_) * radius;
    const int views = 8 + static_cast<int>(random_.below(40));
    for (int view = 0; view < views && left() > 0; ++view) {
      const double time = views == 1 ? 0 : static_cast<double>(view) / (views - 1);
      const Point centre{start.x + drift_x * time / km_per_degree_lon, start.y + drift_y * time / km_per_degree_lat};
      Pass& pass = some_pass(start);
      const std::uint64_t key =
          mix(mix(month_seed_, 4000 + static_cast<std::uint64_t>(fire)), static_cast<std::uint64_t>(view));
      detect(pass, burning(pass, centre, radius * (0.4 + 0.6 * time), plan_.density, key), plan_.merged);
    }
  }

  void burn_long_fires() {
    // At least one contour per pass is reserved for the small fires, so no file is empty.
    const int until = std::min(contours_ - files_, static_cast<int>(plan_.long_share * contours_));
    for (int fire = 0; used_ < until; ++fire) burn_long_fire(fire);
  }

  // Until most vertices are spent (straight corners take the rest), or all contours but one per pass.
  void burn_patches() {
    while (excess_ > 100 && used_ < contours_ - files_) {
      const Point place = fire_place(seed_, random_);
      const double size = random_.uniform();
      const double radius = 0.8 + (plan_.patch_km - 0.8) * size * size;
      const int views = views_of_small_fire();
      for (int view = 0; view < views; ++view) {
        Pass& pass = some_pass(place);
        detect(pass, burning(pass, place, radius, plan_.patch_density, random_.next()), 1.0);
      }
    }
  }

  // Spends the remaining vertices: pixel corners that are kept on straight sides.
  void spend_straight_corners() {
    for (Pass& pass : passes_) {
      for (std::vector<OutlineVertex>& contour : pass.outlines) {
        for (OutlineVertex& vertex : contour) {
          if (excess_ == 0) return;
          if (!vertex.straight) continue;
          vertex.straight = false;
          --excess_;
        }
      }
    }
  }

  void burn_small_fires() {
    for (Pass& pass : passes_) {
      if (left() > 0 && pass.outlines.empty()) {
        const double x = clamp(pass.centre + random_.uniform(-15, 15), west + 0.5, east - 0.5);
        add_pixel(pass, pass.lattice.cell_at({x, random_.uniform(south + 0.5, north - 0.5)}));
      }
    }
    while (left() > 0) {
      const Point place = fire_place(seed_, random_);
      const int views = views_of_small_fire();
      for (int view = 0; view < views && left() > 0; ++view) {
        const Point seen{place.x + 0.4 * bell(random_) / km_per_degree_lon,
                         place.y + 0.4 * bell(random_) / km_per_degree_lat};
        Pass& pass = some_pass(place);
        add_pixel(pass, pass.lattice.cell_at(seen));
      }
    }
  }

  std::vector<FirePass> vectorise() const {
    std::vector<FirePass> result;
    for (const Pass& pass : passes_) {
      FirePass file{pass.name, {}};
      for (const std::vector<OutlineVertex>& contour : pass.outlines) {
        for (const OutlineVertex& vertex : contour) {
          if (!vertex.straight) file.contours.points.push_back(pass.lattice.corner(vertex.corner));
        }
        file.contours.contour_ends.push_back(static_cast<std::uint32_t>(file.contours.points.size()));
        file.contours.polygon_ends.push_back(static_cast<std::uint32_t>(file.contours.contour_ends.size()));
      }
      result.push_back(std::move(file));
    }
    return result;
  }

  const FireMonth& table_;
  const FirePlan& plan_;
  std::uint64_t seed_, month_seed_;
  Random random_;
  int files_;
  int contours_;  // contours to make
  int used_ = 0;  // contours made
  int excess_;    // vertices beyond four per contour that are still to be spent
  std::vector<Pass> passes_;
};

}  // namespace

std::vector<FirePass> generate_fires(const FiresOptions& options) {
  std::vector<FirePass> passes;
  for (std::size_t m = 0; m < std::size(fire_months); ++m) {
    const std::vector<int>& wanted = options.months;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), fire_months[m].month) == wanted.end()) continue;
    for (FirePass& pass : Month(fire_months[m], fire_plans[m], scatter(options.seed), options.scale).run()) {
      passes.push_back(std::move(pass));
    }
  }
  return passes;
}

}  // namespace oblast::app
