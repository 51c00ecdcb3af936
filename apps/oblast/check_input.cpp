// One file, as it is checked; see check_input.h.
#include "oblast/check_input.h"

#include <CLI/CLI.hpp>

#include "io/formats.h"

namespace oblast::app {

void add_check_input(CLI::App& command, CheckInput& input) {
  command.add_option("FILE", input.file, input_help)->required()->type_name("");
  command
      .add_option("--where", input.where,
                  "check only the features for which this condition on their attributes holds, such as \"level > 3\"")
      ->type_name("CONDITION");
  add_input_options(command, input.input);
}

io::Layer read_to_check(const CheckInput& input, io::ReadOptions options, JobProgress& progress) {
  const auto show = [&](double share) { progress.show(Phase::reading, "reading", share); };
  show(0);
  options.layer = input.input.layer;
  options.assume_crs = input.input.assume_crs;
  options.target_crs = input.input.target_crs;
  options.where = input.where;
  options.progress = show;
  io::Layer layer = io::read({&input.file, 1}, options);
  const io::ReadReport report = layer.report;
  layer.report.lines = layer.report.points = 0;
  const std::vector<std::string> notes = reading_notes("input", layer);
  layer.report = report;
  if (!notes.empty()) progress.clear();
  print_notes(notes);
  return layer;
}

std::vector<std::uint32_t> features_without_roles(const io::Layer& layer) {
  std::vector<std::uint32_t> features;
  for (std::uint32_t f = 0; f < layer.features.size(); ++f)
    if (io::lower_extension(layer.files[layer.features[f].file]) == ".shp") features.push_back(f);
  return features;
}

}  // namespace oblast::app
