// What `oblast zones` did, as JSON and as lines.
#pragma once

#include <oblast/zones.h>

#include <nlohmann/json.hpp>
#include <string>

namespace oblast::app {

struct ZonesReport {
  ZoneStatistics statistics;
  std::uint64_t objects = 0;
  std::uint64_t without_zone = 0;
  std::string unit;  ///< of lengths
  std::string crs;   ///< name of the system of the computation

  /// Sets the last two members.
  void describe(const std::string& crs_wkt);
  nlohmann::ordered_json to_json() const;
  std::string to_text() const;
};

}  // namespace oblast::app
