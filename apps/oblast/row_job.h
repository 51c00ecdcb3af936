// The common part of the commands whose results are rows: `overlay`, `dissolve`, `depth`, `partition`, `repair`,
// `buffer` and `zones`.
#pragma once

#include <oblast/features.h>

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/picture.h"
#include "io/row_columns.h"
#include "io/rows.h"
#include "oblast/cli.h"
#include "oblast/console.h"
#include "oblast/job.h"
#include "oblast/stopwatch.h"
#include "oblast/summary.h"

namespace oblast::app {

/// The options of rows, as given on the command line.
struct RowArguments {
  std::string where;
  std::optional<std::string> where_a, where_b;  ///< in place of `where`
  std::vector<std::string> select;              ///< empty: all columns
  std::string area;                             ///< name of the column; empty: none
  std::string perimeter;
  std::string colour;  ///< the column by which a picture is coloured; empty: what is usual of the command
};

/// What a picture of rows shows.
struct RowPicture {
  std::string operation;                       ///< for the title
  std::string colour;                          ///< the column by which it is coloured, if none is given; empty: by none
  std::vector<io::PictureClass> classes = {};  ///< how it is coloured if there is no such column
  std::vector<io::PictureClass> over = {};     ///< what is drawn over these classes
};

enum class Select { columns, none };
/// Adds --where, --area, --perimeter and --colour, and --select to a command that keeps columns.
void add_row_options(CLI::App& command, RowArguments& arguments, Select select);

/// The columns of a result, and the indices that join them.
struct ResultColumns {
  std::vector<io::OutputColumn> columns;
  std::deque<std::vector<std::uint32_t>> indices;

  /// Column `index` of `table`, with a row of the table for each row of the result.
  void join(const io::AttributeTable& table, std::size_t index, std::span<const std::uint32_t> rows);
  void add(const std::string& name, io::ColumnType type, std::vector<io::Value> values);
  void add(const std::string& name, const std::vector<double>& values);
};

/// One input: a layer. `label` is "A", "B", ...; "input" if there is one.
struct RowInput {
  std::string label;
  std::vector<std::string> paths;
  std::optional<std::string> where = {};  ///< in place of RowArguments::where
  bool keep_others = false;               ///< lines and points are wanted, too
};

/// Reads the inputs, computes, writes and reports.
class RowJob {
 public:
  /// Reads. Errors of the call and of the output are reported before. `command` is for the summary.
  RowJob(std::string command, std::vector<RowInput> inputs, const JobArguments& arguments,
         const RowArguments& row_arguments, bool json);

  const std::vector<io::Rows>& layers() const { return layers_; }

  /// Calls `run` with the options; errors get the names of file and feature.
  void compute(const std::function<void(const Options&)>& run);

  /// Members of the summary that only this command has. `noded`: it counts intersections, as overlays do.
  void add_to_summary(nlohmann::ordered_json members, bool noded) {
    summary_.more = std::move(members);
    summary_.noded = noded;
  }
  void note(std::string text) { notes_.push_back(std::move(text)); }

  /// Writes the rows, draws if a picture is wanted, and prints notes and the summary. Returns an exit code.
  int finish(const FeatureView& rows, ResultColumns columns, const RowPicture& picture);

 private:
  void check_colour(const ResultColumns& columns) const;
  void draw_rows(const FeatureView& rows, const ResultColumns& columns, const RowPicture& picture);
  void add_measures(const FeatureView& rows, ResultColumns& columns);
  void note_attributes(const ResultColumns& columns);
  void print_summary(const FeatureView& rows, std::size_t columns);

  Stopwatch total_;
  std::string command_;
  std::vector<RowInput> inputs_;
  JobArguments arguments_;
  RowArguments row_arguments_;
  bool json_;
  JobProgress progress_;
  Summary summary_;
  std::vector<std::string> notes_;  // what the file does not hold as it was given
  std::vector<std::string> units_;  // of the measures
  std::vector<io::Rows> layers_;
  std::string crs_wkt_;
};

/// The columns of a table that --select names; all if it is empty.
std::vector<std::size_t> selected(const io::AttributeTable& table, const std::vector<std::string>& select);
/// Throws IoError, which lists the columns there are, if none of the tables has a column of this name.
void check_column(const std::string& name, std::span<const io::Rows> layers);

}  // namespace oblast::app
