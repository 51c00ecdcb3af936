// One file, read in one pass: its polygons, and if they are wanted its attributes. Only for use inside src/io.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/attribute_table.h"
#include "io/layer.h"
#include "io/read.h"
#include "io/source.h"

class OGRFeature;

namespace oblast::io {

enum class Attributes { pass_over, keep };

/// The attributes of one file, a row for each entry of Layer::features.
struct FileTable {
  FileTable();
  ~FileTable();
  FileTable(FileTable&&) noexcept;
  FileTable& operator=(FileTable&&) noexcept;

  std::vector<Column> columns;                    ///< column i is field i of each feature
  std::vector<std::unique_ptr<OGRFeature>> rows;  ///< without geometry; empty if the format has no attributes
};

struct FilePart {
  Layer layer;
  FileTable table;
};

struct Parts {
  std::vector<FilePart> files;     ///< in the order of the list
  std::vector<std::string> notes;  ///< on folders
  std::string crs_wkt;             ///< of all files
};

/// Lists the files and reads them in parallel. REQUIRES: attributes are kept only with FeatureEntries::all. Throws
/// IoError: for the first faulty file of the list, whatever the order in which threads read them.
Parts read_parts(std::span<const std::string> paths, const ReadOptions& options, Attributes attributes);

/// Appends the shapes, the features and the counts of another layer. Features keep their file and number.
void append_shapes(Layer& sum, const Layer& part);

/// Joins the layers in their order, and frees them.
Layer join_layers(Parts& parts);

/// The rows of all files. Columns are joined by name. If their types differ, the column is wide enough for both, or
/// text; `notes` says so.
AttributeTable join_tables(Parts& parts, std::vector<std::string>& notes);

}  // namespace oblast::io
