// Sort-tile-recursive packing (Leutenegger, Lopez, Edgington 1997); see geopackage_index.h.
//
// SQLite keeps an R-tree in three tables. `_node` has nodes of a fixed size: the depth of the tree (in the root, node
// 1), the number of cells, and the cells: an id and a box of four floats, in big-endian order. In a leaf the id is a
// row, in other nodes a node. `_parent` and `_rowid` have the node of each node and row.
#include "io/geopackage_index.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace oblast::io {

namespace {

constexpr std::size_t head_size = 4, cell_size = 24;  // bytes

using Bytes = std::vector<unsigned char>;

struct Cell {
  std::int64_t id;
  float x0, x1, y0, y1;
};

// The box of floats has the box of doubles in it.
float below(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded > value ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}
float above(double value) { return -below(-value); }

// Neighbours in the plane become neighbours in the order, so that each run of `most_cells` has a small box.
void sort_by_tiles(std::vector<Cell>& cells, std::size_t most_cells) {
  const auto middle_x = [](const Cell& c) { return c.x0 + c.x1; };
  const auto middle_y = [](const Cell& c) { return c.y0 + c.y1; };
  tbb::parallel_sort(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) {
    return middle_x(a) != middle_x(b) ? middle_x(a) < middle_x(b) : a.id < b.id;
  });
  const double nodes = std::ceil(static_cast<double>(cells.size()) / static_cast<double>(most_cells));
  const std::size_t slice = static_cast<std::size_t>(std::ceil(std::sqrt(nodes))) * most_cells;
  for (std::size_t begin = 0; begin < cells.size(); begin += slice) {
    const auto first = cells.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = cells.begin() + static_cast<std::ptrdiff_t>(std::min(cells.size(), begin + slice));
    tbb::parallel_sort(first, last, [&](const Cell& a, const Cell& b) {
      return middle_y(a) != middle_y(b) ? middle_y(a) < middle_y(b) : a.id < b.id;
    });
  }
}

template <class Number>
void put(Bytes& node, std::size_t at, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i)
    node[at + i] = static_cast<unsigned char>(number >> (8 * (sizeof number - 1 - i)));
}

Bytes node_of(std::span<const Cell> cells, std::uint16_t depth, std::size_t size) {
  Bytes node(size);
  put(node, 0, depth);
  put(node, 2, static_cast<std::uint16_t>(cells.size()));
  std::size_t at = head_size;
  for (const Cell& cell : cells) {
    put(node, at, static_cast<std::uint64_t>(cell.id));
    at += 8;
    for (const float bound : {cell.x0, cell.x1, cell.y0, cell.y1}) {
      put(node, at, std::bit_cast<std::uint32_t>(bound));
      at += 4;
    }
  }
  return node;
}

Cell around(std::span<const Cell> cells, std::int64_t node) {
  Cell sum = cells.front();
  sum.id = node;
  for (const Cell& cell : cells) {
    sum.x0 = std::min(sum.x0, cell.x0);
    sum.x1 = std::max(sum.x1, cell.x1);
    sum.y0 = std::min(sum.y0, cell.y0);
    sum.y1 = std::max(sum.y1, cell.y1);
  }
  return sum;
}

struct Link {
  std::int64_t child, node;
};

class Tree {
 public:
  Tree(SqliteFile& file, const std::string& table)
      : file_(file),
        table_(table),
        node_size_(size_of_root(file, table)),
        most_cells_((node_size_ - head_size) / cell_size),
        node_(file, "INSERT OR REPLACE INTO " + sql_name(table + "_node") + " VALUES (?, ?)") {}

  // Level by level, from the leaves to the root.
  void write(std::vector<Cell> cells) {
    for (std::uint16_t depth = 0;; ++depth) {
      std::vector<Link>& links = depth == 0 ? rows_ : parents_;
      if (cells.size() <= most_cells_) {
        write_node(1, cells, depth, links);
        break;
      }
      sort_by_tiles(cells, most_cells_);
      std::vector<Cell> nodes;
      for (std::size_t begin = 0; begin < cells.size(); begin += most_cells_) {
        const auto of_node = std::span(cells).subspan(begin, std::min(most_cells_, cells.size() - begin));
        write_node(next_, of_node, 0, links);
        nodes.push_back(around(of_node, next_++));
      }
      cells = std::move(nodes);
    }
    write_links("_rowid", rows_);
    write_links("_parent", parents_);
  }

 private:
  // SQLite has chosen the size of all nodes by the size of pages. An empty tree has a root.
  static std::size_t size_of_root(SqliteFile& file, const std::string& table) {
    SqliteStatement root(file, "SELECT length(data) FROM " + sql_name(table + "_node") + " WHERE nodeno = 1");
    const std::int64_t size = root.step() ? sqlite3_column_int64(root.get(), 0) : 0;
    if (size < static_cast<std::int64_t>(head_size + 2 * cell_size)) file.fail();
    return static_cast<std::size_t>(size);
  }

  void write_node(std::int64_t number, std::span<const Cell> cells, std::uint16_t depth, std::vector<Link>& links) {
    const auto bytes = node_of(cells, depth, node_size_);
    node_.bind(1, number);
    node_.bind_blob(2, bytes.data(), bytes.size());
    node_.run();
    for (const Cell& cell : cells) links.push_back({cell.id, number});
  }

  void write_links(const char* suffix, std::vector<Link>& links) {
    tbb::parallel_sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return a.child < b.child; });
    SqliteStatement insert(file_, "INSERT INTO " + sql_name(table_ + suffix) + " VALUES (?, ?)");
    for (const Link& link : links) {
      insert.bind(1, link.child);
      insert.bind(2, link.node);
      insert.run();
    }
  }

  SqliteFile& file_;
  const std::string& table_;
  std::size_t node_size_, most_cells_;
  SqliteStatement node_;
  std::int64_t next_ = 2;
  std::vector<Link> rows_, parents_;
};

}  // namespace

void fill_index(SqliteFile& file, const std::string& table, const std::vector<IndexedBox>& boxes) {
  std::vector<Cell> cells;
  cells.reserve(boxes.size());
  for (const auto& [id, box] : boxes) cells.push_back({id, below(box.x0), above(box.x1), below(box.y0), above(box.y1)});
  Tree(file, table).write(std::move(cells));
}

}  // namespace oblast::io
