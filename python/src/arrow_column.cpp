#include "arrow_column.h"

#include <cerrno>
#include <string>

namespace oblast::python {

namespace {

struct SchemaData {
  std::string format, name, metadata;
  std::vector<ArrowSchema*> children;
};

struct ArrayData {
  std::shared_ptr<const ArrowColumn> column;
  std::vector<const void*> buffers;
  std::vector<ArrowArray*> children;
};

template <class Node, class Data>
void release(Node* node) {
  auto* data = static_cast<Data*>(node->private_data);
  for (Node* child : data->children) {
    if (child->release != nullptr) child->release(child);
    delete child;
  }
  delete data;
  node->release = nullptr;
}

void set_schema(ArrowSchema& out, std::string format, std::string name, std::vector<ArrowSchema*> children = {},
                std::string metadata = {}) {
  auto* data = new SchemaData{std::move(format), std::move(name), std::move(metadata), std::move(children)};
  out = {};
  out.format = data->format.c_str();
  out.name = data->name.c_str();
  out.metadata = data->metadata.empty() ? nullptr : data->metadata.data();
  out.n_children = static_cast<std::int64_t>(data->children.size());
  out.children = data->children.data();
  out.release = &release<ArrowSchema, SchemaData>;
  out.private_data = data;
}

ArrowSchema* new_schema(std::string format, std::string name, std::vector<ArrowSchema*> children = {}) {
  auto* schema = new ArrowSchema;
  set_schema(*schema, std::move(format), std::move(name), std::move(children));
  return schema;
}

void set_array(ArrowArray& out, const std::shared_ptr<const ArrowColumn>& column, std::size_t length,
               std::vector<const void*> buffers, std::vector<ArrowArray*> children = {}) {
  auto* data = new ArrayData{column, std::move(buffers), std::move(children)};
  out = {};
  out.length = static_cast<std::int64_t>(length);
  out.n_buffers = static_cast<std::int64_t>(data->buffers.size());
  out.n_children = static_cast<std::int64_t>(data->children.size());
  out.buffers = data->buffers.data();
  out.children = data->children.data();
  out.release = &release<ArrowArray, ArrayData>;
  out.private_data = data;
}

ArrowArray* new_array(const std::shared_ptr<const ArrowColumn>& column, std::size_t length,
                      std::vector<const void*> buffers, std::vector<ArrowArray*> children = {}) {
  auto* array = new ArrowArray;
  set_array(*array, column, length, std::move(buffers), std::move(children));
  return array;
}

// Metadata of a field, with one key: the name of the extension type.
std::string extension(const std::string& name) {
  std::string bytes;
  const auto add = [&](const std::string& text) {
    const auto length = static_cast<std::int32_t>(text.size());
    bytes.append(reinterpret_cast<const char*>(&length), sizeof length).append(text);
  };
  const std::int32_t pairs = 1;
  bytes.append(reinterpret_cast<const char*>(&pairs), sizeof pairs);
  add("ARROW:extension:name");
  add(name);
  return bytes;
}

std::vector<std::int32_t> signed_copy(std::span<const std::uint32_t> offsets) {
  return {offsets.begin(), offsets.end()};
}

ArrowArray* new_points(const std::shared_ptr<const ArrowColumn>& column) {
  const auto count = static_cast<std::size_t>(column->rings.back());
  if (column->interleaved)
    return new_array(column, count, {nullptr}, {new_array(column, 2 * count, {nullptr, column->x.data()})});
  return new_array(
      column, count, {nullptr},
      {new_array(column, count, {nullptr, column->x.data()}), new_array(column, count, {nullptr, column->y.data()})});
}

struct StreamData {
  std::shared_ptr<const ArrowColumn> column;
  bool ended = false;
};

// What C calls must not throw.
template <class Work>
int code_of(const Work& work) {
  try {
    work();
    return 0;
  } catch (...) {
    return ENOMEM;
  }
}

StreamData& data_of(ArrowArrayStream* stream) { return *static_cast<StreamData*>(stream->private_data); }

}  // namespace

std::shared_ptr<const ArrowColumn> make_column(const Arrays& rows, bool multipolygon, bool interleaved) {
  auto column = std::make_shared<ArrowColumn>();
  column->multipolygon = multipolygon;
  column->interleaved = interleaved;
  column->rows = signed_copy(rows.row_offsets);
  column->polygons = signed_copy(rows.polygon_offsets);
  if (!multipolygon) {
    std::vector<std::int32_t> ends{0};
    for (std::size_t r = 0; r < rows.row_count(); ++r) {
      if (column->rows[r + 1] - column->rows[r] > 1)
        throw nb::value_error(
            ("row " + std::to_string(r) + " has several polygons: use encoding='multipolygon', or explode() first")
                .c_str());
      ends.push_back(column->polygons[static_cast<std::size_t>(column->rows[r + 1])]);
    }
    column->polygons = std::move(ends);
  }
  const auto add = [&](const Point& p) {
    column->x.push_back(p.x);
    (interleaved ? column->x : column->y).push_back(p.y);
  };
  column->x.reserve((rows.points.size() + rows.ring_offsets.size()) * (interleaved ? 2 : 1));
  column->rings.push_back(0);
  for (const std::span<const Point> ring : rows.regions().contours()) {
    for (const Point& p : ring) add(p);
    if (!ring.empty() && (ring.size() == 1 || ring.front() != ring.back())) add(ring.front());
    column->rings.push_back(static_cast<std::int32_t>(interleaved ? column->x.size() / 2 : column->x.size()));
  }
  return column;
}

void export_schema(const ArrowColumn& column, ArrowSchema& out) {
  ArrowSchema* points = column.interleaved ? new_schema("+w:2", "vertices", {new_schema("g", "xy")})
                                           : new_schema("+s", "vertices", {new_schema("g", "x"), new_schema("g", "y")});
  ArrowSchema* rings = new_schema("+l", "rings", {points});
  if (column.multipolygon) {
    set_schema(out, "+l", "geometry", {new_schema("+l", "polygons", {rings})}, extension("geoarrow.multipolygon"));
  } else {
    set_schema(out, "+l", "geometry", {rings}, extension("geoarrow.polygon"));
  }
}

void export_array(const std::shared_ptr<const ArrowColumn>& column, ArrowArray& out) {
  ArrowArray* rings =
      new_array(column, column->rings.size() - 1, {nullptr, column->rings.data()}, {new_points(column)});
  const std::size_t polygons = column->polygons.size() - 1;
  if (column->multipolygon) {
    ArrowArray* parts = new_array(column, polygons, {nullptr, column->polygons.data()}, {rings});
    set_array(out, column, column->rows.size() - 1, {nullptr, column->rows.data()}, {parts});
  } else {
    set_array(out, column, polygons, {nullptr, column->polygons.data()}, {rings});
  }
}

void export_stream(const std::shared_ptr<const ArrowColumn>& column, ArrowArrayStream& out) {
  out = {};
  out.private_data = new StreamData{column};
  out.get_schema = [](ArrowArrayStream* stream, ArrowSchema* schema) {
    return code_of([&] { export_schema(*data_of(stream).column, *schema); });
  };
  out.get_next = [](ArrowArrayStream* stream, ArrowArray* array) {
    *array = {};
    return code_of([&] {
      StreamData& data = data_of(stream);
      if (!data.ended) export_array(data.column, *array);
      data.ended = true;
    });
  };
  out.get_last_error = [](ArrowArrayStream*) -> const char* { return nullptr; };
  out.release = [](ArrowArrayStream* stream) {
    delete static_cast<StreamData*>(stream->private_data);
    stream->release = nullptr;
  };
}

}  // namespace oblast::python
