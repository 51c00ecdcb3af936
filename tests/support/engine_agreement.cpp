#include "support/engine_agreement.h"

#include <oblast/error.h>
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <algorithm>
#include <array>
#include <vector>

#include "engines/skvortsov/marked_mesh.h"
#include "graph/chain_graph.h"
#include "support/check_mesh.h"
#include "support/noded.h"
#include "support/same_bits.h"

namespace oblast::testing {
using namespace internal;
namespace {

using generators::Operands;

constexpr std::array operations{Operation::intersection, Operation::unite, Operation::difference,
                                Operation::symmetric_difference};
constexpr std::array rules{FillRule::polygons(), FillRule::at_least(2), FillRule::even_odd(),
                           FillRule::nonzero(),  FillRule::positive(),  FillRule::negative()};
constexpr std::array conventions{ContourConvention::ogc, ContourConvention::leonov_nikitin};

constexpr const char* operation_names[] = {"intersection", "union", "difference", "symdifference"};
constexpr const char* engine_names[] = {"leonov-nikitin", "vatti", "skvortsov"};

std::string to_text(const FillRule& rule) {
  static constexpr const char* names[] = {"polygons", "atleast:", "evenodd", "nonzero", "positive", "negative"};
  const std::string name = names[static_cast<int>(rule.kind)];
  return rule.kind == FillRule::Kind::at_least ? name + std::to_string(rule.depth) : name;
}

std::vector<Question> make_questions(bool all) {
  std::vector<Question> questions;
  for (std::size_t r = 0; r < rules.size(); ++r) {
    for (std::size_t o = 0; o < operations.size(); ++o) {
      if (!all && r > 0 && o != r % operations.size()) continue;
      for (std::size_t c = 0; c < conventions.size(); ++c) {
        if (!all && r > 0 && c != r % conventions.size()) continue;
        Question question{operations[o], {}};
        question.options.fill_a = question.options.fill_b = rules[r];
        question.options.contours = conventions[c];
        questions.push_back(question);
      }
    }
  }
  return questions;
}

/// What an engine gives: bytes, or the error it throws.
struct Answer {
  RegionSet regions;
  std::optional<ErrorCode> error;
};

bool same_bytes(const Answer& p, const Answer& q) { return p.error == q.error && same_bits(p.regions, q.regions); }

Answer ask(const Operands& operands, const Question& question, Engine engine) {
  Options options = question.options;
  options.engine = engine;
  Statistics statistics;
  options.statistics = &statistics;  // else convex operands would go past the engines (window/fast_path.h)
  try {
    return {overlay(operands.a, operands.b, question.operation, options), {}};
  } catch (const Error& error) {
    return {{}, error.code()};
  }
}

ChainGraph arrangement(const Operands& operands) {
  const RegionView b = operands.b;
  return graph_of(operands.a, &b, Options{});
}

/// Every edge of every live chain, by vertices of the mesh.
std::vector<triangulation::Constraint> sides(const ChainGraph& graph, const triangulation::Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.points.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  const auto before = [](const Point& p, const Point& q) { return lexicographically_less(p, q); };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t v, std::uint32_t w) { return before(mesh.points[v], mesh.points[w]); });
  const auto vertex = [&](const Point& p) {
    return *std::lower_bound(order.begin(), order.end(), p,
                             [&](std::uint32_t v, const Point& q) { return before(mesh.points[v], q); });
  };
  std::vector<triangulation::Constraint> result;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    if (!graph.is_live(c)) continue;
    for (std::uint32_t v = graph.chains[c].first; v < graph.chains[c].last; ++v)
      result.push_back({vertex(graph.point(v)), vertex(graph.point(v + 1))});
  }
  return result;
}

void append(RegionSet& to, const RegionSet& from) {
  const auto points = static_cast<std::uint32_t>(to.points.size());
  const auto contours = static_cast<std::uint32_t>(to.contour_ends.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (const std::uint32_t end : from.contour_ends) to.contour_ends.push_back(points + end);
  for (const std::uint32_t end : from.polygon_ends) to.polygon_ends.push_back(contours + end);
}

}  // namespace

std::string to_text(const Question& question) {
  const Options& options = question.options;
  return std::string(operation_names[static_cast<int>(question.operation)]) + ", " + to_text(options.fill_a) + " and " +
         to_text(options.fill_b) +
         (options.contours == ContourConvention::ogc ? ", contours ogc" : ", contours leonov-nikitin");
}

std::optional<std::string> difference(const Operands& operands, const Question& question) {
  const Answer first = ask(operands, question, Engine::leonov_nikitin);
  for (const Engine engine : {Engine::vatti, Engine::skvortsov})
    if (!same_bytes(ask(operands, question, engine), first))
      return std::string(engine_names[static_cast<int>(engine)]) + " gives other bytes: " + to_text(question);
  return std::nullopt;
}

std::span<const Question> all_questions() {
  static const std::vector<Question> questions = make_questions(true);
  return questions;
}

std::span<const Question> some_questions() {
  static const std::vector<Question> questions = make_questions(false);
  return questions;
}

std::optional<std::string> triangulation_fault(const Operands& operands, std::uint64_t& triangles) {
  RegionSet all = operands.a;
  append(all, operands.b);
  TriangulateOptions options;
  options.extent = TriangleExtent::convex_hull;
  const Triangulation united = triangulate(all, options);
  triangles += united.triangles.size();
  if (const auto fault = check_triangulation(united)) return "of the union: " + *fault;

  const ChainGraph graph = arrangement(operands);
  const skvortsov::MarkedMesh marked = skvortsov::mark_mesh(graph);
  triangles += marked.mesh.triangles.size();
  if (const auto fault = check_mesh(marked.mesh, sides(graph, marked.mesh))) return "of all sides: " + *fault;
  return std::nullopt;
}

}  // namespace oblast::testing
