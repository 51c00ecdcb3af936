// Arguments, memory and output of the drivers.
#include "driver/report.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace oblast::bench {
namespace {

const std::map<std::string, Operation> operation_names = {{"intersection", Operation::intersection},
                                                          {"union", Operation::unite},
                                                          {"difference", Operation::difference},
                                                          {"symdifference", Operation::symmetric_difference}};

std::uint64_t status_kib(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(field, 0) == 0) return std::strtoull(line.c_str() + field.size() + 1, nullptr, 10);
  }
  return 0;
}

nlohmann::json head(const std::string& peer, const std::string& version, const Arguments& arguments) {
  return {{"peer", peer}, {"version", version}, {"operation", arguments.operation}, {"threads", arguments.threads}};
}

}  // namespace

std::optional<Arguments> parse(int argc, char** argv) {
  Arguments arguments;
  bool fits = argc >= 3 && argc % 2 == 1;
  if (fits) {
    arguments.workload = argv[1];
    arguments.operation = argv[2];
    fits = arguments.operation == "default" || operation_names.count(arguments.operation) != 0;
  }
  for (int i = 3; fits && i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--repeat") {
      arguments.repeat = std::max(1, std::atoi(argv[i + 1]));
    } else if (name == "--threads") {
      arguments.threads = std::max(1, std::atoi(argv[i + 1]));
    } else if (name == "--dump") {
      arguments.dump = argv[i + 1];
    } else {
      fits = false;
    }
  }
  if (fits) return arguments;
  std::cerr << "usage: " << argv[0]
            << " WORKLOAD default|intersection|union|difference|symdifference"
               " [--repeat N] [--threads T] [--dump FILE]\n";
  return std::nullopt;
}

Settings settings_for(const Arguments& arguments, const Workload& workload) {
  Settings settings;
  settings.operation = arguments.operation == "default" ? workload.operation : operation_names.at(arguments.operation);
  settings.fill = workload.fill;
  settings.kind_a = workload.a.kind;
  settings.kind_b = workload.b.kind;
  settings.unary = workload.b.arrays.points.empty();
  settings.coverage = workload.coverage;
  settings.threads = arguments.threads;
  settings.integer = true;
  for (const Operand* operand : {&workload.a, &workload.b}) {
    for (const Point& p : operand->arrays.points) {
      settings.integer = settings.integer && p.x == std::nearbyint(p.x) && p.y == std::nearbyint(p.y);
      settings.largest = std::max({settings.largest, std::abs(p.x), std::abs(p.y)});
    }
  }
  return settings;
}

Memory::Memory() {
  malloc_trim(0);  // memory that an earlier run freed does not count as input
  std::ofstream("/proc/self/clear_refs") << "5";
  input_kib_ = status_kib("VmRSS:");
}

std::uint64_t Memory::peak_kib() const { return status_kib("VmHWM:"); }

void print_run(const std::string& peer, const std::string& version, const Arguments& arguments, double seconds,
               const Memory& memory, const Operand& result) {
  nlohmann::json line = head(peer, version, arguments);
  line["seconds"] = seconds;
  line["peak_kib"] = memory.peak_kib();
  line["input_kib"] = memory.input_kib();
  line["polygons"] = result.arrays.polygon_ends.size();
  line["contours"] = result.arrays.contour_ends.size();
  line["vertices"] = result.arrays.points.size();
  double area = 0;
  for (std::size_t i = 0; i < result.pair_ends.size(); ++i) area += region_area(result.pair(i));
  line["area"] = area;
  std::cout << line.dump() << std::endl;
}

void print_failure(const std::string& peer, const std::string& version, const Arguments& arguments,
                   const std::string& kind, const std::string& message) {
  nlohmann::json line = head(peer, version, arguments);
  line[kind] = message;
  std::cout << line.dump() << std::endl;
}

void append(Operand& target, const Operand& part) {
  const Operand::End base = target.pair_ends.empty() ? Operand::End{} : target.pair_ends.back();
  RegionSet& arrays = target.arrays;
  arrays.points.insert(arrays.points.end(), part.arrays.points.begin(), part.arrays.points.end());
  arrays.contour_ends.insert(arrays.contour_ends.end(), part.arrays.contour_ends.begin(),
                             part.arrays.contour_ends.end());
  arrays.polygon_ends.insert(arrays.polygon_ends.end(), part.arrays.polygon_ends.begin(),
                             part.arrays.polygon_ends.end());
  for (const Operand::End& end : part.pair_ends) {
    target.pair_ends.push_back({base.point + end.point, base.contour + end.contour, base.polygon + end.polygon});
  }
}

void write_result(const std::string& path, Operand result) {
  Workload file;
  file.b.pair_ends.resize(result.pair_ends.size());
  file.a = std::move(result);
  write_workload(path, file);
}

}  // namespace oblast::bench
