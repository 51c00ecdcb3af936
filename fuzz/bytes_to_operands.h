// How a fuzzer's bytes become two operands.
#pragma once

#include <cstddef>
#include <cstdint>

#include "generators/hostile.h"
#include "generators/trial.h"

namespace oblast::fuzz {

struct Input {
  generators::Operands operands;
  generators::Request request;
};

/// Any bytes give an input: contours on a small integer grid, the same moved by a few ulps, or doubles of
/// any magnitude inside the domain; or, where the bytes begin so, two lines of WKT, as seeds are. At most a few hundred
/// edges, so that one input takes milliseconds.
Input input_from(const std::uint8_t* bytes, std::size_t size);

/// Prints what broke and ends the process, as libFuzzer expects of a finding.
[[noreturn]] void report(const generators::Failure& failure, const Input& input);

}  // namespace oblast::fuzz
