// The methods of `classic` and `compare`: their words, and their entries in Skvortsov's Table 1.
#pragma once

#include <oblast/classics.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/layer.h"
#include "io/read.h"

namespace oblast::app {

/// A row of the comparison: an engine of the library or a classic.
struct Method {
  const char* word;
  const char* title;
  std::optional<ClassicMethod> classic;  ///< nothing: an engine
  Engine engine;
  const char* operands;  ///< Table 1: type of polygons admitted
  const char* contours;  ///< Table 1: several contours, "+" or "-"
  const char* robust;    ///< Table 1: "+" or "-"
  const char* worst;     ///< cost in the worst case
  const char* average;   ///< average cost; "" if none is stated
  bool in_table;         ///< false: not in Table 1; the entries are ours
};

std::span<const Method> methods();

/// Throws CLI::ValidationError, whose message lists the valid words.
ClassicMethod parse_classic(const std::string& word);

/// Two operands that were read. Their coordinate systems agree.
struct OperandPair {
  io::Layer a, b;
  const std::string& crs_wkt() const { return a.crs_wkt; }
};

/// Throws IoError.
OperandPair read_pair(const std::string& a, const std::string& b, const io::ReadOptions& options);
/// What was passed over, and what looks wrong.
std::vector<std::string> notes_of(const OperandPair& pair);

/// The message of an error, with its place in the files.
std::string describe(const OperandPair& pair, const Error& error);

}  // namespace oblast::app
