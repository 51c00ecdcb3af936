// From files to rows in a file; see row_job.h.
#include "oblast/row_job.h"

#include <fmt/format.h>
#include <oblast/oblast.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "io/crs.h"
#include "io/picture_file.h"
#include "io/row_measures.h"
#include "io/write_rows.h"
#include "oblast/interrupt.h"
#include "oblast/job_picture.h"
#include "oblast/names.h"
#include "oblast/row_colour.h"

namespace oblast::app {

namespace {

void check_fill(const FillRule& rule, const char* option, const char* instead) {
  if (rule.by_polygon()) return;
  throw CallError(fmt::format("{} {} reads all contours of a layer together, so there are no rows; {}", option,
                              name(rule), instead));
}

std::vector<std::vector<std::string>> paths_of(const std::vector<RowInput>& inputs) {
  std::vector<std::vector<std::string>> paths;
  paths.reserve(inputs.size());
  for (const RowInput& input : inputs) paths.push_back(input.paths);
  return paths;
}

}  // namespace

void add_row_options(CLI::App& command, RowArguments& arguments, Select select) {
  command
      .add_option("--where", arguments.where,
                  "use only the features for which this condition on their attributes holds, such as \"level > 3\"")
      ->type_name("CONDITION");
  if (select == Select::columns) {
    command.add_option("--select", arguments.select, "keep only these columns (default: all)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("COLUMN,...");
  }
  command.add_option("--area", arguments.area, "add a column with the area of each row")->type_name("COLUMN");
  command.add_option("--perimeter", arguments.perimeter, "add a column with the perimeter of each row")
      ->type_name("COLUMN");
  command.add_option("--colour", arguments.colour, "with --svg: colour the rows by this column of the result")
      ->type_name("COLUMN");
}

RowJob::RowJob(std::string command, std::vector<RowInput> inputs, const JobArguments& arguments,
               const RowArguments& row_arguments, bool json)
    : command_(std::move(command)),
      inputs_(std::move(inputs)),
      arguments_(arguments),
      row_arguments_(row_arguments),
      json_(json),
      progress_(!arguments.quiet, !arguments.picture.empty()) {
  check_call(paths_of(inputs_), arguments_, json);
  if (!row_arguments_.colour.empty() && arguments_.picture.empty())
    throw CallError("--colour is for pictures; add --svg PICTURE");
  const char* const instead = inputs_.size() > 1 ? "add --merge" : "leave out --source";
  check_fill(arguments_.fill, "--fill", instead);
  if (arguments_.fill_b) check_fill(*arguments_.fill_b, "--fill-b", instead);
  const io::WriteOptions writing = write_options(arguments_.output);
  io::check_writable(arguments_.output.output, writing);
  if (!arguments_.picture.empty()) io::check_picture_writable(arguments_.picture, writing.existing);

  const Stopwatch reading;
  for (const RowInput& input : inputs_) {
    const auto show = [&, before = static_cast<double>(layers_.size())](double share) {
      progress_.show(Phase::reading, "reading " + input.label, (before + share) / static_cast<double>(inputs_.size()));
    };
    show(0);
    io::ReadOptions options = read_options(arguments_.input, arguments_.output.output);
    options.other = input.keep_others   ? io::OtherGeometry::keep
                    : arguments_.strict ? io::OtherGeometry::refuse
                                        : io::OtherGeometry::count_and_skip;
    options.where = input.where.value_or(row_arguments_.where);
    options.threads = arguments_.options.threads;
    options.progress = show;
    layers_.push_back(io::read_rows(input.paths, options, notes_));
    const io::Layer& layer = layers_.back().layer;
    append(notes_, reading_notes(input.label, layer));
    for (std::size_t k = 0; k + 1 < layers_.size(); ++k)
      require_same_crs(inputs_[k].label, layers_[k].layer, input.label, layer);
  }
  crs_wkt_ = layers_.front().layer.crs_wkt;
  if (layers_.size() == 2)
    append(notes_, apart_note(inputs_[0].label, layers_[0].layer, inputs_[1].label, layers_[1].layer));
  summary_.seconds_read = reading.seconds();
  for (const std::string& column : row_arguments_.select) check_column(column, layers_);
}

void RowJob::compute(const std::function<void(const Options&)>& run) {
  Options options = arguments_.options;
  options.fill_a = arguments_.fill;
  options.fill_b = arguments_.fill_b.value_or(arguments_.fill);
  options.statistics = &summary_.statistics;
  options.collinear = arguments_.minimal ? CollinearVertices::drop : CollinearVertices::keep;
  InterruptFlag watch;
  options.progress = [&](Stage stage, double fraction) {
    progress_.show(Phase::computing, plain_name(stage), fraction);
    return !interrupted();
  };
  try {
    run(options);
    watch.end();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) throw Interrupted();
    if (error.code() == ErrorCode::bad_option) throw CallError(error.what());
    const std::size_t operand = error.place().operand;
    if (operand >= layers_.size() || error.place().contour == Place::npos) throw io::IoError(error.what());
    throw io::IoError(fmt::format("{}: {}", io::describe(layers_[operand].layer, error.place()), error.what()));
  }
}

void RowJob::add_measures(const FeatureView& rows, ResultColumns& columns) {
  if (row_arguments_.area.empty() && row_arguments_.perimeter.empty()) return;
  const io::RowMeasures measures(crs_wkt_);
  const auto add = [&](const std::string& column, const std::string& unit, const std::vector<double>& values) {
    for (const io::OutputColumn& other : columns.columns) {
      if (other.column.name == column)
        throw CallError(fmt::format("there is a column {} already; choose another name for the measure", column));
    }
    columns.add(column, values);
    units_.push_back(fmt::format("column {} is in {}", column, unit));
  };
  if (!row_arguments_.area.empty()) add(row_arguments_.area, measures.area_unit(), measures.areas(rows));
  if (!row_arguments_.perimeter.empty())
    add(row_arguments_.perimeter, measures.length_unit(), measures.perimeters(rows));
}

void RowJob::check_colour(const ResultColumns& columns) const {
  if (row_arguments_.colour.empty()) return;
  if (find_column(columns.columns, row_arguments_.colour)) return;
  std::string names;
  for (const io::OutputColumn& column : columns.columns) names += (names.empty() ? "" : ", ") + column.column.name;
  throw CallError(fmt::format("the result has no column {}; choose from {}", row_arguments_.colour, names));
}

void RowJob::draw_rows(const FeatureView& rows, const ResultColumns& columns, const RowPicture& picture) {
  JobPicture drawn{{}, paths_of(inputs_), rows.regions, picture.operation, {}};
  for (const io::Rows& layer : layers_) drawn.layers.push_back(&layer.layer);
  const std::string& colour = row_arguments_.colour.empty() ? picture.colour : row_arguments_.colour;
  if (const io::OutputColumn* column = find_column(columns.columns, colour)) {
    drawn.classes = colour_classes(rows, *column);
    drawn.result = {};
    if (colour != drawn.operation) drawn.operation += " by " + colour;  // not "depth by depth"
  } else if (!picture.classes.empty()) {
    drawn.classes = picture.classes;
    drawn.result = {};
  }
  drawn.classes.insert(drawn.classes.end(), picture.over.begin(), picture.over.end());
  draw(drawn, arguments_.picture, write_options(arguments_.output).existing);
}

int RowJob::finish(const FeatureView& rows, ResultColumns columns, const RowPicture& picture) {
  add_measures(rows, columns);
  check_colour(columns);
  note_attributes(columns);
  progress_.show(Phase::writing, "writing", 0);
  const Stopwatch writing;
  io::WriteOptions options = write_options(arguments_.output);
  options.crs_wkt = crs_wkt_;
  options.progress = [&](double share) { progress_.show(Phase::writing, "writing", share); };
  io::write_rows(arguments_.output.output, rows, columns.columns, options, notes_);
  summary_.seconds_write = writing.seconds();
  if (!arguments_.picture.empty()) {
    stop_before_more_output();
    progress_.show(Phase::drawing, "drawing", 0);
    const Stopwatch drawing;
    draw_rows(rows, columns, picture);
    summary_.seconds_picture = drawing.seconds();
  }
  progress_.clear();
  print_summary(rows, columns.columns.size());
  return exit_done;
}

// A layer of which no column is kept, and whose columns no column of the result was computed from.
void RowJob::note_attributes(const ResultColumns& columns) {
  if (!row_arguments_.select.empty()) return;
  for (std::size_t k = 0; k < layers_.size(); ++k) {
    const io::AttributeTable& table = layers_[k].table;
    bool used = false;
    std::vector<std::string> names;
    for (const io::Column& of_layer : table.columns()) {
      names.push_back(of_layer.name);
      for (const io::OutputColumn& column : columns.columns)
        used = used || column.table == &table || column.column.name.starts_with(of_layer.name);
    }
    if (!used) append(notes_, attributes_note(inputs_[k].label, names));
  }
}

void RowJob::print_summary(const FeatureView& rows, std::size_t columns) {
  summary_.command = command_;
  for (std::size_t k = 0; k < layers_.size(); ++k)
    summary_.operands.push_back(summarise(inputs_[k].label, inputs_[k].paths, layers_[k].layer));
  summary_.output = arguments_.output.output;
  summary_.picture = arguments_.picture;
  summary_.rows = rows.feature_count();
  summary_.columns = columns;
  summary_.notes = notes_;
  summary_.units = units_;
  app::add_measures(summary_, rows.regions, crs_wkt_, !json_ && !arguments_.quiet);
  // Repaired rows keep the directions of their rings.
  if (!summary_.noded) summary_.area = area(rows.regions);
  summary_.seconds_total = total_.seconds();
  report(summary_, json_, arguments_.quiet);
}

}  // namespace oblast::app
