// oblast_judge RESULT: checks whether the output of a driver is a valid region set. The check is the same for every
// engine, and is not timed. Prints one JSON object with the verdict, and the reason why no stricter one applies. From
// strict to lax:
//
//   valid          closed as oblast promises (G2, verify/, exact): edges meet only at common end points
//   touching       the same, with contours that touch themselves at a vertex (convention leonov-nikitin)
//   ogc valid      a MultiPolygon that GEOS considers valid: a vertex may also lie inside an edge
//   self-touching  the same, with rings that touch themselves
//   invalid        none of these
//
// Of many pairs, a sample is judged. The verdict is the worst one.
#include <iostream>
#include <nlohmann/json.hpp>

#ifdef OBLAST_BENCH_WITH_GEOS
#include "driver/ogc_valid.h"
#endif
#include "verify/verify.h"
#include "workloads/workload_file.h"

namespace {

using namespace oblast;

constexpr std::size_t sample = 2000;

// Peers have different conventions for directions and for repeating the first vertex.
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

enum Verdict { valid, touching, ogc_valid, self_touching, invalid };
constexpr const char* verdict_names[] = {"valid", "touching", "ogc valid", "self-touching", "invalid"};

struct Judgement {
  Verdict verdict = valid;
  std::string fault;
};

Judgement judge(const RegionSet& regions) {
  const auto strict = verify::check_closed(regions, ContourConvention::ogc);
  if (!strict) return {};
  const auto lax = verify::check_closed(regions, ContourConvention::leonov_nikitin);
  if (!lax) return {touching, strict->what};
#ifdef OBLAST_BENCH_WITH_GEOS
  if (bench::ogc_fault(regions, bench::SelfTouching::refuse).empty()) return {ogc_valid, strict->what};
  const std::string reason = bench::ogc_fault(regions, bench::SelfTouching::admit);
  if (reason.empty()) return {self_touching, strict->what};
  return {invalid, reason + "; " + strict->what};
#else
  return {invalid, strict->what};
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: oblast_judge RESULT\n";
    return 2;
  }
  try {
    const bench::Workload file = bench::read_workload(argv[1]);
    Judgement worst;
    const std::size_t step = std::max<std::size_t>(1, file.pairs() / sample);
    for (std::size_t i = 0; i < file.pairs(); i += step) {
      const Judgement judgement = judge(normalised(file.a.pair(i)));
      if (judgement.verdict > worst.verdict) worst = judgement;
    }
    std::cout << nlohmann::json{{"verdict", verdict_names[worst.verdict]}, {"fault", worst.fault}}.dump() << std::endl;
  } catch (const std::exception& error) {
    std::cerr << "oblast_judge: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
