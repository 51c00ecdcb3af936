// Reads and writes workload files, and computes the two measures that every driver needs.
#include "workloads/workload_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace oblast::bench {
namespace {

constexpr char magic[8] = {'O', 'B', 'L', 'W', 'O', 'R', 'K', '1'};
constexpr std::uint32_t coverage_flag = 1;

template <class T>
void put(std::ofstream& file, const T* data, std::size_t count) {
  file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(count * sizeof(T)));
}

template <class T>
void get(std::ifstream& file, T* data, std::size_t count) {
  file.read(reinterpret_cast<char*>(data), static_cast<std::streamsize>(count * sizeof(T)));
}

std::size_t padding(const RegionSet& arrays) {
  return (arrays.contour_ends.size() + arrays.polygon_ends.size()) % 2 * sizeof(std::uint32_t);
}

void put_operand(std::ofstream& file, const Operand& operand) {
  const RegionSet& arrays = operand.arrays;
  const std::array<std::uint64_t, 3> counts = {arrays.points.size(), arrays.contour_ends.size(),
                                               arrays.polygon_ends.size()};
  put(file, counts.data(), counts.size());
  put(file, arrays.points.data(), arrays.points.size());
  put(file, arrays.contour_ends.data(), arrays.contour_ends.size());
  put(file, arrays.polygon_ends.data(), arrays.polygon_ends.size());
  put(file, "\0\0\0\0", padding(arrays));
  put(file, operand.pair_ends.data(), operand.pair_ends.size());
}

void get_operand(std::ifstream& file, Operand& operand, std::size_t pairs) {
  RegionSet& arrays = operand.arrays;
  std::array<std::uint64_t, 3> counts = {};
  get(file, counts.data(), counts.size());
  arrays.points.resize(counts[0]);
  arrays.contour_ends.resize(counts[1]);
  arrays.polygon_ends.resize(counts[2]);
  get(file, arrays.points.data(), counts[0]);
  get(file, arrays.contour_ends.data(), counts[1]);
  get(file, arrays.polygon_ends.data(), counts[2]);
  file.ignore(static_cast<std::streamsize>(padding(arrays)));
  operand.pair_ends.resize(pairs);
  get(file, operand.pair_ends.data(), pairs);
}

// Twice the area, relative to the first point, so contours far from the origin lose no digits.
double doubled_area(std::span<const Point> contour) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
    const Point& o = contour[0];
    sum += (contour[i].x - o.x) * (contour[i + 1].y - o.y) - (contour[i + 1].x - o.x) * (contour[i].y - o.y);
  }
  return sum;
}

}  // namespace

void Operand::add(const RegionView& regions) {
  arrays.points.insert(arrays.points.end(), regions.points.begin(), regions.points.end());
  arrays.contour_ends.insert(arrays.contour_ends.end(), regions.contour_ends.begin(), regions.contour_ends.end());
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) arrays.polygon_ends.push_back(regions.polygon_end(p));
  pair_ends.push_back({arrays.points.size(), arrays.contour_ends.size(), arrays.polygon_ends.size()});
}

RegionView Operand::pair(std::size_t index) const {
  const End begin = index == 0 ? End{} : pair_ends[index - 1];
  const End end = pair_ends[index];
  return {std::span(arrays.points).subspan(begin.point, end.point - begin.point),
          std::span(arrays.contour_ends).subspan(begin.contour, end.contour - begin.contour),
          std::span(arrays.polygon_ends).subspan(begin.polygon, end.polygon - begin.polygon)};
}

Workload read_workload(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char found[sizeof(magic)] = {};
  get(file, found, sizeof(magic));
  if (!file || std::memcmp(found, magic, sizeof(magic)) != 0) throw std::runtime_error(path + ": not a workload file");
  std::array<std::uint32_t, 6> head = {};
  get(file, head.data(), head.size());
  Workload workload;
  workload.operation = static_cast<Operation>(head[0]);
  workload.fill = static_cast<FillRule::Kind>(head[1]);
  workload.a.kind = static_cast<OperandKind>(head[2]);
  workload.b.kind = static_cast<OperandKind>(head[3]);
  workload.coverage = (head[4] & coverage_flag) != 0;
  get_operand(file, workload.a, head[5]);
  get_operand(file, workload.b, head[5]);
  if (!file) throw std::runtime_error(path + ": ends too early");
  return workload;
}

void write_workload(const std::string& path, const Workload& workload) {
  std::ofstream file(path, std::ios::binary);
  put(file, magic, sizeof(magic));
  const std::array<std::uint32_t, 6> head = {
      static_cast<std::uint32_t>(workload.operation), static_cast<std::uint32_t>(workload.fill),
      static_cast<std::uint32_t>(workload.a.kind),    static_cast<std::uint32_t>(workload.b.kind),
      workload.coverage ? coverage_flag : 0,          static_cast<std::uint32_t>(workload.pairs())};
  put(file, head.data(), head.size());
  put_operand(file, workload.a);
  put_operand(file, workload.b);
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

void orient(RegionSet& regions) {
  const RegionView view = regions;
  for (std::size_t p = 0; p < view.polygon_count(); ++p) {
    for (std::uint32_t c = view.polygon_begin(p); c < view.polygon_end(p); ++c) {
      const bool outer = c == view.polygon_begin(p);
      if ((doubled_area(view.contour(c)) > 0) != outer) {
        std::reverse(regions.points.begin() + view.contour_begin(c), regions.points.begin() + view.contour_end(c));
      }
    }
  }
}

double region_area(const RegionView& regions) {
  double sum = 0;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) sum += doubled_area(regions.contour(c));
  return std::abs(sum) / 2;
}

}  // namespace oblast::bench
