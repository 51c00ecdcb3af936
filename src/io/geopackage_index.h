// The spatial index of a GeoPackage: an R-tree of SQLite, built at once from all boxes.
#pragma once

#include <oblast/measure.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/sqlite_file.h"

namespace oblast::io {

struct IndexedBox {
  std::int64_t id = 0;
  Box box;
};

/// Fills the empty R-tree `table` of SQLite. SQLite would insert the boxes one by one, which takes most of the time of
/// writing a layer. The tables of the tree are written here instead, in the format of SQLite, which is fixed. `boxes`
/// are in the order of their ids. Time n log n, on all cores.
void fill_index(SqliteFile& file, const std::string& table, const std::vector<IndexedBox>& boxes);

}  // namespace oblast::io
