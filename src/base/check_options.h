// Checks options and enumerators: in every public function a value out of range is Error(bad_option).
#pragma once

#include <oblast/error.h>
#include <oblast/options.h>

#include <string>

namespace oblast::internal {

/// REQUIRES: the enumerators of E are all whole numbers from 0 to `last`.
template <class E>
void check_enumerator(E value, E last, const char* type) {
  const int number = static_cast<int>(value);
  if (number < 0 || number > static_cast<int>(last)) [[unlikely]]
    throw Error(ErrorCode::bad_option, std::string(type) + '(' + std::to_string(number) +
                                           ") is not an enumerator; the values are 0 to " +
                                           std::to_string(static_cast<int>(last)));
}

inline void check_operation(Operation operation) {
  check_enumerator(operation, Operation::symmetric_difference, "Operation");
}

inline void check_options(const CallOptions& options) {
  if (options.threads < 0 || options.threads > CallOptions::most_threads) [[unlikely]]
    throw Error(ErrorCode::bad_option, "threads is " + std::to_string(options.threads) +
                                           "; it must be 0 (all cores), or from 1 to " +
                                           std::to_string(CallOptions::most_threads));
}

inline void check_fill_rule(const FillRule& rule) {
  check_enumerator(rule.kind, FillRule::Kind::negative, "FillRule::Kind");
  if (rule.kind == FillRule::Kind::at_least && rule.depth < 1) [[unlikely]]
    throw Error(ErrorCode::bad_option,
                "FillRule::depth is " + std::to_string(rule.depth) + "; for at_least it must be 1 or more");
}

/// Checks the options of an overlay, without its CallOptions.
inline void check_overlay_options(const Options& options) {
  check_fill_rule(options.fill_a);
  check_fill_rule(options.fill_b);
  check_enumerator(options.engine, Engine::skvortsov, "Engine");
  check_enumerator(options.contours, ContourConvention::leonov_nikitin, "ContourConvention");
  check_enumerator(options.collinear, CollinearVertices::drop, "CollinearVertices");
}

}  // namespace oblast::internal
