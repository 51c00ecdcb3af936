// The inputs whose results have golden digests, by family. Each family is one file of digests.
//
// Inputs are the same on every machine: generators use + - * / and sqrt only (and nextafter, ldexp, floor, which are
// exact), numbers are read by std::from_chars, which rounds correctly. Each input has a digest of its own, so that one
// that does differ is not taken for a result that differs.
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
  bool side_by_side;  ///< inputs are small: each on one thread, many at a time
  std::vector<Input> inputs;
};

/// A thousand seeds of each hostile generator: the four operations, options drawn from the seed.
Family hostile();
/// Hull, layers and triangulation of hostile cases.
Family other_functions();
/// Hostile cases of thousands of edges, and hostile cases side by side: above the thresholds of the library's own.
Family large();
/// The fires of each month, of all, and a twentieth of them under several rules.
Family fires();
/// Every case of every corpus below `folder`. Nothing where there is no such folder.
Family corpora(const std::filesystem::path& folder);
/// Every GeoJSON file in `folder`, and some pairs of them. Nothing where there is no such folder.
Family layers(const std::filesystem::path& folder);

}  // namespace oblast::golden
