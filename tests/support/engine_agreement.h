// The three engines on one input: do they give the same bytes, and are the triangulations of it right?
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "generators/hostile.h"

namespace oblast::testing {

/// The call that all engines make.
struct Question {
  Operation operation = Operation::unite;
  Options options;  ///< `engine` is ignored
};

/// In words: "difference, evenodd and polygons, ogc".
std::string to_text(const Question& question);

/// Asks every engine and compares bit by bit; -0.0 is not 0.0 here. Engines that throw must all throw the same code.
/// The first difference, in words.
std::optional<std::string> difference(const generators::Operands& operands, const Question& question);

/// All operations, fill rules (one for both operands) and conventions.
std::span<const Question> all_questions();

/// For inputs that take seconds: all operations and conventions under `polygons`; the other rules in turn with one
/// operation and one convention.
std::span<const Question> some_questions();

/// Verifies two triangulations of the operands by exact arithmetic (check_mesh.h): the public one of their union, and
/// the one of the engine of Skvortsov, which has every noded side as a constraint. The first fault, in words; adds the
/// triangles looked at to `triangles`.
std::optional<std::string> triangulation_fault(const generators::Operands& operands, std::uint64_t& triangles);

}  // namespace oblast::testing
