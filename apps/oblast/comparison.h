// The comparison of methods on one pair of operands: Skvortsov's Table 1 with measured columns.
#pragma once

#include <oblast/region_set.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "oblast/methods.h"

namespace oblast::app {

struct Row {
  const Method* method = nullptr;
  bool admitted = false;
  std::string why_not;
  RegionSet result;
  double seconds = 0;        ///< the shortest time of a few runs
  bool same_bytes = false;   ///< the result equals that of the default engine
  bool handed_over = false;  ///< for a classic: it passed its operands on to `overlay`
};

/// Runs every method. The first row is the default engine.
std::vector<Row> compare_methods(const OperandPair& pair, Operation operation, const CallOptions& call);

std::string to_text(const std::vector<Row>& rows);
nlohmann::ordered_json to_json(const std::vector<Row>& rows);

/// An SVG picture with one panel per method. Throws IoError.
std::string draw(const std::vector<Row>& rows, const OperandPair& pair, Operation operation);

}  // namespace oblast::app
