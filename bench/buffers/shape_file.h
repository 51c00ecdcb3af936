// The file of shapes that all buffer drivers read, and the one of rings that they write.
//
//   u64   points of regions, contours, polygons, points of lines, lines, single points
//   f64   x0 y0 x1 y1 ... of all three, in this order
//   u64   contour ends, polygon ends, line ends
//
// Numbers are little-endian. Contours do not repeat their first point; the first one of a polygon is the outer one. A
// driver writes the result of its last run in the same form: polygons, no lines, no points.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace buffers {

struct Xy {
  double x, y;
};

struct Shapes {
  std::vector<Xy> region_points, line_points, points;
  std::vector<std::uint64_t> contour_ends, polygon_ends, line_ends;

  void add_ring(const std::vector<Xy>& ring) {
    region_points.insert(region_points.end(), ring.begin(), ring.end());
    contour_ends.push_back(region_points.size());
  }
  void end_polygon() { polygon_ends.push_back(contour_ends.size()); }
};

template <class T>
void transfer(std::istream& in, std::vector<T>& values) {
  in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}
template <class T>
void transfer(std::ostream& out, const std::vector<T>& values) {
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

inline Shapes read_shapes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::vector<std::uint64_t> counts(6);
  transfer(in, counts);
  if (!in) throw std::runtime_error(path + ": no file of shapes");
  Shapes shapes;
  shapes.region_points.resize(counts[0]);
  shapes.contour_ends.resize(counts[1]);
  shapes.polygon_ends.resize(counts[2]);
  shapes.line_points.resize(counts[3]);
  shapes.line_ends.resize(counts[4]);
  shapes.points.resize(counts[5]);
  for (auto* points : {&shapes.region_points, &shapes.line_points, &shapes.points}) transfer(in, *points);
  for (auto* ends : {&shapes.contour_ends, &shapes.polygon_ends, &shapes.line_ends}) transfer(in, *ends);
  if (!in) throw std::runtime_error(path + ": ends too early");
  return shapes;
}

inline void write_shapes(const std::string& path, const Shapes& shapes) {
  std::ofstream out(path, std::ios::binary);
  const std::vector<std::uint64_t> counts{shapes.region_points.size(), shapes.contour_ends.size(),
                                          shapes.polygon_ends.size(),  shapes.line_points.size(),
                                          shapes.line_ends.size(),     shapes.points.size()};
  transfer(out, counts);
  for (const auto* points : {&shapes.region_points, &shapes.line_points, &shapes.points}) transfer(out, *points);
  for (const auto* ends : {&shapes.contour_ends, &shapes.polygon_ends, &shapes.line_ends}) transfer(out, *ends);
  if (!out) throw std::runtime_error(path + ": cannot be written");
}

/// SHAPES DISTANCE SEGMENTS RESULT ROUNDS [THREADS]
struct Arguments {
  Shapes shapes;
  double distance;
  int segments;  ///< chords of a whole circle; their middles are distance * (1 - cos(pi / segments)) inside of it
  std::string result;
  int rounds;
  int threads;
};

/// The peak of this process's memory in MB.
inline double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::atof(line.c_str() + 6) / 1024;
  return 0;
}

/// Prepares once, runs `rounds` times, prints the seconds of the quickest run and the peak in MB, and writes the
/// result. make(arguments) converts the shapes (not timed) and returns a function that gives the zone in the peer's own
/// types; write(zone) returns it as Shapes (not timed).
template <class Make, class Write>
int drive(int argc, char** argv, const Make& make, const Write& write) {
  try {
    if (argc < 6) throw std::runtime_error("usage: SHAPES DISTANCE SEGMENTS RESULT ROUNDS [THREADS]");
    const Arguments arguments{read_shapes(argv[1]), std::atof(argv[2]),
                              std::atoi(argv[3]),   argv[4],
                              std::atoi(argv[5]),   argc > 6 ? std::atoi(argv[6]) : 1};
    const auto run = make(arguments);
    double best = 1e300, megabytes = 0;
    for (int round = 0; round < arguments.rounds; ++round) {
      const auto begin = std::chrono::steady_clock::now();
      const auto zone = run();
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
      if (seconds.count() < best) best = seconds.count();
      megabytes = peak_megabytes();
      if (round + 1 == arguments.rounds || best > 5) {
        write_shapes(arguments.result, write(zone));
        break;
      }
    }
    std::printf("%.6f %.1f\n", best, megabytes);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}

}  // namespace buffers
