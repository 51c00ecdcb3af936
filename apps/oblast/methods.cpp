#include "oblast/methods.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "oblast/inputs.h"

namespace oblast::app {

std::span<const Method> methods() {
  static constexpr Engine own = Engine::leonov_nikitin;
  static const Method all[] = {
      {"leonov-nikitin", "Leonov-Nikitin (default)", {}, own, "any", "+", "+", "O((n + k) log n)", "", false},
      {"vatti", "Vatti", {}, Engine::vatti, "any", "+", "+", "O((n + k) log n)", "", false},
      {"skvortsov", "Skvortsov", {}, Engine::skvortsov, "general", "+", "+", "O(n log(n1 + n2))", "O(n)", true},
      {"orourke", "O'Rourke", ClassicMethod::orourke, own, "convex", "-", "-", "O(n)", "", true},
      {"sutherland-hodgman", "Sutherland-Hodgman", ClassicMethod::sutherland_hodgman, own, "one convex, one general",
       "+", "+", "O(n1 n2 log n2)", "", true},
      {"weiler-atherton", "Weiler-Atherton", ClassicMethod::weiler_atherton, own, "simple, contours oriented", "+", "-",
       "O(n log(n1 + n2))", "", true},
      {"margalit-knott", "Margalit-Knott", ClassicMethod::margalit_knott, own, "vertex-complete", "-", "-",
       "O(n^2), in theory O(n log n)", "", true},
  };
  return all;
}

ClassicMethod parse_classic(const std::string& word) {
  std::string known;
  for (const Method& method : methods()) {
    if (!method.classic) continue;
    if (word == method.word) return *method.classic;
    known += (known.empty() ? "" : ", ") + std::string(method.word);
  }
  throw CLI::ValidationError(fmt::format("'{}' is not a classic method; choose from {}", word, known));
}

OperandPair read_pair(const std::string& a, const std::string& b, const io::ReadOptions& options) {
  const std::vector<std::string> a_paths{a}, b_paths{b};
  OperandPair pair{io::read(a_paths, options), io::read(b_paths, options)};
  require_same_crs("A", pair.a, "B", pair.b);
  return pair;
}

std::vector<std::string> notes_of(const OperandPair& pair) {
  std::vector<std::string> notes = reading_notes("A", pair.a);
  append(notes, attributes_note("A", pair.a.columns));
  append(notes, reading_notes("B", pair.b));
  append(notes, attributes_note("B", pair.b.columns));
  append(notes, apart_note("A", pair.a, "B", pair.b));
  return notes;
}

std::string describe(const OperandPair& pair, const Error& error) {
  const Place& place = error.place();
  if (place.operand > 1 || place.contour == Place::npos) return error.what();
  return fmt::format("{}: {}", io::describe(place.operand == 0 ? pair.a : pair.b, place), error.what());
}

}  // namespace oblast::app
