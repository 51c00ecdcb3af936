// Converts words to values and values to words.
#include "oblast/names.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

namespace oblast::app {

namespace {

template <class Value>
struct Word {
  const char* word;
  Value value;
};

constexpr Word<Operation> operations[] = {{"intersection", Operation::intersection},
                                          {"union", Operation::unite},
                                          {"difference", Operation::difference},
                                          {"symdifference", Operation::symmetric_difference}};
constexpr Word<FeatureOperation> feature_operations[] = {{"intersection", FeatureOperation::intersection},
                                                         {"union", FeatureOperation::unite},
                                                         {"difference", FeatureOperation::difference},
                                                         {"symdifference", FeatureOperation::symmetric_difference},
                                                         {"identity", FeatureOperation::identity}};
constexpr Word<Engine> engines[] = {
    {"leonov-nikitin", Engine::leonov_nikitin}, {"vatti", Engine::vatti}, {"skvortsov", Engine::skvortsov}};
constexpr Word<FillRule::Kind> fills[] = {{"polygons", FillRule::Kind::polygons},
                                          {"evenodd", FillRule::Kind::even_odd},
                                          {"nonzero", FillRule::Kind::nonzero},
                                          {"positive", FillRule::Kind::positive},
                                          {"negative", FillRule::Kind::negative}};
constexpr Word<ContourConvention> conventions[] = {{"ogc", ContourConvention::ogc},
                                                   {"leonov-nikitin", ContourConvention::leonov_nikitin}};
constexpr const char* stages[stage_count] = {"collect", "node", "label", "select", "link", "assemble"};
constexpr const char* plain_stages[stage_count] = {"preparing polygons",          "finding crossings",
                                                   "telling inside from outside", "choosing the borders",
                                                   "joining the borders",         "building polygons"};

template <class Value, std::size_t count>
Value parse(const std::string& word, const Word<Value> (&words)[count], const char* what,
            const std::string& more = {}) {
  std::string known;
  for (const Word<Value>& w : words) {
    if (word == w.word) return w.value;
    known += (known.empty() ? "" : ", ") + std::string(w.word);
  }
  throw CLI::ValidationError(fmt::format("'{}' is not a valid {}; choose from {}{}", word, what, known, more));
}

template <class Value, std::size_t count>
std::string word_of(Value value, const Word<Value> (&words)[count]) {
  for (const Word<Value>& w : words) {
    if (value == w.value) return w.word;
  }
  return {};
}

}  // namespace

Operation parse_operation(const std::string& word) { return parse(word, operations, "operation"); }
FeatureOperation parse_feature_operation(const std::string& word) {
  return parse(word, feature_operations, "operation");
}
Engine parse_engine(const std::string& word) { return parse(word, engines, "engine"); }
ContourConvention parse_contours(const std::string& word) { return parse(word, conventions, "contour convention"); }

FillRule parse_fill(const std::string& word) {
  const std::string prefix = "atleast:";
  if (word.compare(0, prefix.size(), prefix) == 0) {
    std::int32_t depth = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data() + prefix.size(), end, depth);
    if (error == std::errc() && stop == end && depth >= 1) return FillRule::at_least(depth);
    throw CLI::ValidationError(
        fmt::format("'{}': after atleast: there must be a whole number of 1 or more, as in atleast:3", word));
  }
  return {parse(word, fills, "fill rule", ", atleast:K"), 1};
}

std::string name(Operation operation) { return word_of(operation, operations); }
std::string name(FeatureOperation operation) { return word_of(operation, feature_operations); }
std::string name(Engine engine) { return word_of(engine, engines); }
std::string name(ContourConvention convention) { return word_of(convention, conventions); }
std::string name(Stage stage) { return stages[static_cast<int>(stage)]; }
std::string plain_name(Stage stage) { return plain_stages[static_cast<int>(stage)]; }
std::string name(const FillRule& rule) {
  if (rule.kind == FillRule::Kind::at_least) return fmt::format("atleast:{}", rule.depth);
  return word_of(rule.kind, fills);
}

std::optional<Operation> merged_operation(FeatureOperation operation) {
  if (operation == FeatureOperation::identity) return std::nullopt;
  return parse_operation(name(operation));
}

}  // namespace oblast::app
