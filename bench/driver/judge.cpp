// oblast_judge RESULT: is what a driver wrote a valid region set? Decided by verify/, exactly, for
// every engine alike: contours may not cross or overlap; those that touch themselves at a point are
// valid under the convention `leonov-nikitin`. Prints one JSON object. Of many pairs a sample is judged.
#include <iostream>
#include <nlohmann/json.hpp>

#include "verify/verify.h"
#include "workloads/workload_file.h"

namespace {

using namespace oblast;

constexpr std::size_t sample = 2000;

// The peers have their own conventions for directions and for repeating the first vertex.
RegionSet normalised(const RegionView& regions) {
  RegionSet result;
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      std::span<const Point> contour = regions.contour(c);
      if (contour.size() > 1 && contour.front() == contour.back()) contour = contour.first(contour.size() - 1);
      result.points.insert(result.points.end(), contour.begin(), contour.end());
      result.contour_ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    }
    result.polygon_ends.push_back(static_cast<std::uint32_t>(result.contour_ends.size()));
  }
  bench::orient(result);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: oblast_judge RESULT\n";
    return 2;
  }
  try {
    const bench::Workload file = bench::read_workload(argv[1]);
    std::string verdict = "valid";
    std::string fault;
    const std::size_t step = std::max<std::size_t>(1, file.pairs() / sample);
    for (std::size_t i = 0; i < file.pairs() && verdict != "invalid"; i += step) {
      const RegionSet regions = normalised(file.a.pair(i));
      const auto strict = verify::check_closed(regions, ContourConvention::ogc);
      if (!strict) continue;
      const auto touching = verify::check_closed(regions, ContourConvention::leonov_nikitin);
      verdict = touching ? "invalid" : "touching";
      fault = touching ? touching->what : strict->what;
    }
    std::cout << nlohmann::json{{"verdict", verdict}, {"fault", fault}}.dump() << std::endl;
  } catch (const std::exception& error) {
    std::cerr << "oblast_judge: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
