// What all forms of `oblast check` read: one file, with the options of input that the other commands have.
#pragma once

#include <string>
#include <vector>

#include "io/layer.h"
#include "io/read.h"
#include "oblast/cli.h"
#include "oblast/console.h"
#include "oblast/inputs.h"

namespace oblast::app {

struct CheckInput {
  std::string file;
  InputArguments input;
  std::string where;
};

/// Adds FILE, --where, --layer, --assume-crs and --t_srs.
void add_check_input(CLI::App& command, CheckInput& input);

/// Reads the file as `options` say beside these. Shows the progress, and prints notes on the reading, but for the lines
/// and points that were passed over: those are part of what a check says. Throws IoError.
io::Layer read_to_check(const CheckInput& input, io::ReadOptions options, JobProgress& progress);

/// The features, ascending, whose rings have no roles in their files: records of shapefiles.
std::vector<std::uint32_t> features_without_roles(const io::Layer& layer);

}  // namespace oblast::app
