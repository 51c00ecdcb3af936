// The cases of the corpora, as `oblast corpus` reads them. Does not need GDAL.
#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "generators/wkt.h"
#include "golden/inputs.h"
#include "golden/results.h"

namespace oblast::golden {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// "GEOMETRYCOLLECTION (X (...), Y (...))" as "X (...)" and "Y (...)".
std::vector<std::string> members(const std::string& collection) {
  std::vector<std::string> result(1);
  int depth = 0;
  for (const char c : collection) {
    if (c == ')') --depth;
    if (depth == 1 && c == ',') {
      result.emplace_back();
    } else if (depth >= 1) {
      result.back() += c;
    }
    if (c == '(') ++depth;
  }
  return result;
}

FillRule rule_of(const Json& json) {
  const std::string fill = json.contains("fill") && !json["fill"].is_null() ? json["fill"].get<std::string>() : "";
  if (fill.empty()) return FillRule::polygons();
  if (fill == "evenodd") return FillRule::even_odd();
  if (fill == "nonzero") return FillRule::nonzero();
  if (fill == "positive") return FillRule::positive();
  if (fill == "negative") return FillRule::negative();
  throw std::runtime_error("unknown fill rule " + fill);
}

Operation operation_of(const std::string& word) {
  if (word == "union") return Operation::unite;
  if (word == "intersection") return Operation::intersection;
  if (word == "difference") return Operation::difference;
  if (word == "xor") return Operation::symmetric_difference;
  throw std::runtime_error("unknown operation " + word);
}

InputAndResult compute(const std::string& line) {
  const Json json = Json::parse(line);
  const std::string a = json.at("a").get<std::string>();
  Options options;
  options.threads = 1;
  options.fill_a = options.fill_b = rule_of(json);
  if (!json.at("b").is_null()) {
    return four_operations(generators::soup_from_wkt(a), generators::soup_from_wkt(json.at("b").get<std::string>()),
                           options);
  }
  std::vector<RegionSet> operands;
  for (const std::string& wkt : a.starts_with("GEOMETRYCOLLECTION") ? members(a) : std::vector{a})
    operands.push_back(generators::soup_from_wkt(wkt));
  return folded(operands, operation_of(json.at("op").get<std::string>()), options);
}

/// The id, without reading the whole line, most of which is coordinates.
std::string id_of(const std::string& line) {
  static const std::string before = "{\"id\": \"";
  const auto end = line.find('"', before.size());
  if (!line.starts_with(before) || end == std::string::npos)
    throw std::runtime_error("a case must begin with its id: " + line.substr(0, 40));
  return line.substr(before.size(), end - before.size());
}

}  // namespace

Family corpora(const fs::path& folder) {
  Family family{"corpora", "the cases of the corpora: all operations on two operands, else the case's own", true, {}};
  if (!fs::is_directory(folder)) return family;
  for (const fs::directory_entry& source : fs::directory_iterator(folder)) {
    std::ifstream lines(source.path() / "cases.jsonl");
    for (std::string line; std::getline(lines, line);) {
      if (line.empty()) continue;
      std::string id = id_of(line);
      family.inputs.push_back({std::move(id), [shared = std::make_shared<const std::string>(std::move(line))] {
                                 return compute(*shared);
                               }});
      line.clear();
    }
  }
  return family;
}

}  // namespace oblast::golden
