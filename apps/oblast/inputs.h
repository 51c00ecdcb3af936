// What the commands that read layers have in common: their options, and what is said of the reading.
#pragma once

#include <string>
#include <vector>

#include "io/layer.h"
#include "io/read.h"
#include "oblast/cli.h"

namespace oblast::app {

/// How an operand may be given, for the help of commands.
inline constexpr const char* input_help =
    "a vector file, FILE:LAYER, a folder, a .zip file, or `-`: WKT, WKB or GeoJSON on standard input";

/// Options as given on the command line.
struct InputArguments {
  std::string layer;
  std::string assume_crs;  ///< WKT
  std::string target_crs;  ///< WKT
};

/// Adds --layer, --assume-crs and --t_srs.
void add_input_options(CLI::App& command, InputArguments& arguments);

/// For io::read. `output` is the file that the command writes, which is never read from a folder; empty: none.
io::ReadOptions read_options(const InputArguments& arguments, const std::string& output);

/// What was passed over and what looks wrong: one line each. `label` is how messages call the operand ("A", "input").
std::vector<std::string> reading_notes(const std::string& label, const io::Layer& layer);
/// A line with the attributes of the operand, for results that have none of them; none if it has no attributes.
std::vector<std::string> attributes_note(const std::string& label, const std::vector<std::string>& columns);
/// A line if the boxes of two operands have no point in common; it says if they look as if x and y were swapped.
std::vector<std::string> apart_note(const std::string& label_a, const io::Layer& a, const std::string& label_b,
                                    const io::Layer& b);
/// Throws IoError if the operands are in different coordinate systems, or only one is in any.
void require_same_crs(const std::string& label_a, const io::Layer& a, const std::string& label_b, const io::Layer& b);

/// On standard error, with "note: " before each line that does not begin with "warning: ".
void print_notes(const std::vector<std::string>& notes);

void append(std::vector<std::string>& notes, std::vector<std::string> more);

}  // namespace oblast::app
