// Runs one hostile case: all four operations, with every promise that can be checked quickly.
#include "generators/trial.h"

#include <oblast/check.h>
#include <oblast/domain.h>
#include <oblast/overlay.h>
#include <oblast/workspace.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>

#include "generators/company.h"
#include "generators/far.h"
#include "generators/recomputation.h"
#include "verify/verify.h"

namespace oblast::generators {
namespace {

constexpr std::array operations{Operation::intersection, Operation::unite, Operation::difference,
                                Operation::symmetric_difference};

Options options_of(const Request& request, Statistics* statistics) {
  Options options = options_of(request);
  options.statistics = statistics;
  if (request.patience <= 0) return options;
  using Clock = std::chrono::steady_clock;
  const auto until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(request.patience));
  options.progress = [until](Stage, double) { return Clock::now() < until; };
  return options;
}

// A result is read by polygons, whatever the fill rule of its operands.
Options again(Options options) {
  options.fill_a = options.fill_b = FillRule::polygons();
  options.statistics = nullptr;
  return options;
}

std::optional<Failure> run_operation(const Operands& operands, Operation operation, const Request& request,
                                     Figures& figures, RegionSet& result) {
  Statistics statistics;
  Options options = options_of(request, &statistics);
  const auto broken = [&](Broken kind, const std::string& what) { return Failure{kind, operation, what}; };

  result = overlay(operands.a, operands.b, operation, options);
  figures.rounds = std::max(figures.rounds, statistics.rounds);
  figures.displacement_ulps = std::max(figures.displacement_ulps, statistics.largest_displacement_ulps);
  if (const auto fault = verify::check_result(result, request.contours)) {
    return broken(Broken::unverified, fault->what);
  }
  CheckOptions check_options;
  check_options.contours = request.contours;
  if (const auto fault = check(result, check_options).fault)
    return broken(Broken::unverified, "oblast::check, but not verify/: " + fault->message);
  if (unite(result, again(options)) != result) return broken(Broken::not_idempotent, "unite(result) is not result");

  // With differences: another order, other threads, and memory that earlier calls have kept.
  static thread_local Workspace workspace;
  options.statistics = nullptr;
  options.workspace = &workspace;
  if (request.other_threads) options.threads = 2;
  RegionSet a = shuffled(operands.a, request.fill_a, request.seed);
  RegionSet b = shuffled(operands.b, request.fill_b, request.seed + 1);
  if (operation != Operation::difference) {
    std::swap(options.fill_a, options.fill_b);
    std::swap(a, b);
  }
  if (overlay(a, b, operation, options) != result)
    return broken(Broken::order_dependent, "operands shuffled and, where that changes nothing, exchanged");
  options.fill_a = request.fill_a;
  options.fill_b = request.fill_b;
  if (request.other_engines) {
    for (const Engine engine : {Engine::vatti, Engine::skvortsov}) {
      options.engine = engine;
      if (overlay(operands.a, operands.b, operation, options) != result) {
        return broken(Broken::engines_differ, engine == Engine::vatti ? "vatti" : "skvortsov");
      }
    }
  }
  return std::nullopt;
}

FarSquares squares_of(const Operands& operands, const Request& request) {
  return far_squares(operands, request.seed ^ 0xfa2u);
}

// The chosen operation with others far away, in another order.
std::optional<Failure> run_with_squares(const Operands& operands, const Request& request, const RegionSet& alone) {
  const FarSquares squares = squares_of(operands, request);
  const Options options = options_of(request, nullptr);
  const std::array results{alone, overlay(squares.a, squares.b, request.chosen, options)};
  const Operands both = with_squares(operands, squares, request.seed);
  if (overlay(both.a, both.b, request.chosen, options) == put_in_order(results)) return std::nullopt;
  return Failure{Broken::far, request.chosen,
                 std::to_string(squares.a.polygon_ends.size() + squares.b.polygon_ends.size()) +
                     " squares that meet no box change the result"};
}

// A bound of the area that all edges together can sweep if each moves by a few units in the last place of the largest
// coordinate, or by the smallest magnitude of the domain. An edge is at most about three times as long as the largest
// coordinate.
double area_tolerance(const Operands& operands) {
  double largest = 0;
  for (const RegionSet* soup : {&operands.a, &operands.b}) {
    for (const Point& p : soup->points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  const double edges = static_cast<double>(operands.a.points.size() + operands.b.points.size());
  return 16 * std::max(0x1p-52 * largest, domain_smallest) * largest * (edges + 8);
}

std::optional<Failure> check_areas(const std::array<RegionSet, 4>& results, const Operands& operands) {
  const double intersection = signed_area(results[0]), all = signed_area(results[1]);
  const double only_a = signed_area(results[2]), either = signed_area(results[3]);
  const double tolerance = area_tolerance(operands);
  const auto off = [&](double x) { return !(std::abs(x) <= tolerance); };
  if (off(all - intersection - either)) {
    return Failure{Broken::area, Operation::symmetric_difference, "union != intersection + symmetric difference"};
  }
  if (only_a < -tolerance || only_a > either + tolerance || intersection < -tolerance) {
    return Failure{Broken::area, Operation::difference, "the difference is not a part of the symmetric difference"};
  }
  return std::nullopt;
}

}  // namespace

const char* to_text(Broken broken) {
  switch (broken) {
    case Broken::unverified:
      return "unverified";
    case Broken::not_idempotent:
      return "not idempotent";
    case Broken::order_dependent:
      return "order-dependent";
    case Broken::far:
      return "changed by what lies far away";
    case Broken::crowd:
      return "changed in a crowd";
    case Broken::threw:
      return "exception";
    case Broken::engines_differ:
      return "engines differ";
    case Broken::area:
      return "areas contradict";
    case Broken::wrong:
      return "wrong";
  }
  return "";
}

Operands with_others_far_away(const Operands& operands, const Request& request) {
  return with_squares(operands, squares_of(operands, request), request.seed);
}

std::optional<Failure> run_trial(const Operands& operands, const Request& request, Figures& figures) {
  std::array<RegionSet, 4> results;
  for (std::size_t i = 0; i < operations.size(); ++i) {
    try {
      if (auto failure = run_operation(operands, operations[i], request, figures, results[i])) return failure;
      if (operations[i] != request.chosen) continue;
      if (request.far) {
        if (auto failure = run_with_squares(operands, request, results[i])) return failure;
      }
      if (request.against || request.recompute) {
        const std::size_t most = request.against ? vertices_recomputed_at_most : 60;
        if (auto what = recompute_result(operands, request, operations[i], results[i], most))
          return Failure{Broken::wrong, operations[i], *what};
      }
      if (request.recompute) {
        if (auto what = recompute_arrangement(operands, request)) return Failure{Broken::wrong, operations[i], *what};
      }
    } catch (const std::exception& e) {
      return Failure{Broken::threw, operations[i], e.what()};
    }
  }
  return check_areas(results, operands);
}

}  // namespace oblast::generators
