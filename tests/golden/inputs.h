// The inputs whose results have golden digests, by family. Each family is one file of digests.
//
// Inputs are the same on every machine: generators use only + - * / and sqrt (and nextafter, ldexp, floor, which are
// exact), and std::from_chars reads numbers with correct rounding. Each input has a digest, too. So a different input
// is not mistaken for a different result.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "golden/digest_file.h"

namespace oblast::golden {

struct Input {
  std::string name;
  std::function<InputAndResult()> compute;
};

struct Family {
  const char* name;
  const char* what;   ///< one sentence
  bool side_by_side;  ///< inputs are small: each on one thread, many in parallel
  std::vector<Input> inputs;
};

/// A thousand seeds of each hostile generator: the four operations, options drawn from the seed.
Family hostile();
/// Hull, layers and triangulation of hostile cases.
Family other_functions();
/// Hostile cases as layers: identity, union, dissolve, depth, partition.
Family rows();
/// Buffer zones of hostile cases as polygons, lines and points, distances and options by the seed.
Family buffers();
/// Proximity zones of hostile cases as polygons, lines and points, tolerances by the seed.
Family zones();
/// Hostile cases with thousands of edges, and hostile cases in crowds: above the thresholds of the library.
Family large();
/// The fires of each month, of all months, and a twentieth of them with several fill rules.
Family fires();
/// Every case of every corpus in `folder`. Nothing if there is no such folder.
Family corpora(const std::filesystem::path& folder);
/// Every GeoJSON file in `folder`, and some pairs of them. Nothing if there is no such folder.
Family layers(const std::filesystem::path& folder);

}  // namespace oblast::golden
