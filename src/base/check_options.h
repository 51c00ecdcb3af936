// Options and enumerators out of range are Error(bad_option), in every public function.
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
    throw Error(ErrorCode::bad_option,
                std::string(type) + '(' + std::to_string(number) + ") is none of its enumerators");
}

inline void check_operation(Operation operation) {
  check_enumerator(operation, Operation::symmetric_difference, "Operation");
}

inline void check_options(const CallOptions& options) {
  if (options.threads < 0 || options.threads > CallOptions::most_threads) [[unlikely]]
    throw Error(ErrorCode::bad_option, "threads is " + std::to_string(options.threads) +
                                           "; it must be 0 (all cores) to " +
                                           std::to_string(CallOptions::most_threads));
}

inline void check_fill_rule(const FillRule& rule) {
  check_enumerator(rule.kind, FillRule::Kind::negative, "FillRule::Kind");
  if (rule.kind == FillRule::Kind::at_least && rule.depth < 1) [[unlikely]]
    throw Error(ErrorCode::bad_option, "at_least needs a depth of 1 or more; it is " + std::to_string(rule.depth));
}

/// Those of an overlay, CallOptions left out.
inline void check_overlay_options(const Options& options) {
  check_fill_rule(options.fill_a);
  check_fill_rule(options.fill_b);
  check_enumerator(options.engine, Engine::skvortsov, "Engine");
  check_enumerator(options.contours, ContourConvention::leonov_nikitin, "ContourConvention");
  check_enumerator(options.collinear, CollinearVertices::drop, "CollinearVertices");
}

}  // namespace oblast::internal
