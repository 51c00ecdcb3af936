// Reading and running one case of a corpus.
#include "oblast/corpus_case.h"

#include <fmt/format.h>
#include <oblast/oblast.h>

#include <chrono>
#include <cmath>

#include "io/read.h"
#include "io/write.h"
#include "oblast/names.h"
#include "verify/verify.h"

namespace oblast::app {

namespace {

using Json = nlohmann::json;

// "GEOMETRYCOLLECTION (X (...), Y (...))" as "X (...)" and "Y (...)".
std::vector<std::string> members(const std::string& collection) {
  std::vector<std::string> result;
  std::string member;
  int depth = 0;
  for (const char c : collection) {
    if (c == ')') --depth;
    if (depth == 1 && c == ',') {
      result.push_back(std::move(member));
      member.clear();
    } else if (depth >= 1) {
      member += c;
    }
    if (c == '(') ++depth;
  }
  if (!member.empty()) result.push_back(std::move(member));
  return result;
}

Operation operation_of(const std::string& word) {
  return word == "xor" ? Operation::symmetric_difference : parse_operation(word);
}

// The tolerance that the note states: "area_tol_frac=0.01" or "source tolerance 0.1%".
double stated_tolerance(const std::string& note) {
  double tolerance = 1e-9;
  if (const auto at = note.find("area_tol_frac="); at != std::string::npos) {
    tolerance = std::max(tolerance, std::strtod(note.c_str() + at + 14, nullptr));
  }
  if (const auto at = note.find("source tolerance "); at != std::string::npos) {
    tolerance = std::max(tolerance, std::strtod(note.c_str() + at + 17, nullptr) / 100);
  }
  return tolerance;
}

void set_expected_area(CorpusCase& corpus_case, const Json& json) {
  const Json ref = json.value("ref", Json::object()), expect = json.value("expect", Json::object());
  corpus_case.relative_tolerance = 1e-9;
  for (const char* key : {"exact_area", "area"}) {
    if (!ref.is_object() || !ref.contains(key) || ref[key].is_null()) continue;
    corpus_case.area = ref[key].get<double>();
    corpus_case.area_from = std::string("ref.") + key;
    return;
  }
  if (!expect.is_object() || !expect.contains("area") || expect["area"].is_null()) {
    throw std::runtime_error("the case has no area to compare with (ref.exact_area, ref.area or expect.area)");
  }
  corpus_case.area = expect["area"].get<double>();
  corpus_case.area_from = "expect.area";
  corpus_case.relative_tolerance = stated_tolerance(json.value("note", std::string()));
}

// The area of the triangles between the first point and each edge, in long double. A sum of many contours far from the
// origin must stay more exact than 1e-9.
long double contour_area(std::span<const Point> contour) {
  long double sum = 0;
  for (std::size_t k = 1; k + 1 < contour.size(); ++k) {
    const long double ax = static_cast<long double>(contour[k].x) - contour[0].x;
    const long double ay = static_cast<long double>(contour[k].y) - contour[0].y;
    const long double bx = static_cast<long double>(contour[k + 1].x) - contour[0].x;
    const long double by = static_cast<long double>(contour[k + 1].y) - contour[0].y;
    sum += ax * by - bx * ay;
  }
  return sum / 2;
}

long double result_area(const RegionView& regions) {
  long double sum = 0;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) sum += contour_area(regions.contour(c));
  return sum;
}

long double input_area(const std::vector<io::Layer>& layers) {
  long double sum = 0;
  for (const io::Layer& layer : layers) {
    const RegionView view = layer.regions;
    for (std::size_t c = 0; c < view.contour_count(); ++c) sum += std::fabs(contour_area(view.contour(c)));
  }
  return sum;
}

// A time limit for each case, so that a case that never ends does not stop the run.
constexpr std::chrono::seconds patience{120};

RegionSet compute(const CorpusCase& corpus_case, const std::vector<io::Layer>& layers, Engine engine) {
  Options options;
  const auto until = std::chrono::steady_clock::now() + patience;
  options.progress = [until](Stage, double) { return std::chrono::steady_clock::now() < until; };
  options.engine = engine;
  options.threads = 1;  // the cases themselves run side by side
  options.fill_a = options.fill_b = corpus_case.fill;
  if (layers.size() == 1) return unite(layers[0].regions, options);
  RegionSet result = overlay(layers[0].regions, layers[1].regions, corpus_case.operation, options);
  options.fill_a = FillRule::polygons();
  for (std::size_t k = 2; k < layers.size(); ++k)
    result = overlay(result, layers[k].regions, corpus_case.operation, options);
  return result;
}

std::optional<std::string> wrong_result(const RegionSet& result) {
  if (const auto fault = verify::check_result(result)) return "does not verify: " + fault->what;
  Options options;
  options.threads = 1;
  if (unite(result, options) != result) return "uniting the result again changes it";
  return std::nullopt;
}

}  // namespace

CorpusCase parse_case(const std::string& line) {
  const Json json = Json::parse(line);
  CorpusCase result;
  result.id = json.at("id").get<std::string>();
  result.source = json.value("source", std::string());
  result.operation = operation_of(json.at("op").get<std::string>());
  const std::string a = json.at("a").get<std::string>();
  if (!json.at("b").is_null()) {
    result.operands = {a, json.at("b").get<std::string>()};
  } else if (a.rfind("GEOMETRYCOLLECTION", 0) == 0) {
    result.operands = members(a);
  } else {
    result.operands = {a};
  }
  if (json.contains("fill") && !json["fill"].is_null()) result.fill = parse_fill(json["fill"].get<std::string>());
  set_expected_area(result, json);
  return result;
}

std::optional<std::string> run_case(const CorpusCase& corpus_case) {
  try {
    std::vector<io::Layer> layers;
    for (const std::string& wkt : corpus_case.operands) layers.push_back(io::read_wkt(wkt, corpus_case.id));
    const RegionSet result = compute(corpus_case, layers, Engine::leonov_nikitin);
    if (const auto wrong = wrong_result(result)) return wrong;
    for (const Engine engine : {Engine::vatti, Engine::skvortsov}) {
      if (compute(corpus_case, layers, engine) != result) return fmt::format("{} gives different bytes", name(engine));
    }
    const auto area = static_cast<double>(result_area(result));
    const double allowed = corpus_case.relative_tolerance * static_cast<double>(input_area(layers));
    if (!(std::fabs(area - corpus_case.area) <= allowed)) {
      return fmt::format("area {:.17g}, but {} is {:.17g}: they differ by {:.3g}, and {:.3g} is allowed", area,
                         corpus_case.area_from, corpus_case.area, std::fabs(area - corpus_case.area), allowed);
    }
    return std::nullopt;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) return fmt::format("not finished within {} s", patience.count());
    return std::string("error: ") + error.what();
  } catch (const std::exception& error) {
    return std::string("error: ") + error.what();
  }
}

}  // namespace oblast::app
