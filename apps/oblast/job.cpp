// A job from input files to the summary. Errors that can be found early are reported before the computation.
#include "oblast/job.h"

#include <fmt/format.h>
#include <oblast/oblast.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "io/crs.h"
#include "io/picture_file.h"
#include "io/read.h"
#include "io/write.h"
#include "oblast/call_options.h"
#include "oblast/console.h"
#include "oblast/interrupt.h"
#include "oblast/job_picture.h"
#include "oblast/names.h"
#include "oblast/stopwatch.h"
#include "oblast/summary.h"

namespace oblast::app {

namespace {

std::string label(const Job& job, std::size_t operand) {
  if (job.operands.size() == 1) return "input";
  return operand == 0 ? "A" : "B";
}

std::vector<io::Layer> read_operands(const Job& job, const JobArguments& arguments, JobProgress& progress) {
  std::vector<io::Layer> layers;
  for (std::size_t k = 0; k < job.operands.size(); ++k) {
    const auto show = [&](double share) {
      progress.show(Phase::reading, "reading " + label(job, k),
                    (static_cast<double>(k) + share) / static_cast<double>(job.operands.size()));
    };
    show(0);
    io::ReadOptions options = read_options(arguments.input, arguments.output.output);
    options.other = arguments.strict ? io::OtherGeometry::refuse : io::OtherGeometry::count_and_skip;
    options.threads = arguments.options.threads;
    options.progress = show;
    layers.push_back(io::read(job.operands[k], options));
  }
  return layers;
}

RegionSet compute(const Job& job, const std::vector<io::Layer>& layers, Options options, JobProgress& progress) {
  InterruptFlag watch;
  options.progress = [&](Stage stage, double fraction) {
    progress.show(Phase::computing, plain_name(stage), fraction);
    return !interrupted();
  };
  try {
    RegionSet result = layers.size() == 1 ? unite(layers[0].regions, options)
                                          : overlay(layers[0].regions, layers[1].regions, job.operation, options);
    watch.end();
    return result;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) throw Interrupted();
    if (error.code() == ErrorCode::bad_option) throw CallError(error.what());
    const std::size_t operand = error.place().operand;
    if (operand >= layers.size() || error.place().contour == Place::npos) throw io::IoError(error.what());
    throw io::IoError(fmt::format("{}: {}", io::describe(layers[operand], error.place()), error.what()));
  }
}

}  // namespace

void check_call(const std::vector<std::vector<std::string>>& operands, const JobArguments& arguments, bool json) {
  int from_standard_input = 0;
  for (const auto& paths : operands) {
    for (const std::string& path : paths) from_standard_input += path == "-";
  }
  if (from_standard_input > 1) throw CallError("standard input (-) can be named only once");
  check_picture_call(arguments.picture, arguments.output.output, json);
}

void check_picture_call(const std::string& picture, const std::string& output, bool json) {
  if (picture.empty()) return;
  if (picture == "-" && (json || output == "-"))
    throw CallError(
        fmt::format("--svg - and {} both write to standard output; give one of them a file", json ? "--json" : "-o -"));
  if (picture == output) throw CallError("--svg and -o name the same file; give them different names");
}

void add_file_options(CLI::App& command, JobArguments& arguments, Invocation& invocation) {
  JobArguments* const a = &arguments;
  add_output_options(command, a->output, invocation);
  add_input_options(command, a->input);
  command
      .add_option_function<std::string>(
          "--contours", [a](const std::string& word) { a->options.contours = parse_contours(word); },
          "how to write contours that touch themselves: ogc (default) or leonov-nikitin")
      ->type_name("CONVENTION");
  command.add_flag("--minimal", a->minimal, "leave out vertices exactly on the line between their neighbours");
  add_call_options(command, a->options);
  command.add_option("--svg,--picture", a->picture, picture_option)->type_name("PICTURE");
  command.add_flag("--strict", a->strict, "stop with an error at lines and points (default: skip them)");
  command.add_flag("--json", invocation.json,
                   "print the summary as one JSON object on standard output (with `-o -`: on standard error)");
  command.add_flag("-q,--quiet", a->quiet, "print no progress and no summary");
}

void add_zone_file_options(CLI::App& command, JobArguments& arguments, Invocation& invocation) {
  add_file_options(command, arguments, invocation);
  for (const char* const name : {"--minimal", "--contours", "--strict"})
    command.remove_option(command.get_option(name));
}

void add_job_options(CLI::App& command, JobArguments& arguments, Invocation& invocation, Operands operands) {
  add_file_options(command, arguments, invocation);
  JobArguments* const a = &arguments;
  const std::string rules = "polygons (default), atleast:K, evenodd, nonzero, positive or negative";
  command
      .add_option_function<std::string>(
          "--fill", [a](const std::string& word) { a->fill = parse_fill(word); }, "the fill rule: " + rules)
      ->type_name("RULE");
  if (operands == Operands::two) {
    command
        .add_option_function<std::string>(
            "--fill-b", [a](const std::string& word) { a->fill_b = parse_fill(word); },
            "the fill rule of B, if it is not that of A")
        ->type_name("RULE");
  }
  command
      .add_option_function<std::string>(
          "--engine", [a](const std::string& word) { a->options.engine = parse_engine(word); },
          "leonov-nikitin (default), vatti or skvortsov; all give the same bytes")
      ->type_name("ENGINE");
}

int run_job(const Job& job, const JobArguments& arguments, bool json) {
  const Stopwatch total;
  check_call(job.operands, arguments, json);
  Summary summary;
  io::WriteOptions writing_options = write_options(arguments.output);
  writing_options.notes = &summary.notes;
  io::check_writable(arguments.output.output, writing_options);
  if (!arguments.picture.empty()) io::check_picture_writable(arguments.picture, writing_options.existing);

  JobProgress progress(!arguments.quiet, !arguments.picture.empty());
  const Stopwatch reading;
  const std::vector<io::Layer> layers = read_operands(job, arguments, progress);
  if (layers.size() > 1) require_same_crs("A", layers[0], "B", layers[1]);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    append(summary.notes, reading_notes(label(job, k), layers[k]));
    append(summary.notes, attributes_note(label(job, k), layers[k].columns));
  }
  if (layers.size() > 1) append(summary.notes, apart_note("A", layers[0], "B", layers[1]));
  summary.seconds_read = reading.seconds();

  Options options = arguments.options;
  options.fill_a = arguments.fill;
  options.fill_b = arguments.fill_b.value_or(arguments.fill);
  options.statistics = &summary.statistics;
  options.collinear = arguments.minimal ? CollinearVertices::drop : CollinearVertices::keep;
  const RegionSet result = compute(job, layers, options, progress);

  progress.show(Phase::writing, "writing", 0);
  const Stopwatch writing;
  writing_options.crs_wkt = layers[0].crs_wkt;
  writing_options.progress = [&](double share) { progress.show(Phase::writing, "writing", share); };
  io::write(arguments.output.output, result, writing_options);
  summary.seconds_write = writing.seconds();

  if (!arguments.picture.empty()) {
    stop_before_more_output();
    progress.show(Phase::drawing, "drawing", 0);
    const Stopwatch drawing;
    JobPicture picture{{}, job.operands, result, layers.size() > 1 ? name(job.operation) : "union", {}};
    for (const io::Layer& layer : layers) picture.layers.push_back(&layer);
    draw(picture, arguments.picture, writing_options.existing);
    summary.seconds_picture = drawing.seconds();
  }
  progress.clear();

  summary.command = job.command;
  for (std::size_t k = 0; k < layers.size(); ++k)
    summary.operands.push_back(summarise(label(job, k), job.operands[k], layers[k]));
  summary.output = arguments.output.output;
  summary.picture = arguments.picture;
  summary.engine = options.engine;
  add_measures(summary, result, writing_options.crs_wkt, !json && !arguments.quiet);
  summary.seconds_total = total.seconds();
  report(summary, json, arguments.quiet);
  return exit_done;
}

}  // namespace oblast::app
