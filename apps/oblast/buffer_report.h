// What `oblast buffer` did, as JSON and as a line.
#pragma once

#include <oblast/buffer.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace oblast::app {

struct BufferReport {
  BufferStatistics statistics;
  double least_distance = 0, most_distance = 0;  ///< in the units of the system of the computation
  std::string unit;                              ///< of these
  std::string crs;                               ///< name of that system

  /// Sets the members after `statistics`.
  void describe(std::span<const double> distances, const std::string& crs_wkt);
  nlohmann::ordered_json to_json() const;
  std::string to_text() const;
};

}  // namespace oblast::app
