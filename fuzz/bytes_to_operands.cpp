// How a fuzzer's bytes become two operands.
#include "bytes_to_operands.h"

#include <fuzzer/FuzzedDataProvider.h>
#include <oblast/domain.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "generators/wkt.h"

namespace oblast::fuzz {
namespace {

constexpr std::size_t most_vertices = 300;
// Edges of doubles of any magnitude nearly all cross, and every predicate on them goes through to exact arithmetic.
constexpr std::size_t most_wild_vertices = 60;

enum class Coordinates { grid, grid_by_ulps, any, kMaxValue = any };

double coordinate(FuzzedDataProvider& bytes, Coordinates coordinates) {
  switch (coordinates) {
    case Coordinates::grid:
      return bytes.ConsumeIntegralInRange<int>(-8, 8);
    case Coordinates::grid_by_ulps: {
      double value = bytes.ConsumeIntegralInRange<int>(1, 16);
      for (int ulps = bytes.ConsumeIntegralInRange<int>(-3, 3); ulps != 0; ulps += ulps < 0 ? 1 : -1) {
        value = std::nextafter(value, ulps < 0 ? 0.0 : 32.0);
      }
      return value;
    }
    case Coordinates::any:
      break;
  }
  const double value = std::bit_cast<double>(bytes.ConsumeIntegral<std::uint64_t>());
  return in_domain(value) ? value : 0;
}

RegionSet operand_from(FuzzedDataProvider& bytes, Coordinates coordinates) {
  const std::size_t most = coordinates == Coordinates::any ? most_wild_vertices : most_vertices;
  RegionSet regions;
  const int polygons = bytes.ConsumeIntegralInRange<int>(0, 6);
  for (int p = 0; p < polygons; ++p) {
    const int contours = bytes.ConsumeIntegralInRange<int>(1, 3);
    for (int c = 0; c < contours; ++c) {
      const int vertices = bytes.ConsumeIntegralInRange<int>(0, 24);
      for (int v = 0; v < vertices && regions.points.size() < most; ++v) {
        const double x = coordinate(bytes, coordinates);
        regions.points.push_back({x, coordinate(bytes, coordinates)});
      }
      regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
    }
    regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
  }
  return regions;
}

// Two lines of WKT: A and B. What cannot be read, or is too large, is an empty operand.
RegionSet operand_from(const std::string& line) {
  RegionSet regions;
  try {
    regions = generators::soup_from_wkt(line);
  } catch (const std::invalid_argument&) {
    return {};
  }
  if (regions.points.size() > most_vertices) return {};
  for (Point& p : regions.points) p = {in_domain(p.x) ? p.x : 0, in_domain(p.y) ? p.y : 0};
  return regions;
}

generators::Operands operands_from_text(const std::string& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string::npos) return {operand_from(text), {}};
  const std::string second = text.substr(end + 1);
  return {operand_from(text.substr(0, end)), operand_from(second.substr(0, second.find('\n')))};
}

void print(const char* name, const RegionSet& regions) {
  std::fprintf(stderr, "%s:", name);
  for (std::size_t c = 0; c < regions.contour_ends.size(); ++c) {
    std::fprintf(stderr, "\n ");
    for (const Point& p : regions.view().contour(c)) std::fprintf(stderr, " (%a, %a)", p.x, p.y);
  }
  std::fprintf(stderr, "\n");
}

}  // namespace

Input input_from(const std::uint8_t* data, std::size_t size) {
  Input input;
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (text.starts_with("POLYGON") || text.starts_with("MULTIPOLYGON")) {
    input.request = generators::draw_request(size);
    input.operands = operands_from_text(text);
    return input;
  }
  FuzzedDataProvider bytes(data, size);
  input.request = generators::draw_request(bytes.ConsumeIntegral<std::uint16_t>());
  const auto coordinates = bytes.ConsumeEnum<Coordinates>();
  input.operands.a = operand_from(bytes, coordinates);
  input.operands.b = operand_from(bytes, coordinates);
  return input;
}

void report(const generators::Failure& failure, const Input& input) {
  std::fprintf(stderr, "%s, operation %d: %s\n%s\n", generators::to_text(failure.broken),
               static_cast<int>(failure.operation), failure.what.c_str(), generators::to_text(input.request).c_str());
  print("A", input.operands.a);
  print("B", input.operands.b);
  std::abort();
}

}  // namespace oblast::fuzz
