// The Arrow PyCapsule protocol, in and out.
#include "arrow_column.h"
#include "arrow_geometry.h"
#include "bindings.h"

namespace oblast::python {

namespace {

template <class T>
T& inside(nb::handle capsule, const char* name) {
  auto* pointer = static_cast<T*>(PyCapsule_GetPointer(capsule.ptr(), name));
  if (pointer == nullptr) throw nb::python_error();
  if (pointer->release == nullptr) throw nb::value_error("the Arrow capsule was used before");
  return *pointer;
}

// Whoever reads a capsule takes over what is in it.
ArrowOwner take_over(ArrowArray& array) {
  ArrowOwner owner(new ArrowArray(array), [](const ArrowArray* owned) {
    auto* last = const_cast<ArrowArray*>(owned);
    if (last->release != nullptr) last->release(last);
    delete last;
  });
  array.release = nullptr;
  return owner;
}

template <class T>
nb::object capsule_of(T* content, const char* name) {
  PyObject* capsule = PyCapsule_New(content, name, [](PyObject* self) {
    auto* pointer = static_cast<T*>(PyCapsule_GetPointer(self, PyCapsule_GetName(self)));
    if (pointer->release != nullptr) pointer->release(pointer);
    delete pointer;
  });
  if (capsule == nullptr) throw nb::python_error();
  return nb::steal(capsule);
}

nb::tuple from_array(nb::handle schema, nb::handle array, const std::string& name, const Settings& settings) {
  const GeometryColumn column = geometry_column(inside<ArrowSchema>(schema, "arrow_schema"), name);
  bool has_z = false;
  Arrays rows = rows_of_chunk(take_over(inside<ArrowArray>(array, "arrow_array")), column, settings, has_z);
  return nb::make_tuple(std::move(rows), has_z);
}

void require(ArrowArrayStream& stream, int code) {
  if (code == 0) return;
  if (PyErr_Occurred()) throw nb::python_error();
  const char* message = stream.get_last_error(&stream);
  throw nb::value_error(message != nullptr ? message : "the Arrow stream failed");
}

nb::tuple from_stream(nb::handle capsule, const std::string& name, const Settings& settings) {
  auto& stream = inside<ArrowArrayStream>(capsule, "arrow_array_stream");
  ArrowSchema schema{};
  require(stream, stream.get_schema(&stream, &schema));
  const std::unique_ptr<ArrowSchema, void (*)(ArrowSchema*)> owned(&schema, [](ArrowSchema* s) { s->release(s); });
  const GeometryColumn column = geometry_column(schema, name);
  bool has_z = false;
  std::vector<Arrays> chunks;
  while (true) {
    ArrowArray array{};
    require(stream, stream.get_next(&stream, &array));
    if (array.release == nullptr) break;
    chunks.push_back(rows_of_chunk(take_over(array), column, settings, has_z));
  }
  if (chunks.size() == 1) return nb::make_tuple(std::move(chunks.front()), has_z);
  std::vector<const Arrays*> parts;
  for (const Arrays& chunk : chunks) parts.push_back(&chunk);
  return nb::make_tuple(concatenate(parts), has_z);
}

using Column = std::shared_ptr<const ArrowColumn>;

/// What the Python object holds.
struct Exported {
  Column column;
};

nb::object schema_capsule(const Exported& self) {
  auto* schema = new ArrowSchema;
  export_schema(*self.column, *schema);
  return capsule_of(schema, "arrow_schema");
}

nb::tuple array_capsules(const Exported& self) {
  auto* array = new ArrowArray;
  export_array(self.column, *array);
  nb::object exported = capsule_of(array, "arrow_array");
  return nb::make_tuple(schema_capsule(self), exported);
}

nb::object stream_capsule(const Exported& self) {
  auto* stream = new ArrowArrayStream;
  export_stream(self.column, *stream);
  return capsule_of(stream, "arrow_array_stream");
}

}  // namespace

void bind_arrow(nb::module_& module) {
  nb::class_<Exported>(module, "ArrowColumn")
      .def("schema", &schema_capsule, nb::sig("def schema(self) -> object"))
      .def("array", &array_capsules, nb::sig("def array(self) -> tuple[object, object]"))
      .def("stream", &stream_capsule, nb::sig("def stream(self) -> object"));
  module.def(
      "arrow_column",
      [](const Arrays& rows, bool multipolygon, bool interleaved) {
        return Exported{make_column(rows, multipolygon, interleaved)};
      },
      nb::arg("rows"), nb::arg("multipolygon"), nb::arg("interleaved"));
  module.def("from_arrow_array", &from_array, nb::arg("schema"), nb::arg("array"), nb::arg("column"),
             nb::arg("settings"),
             nb::sig("def from_arrow_array(schema: object, array: object, column: str, settings: Settings) -> "
                     "tuple[Arrays, bool]"));
  module.def("from_arrow_stream", &from_stream, nb::arg("stream"), nb::arg("column"), nb::arg("settings"),
             nb::sig("def from_arrow_stream(stream: object, column: str, settings: Settings) -> tuple[Arrays, bool]"));
}

}  // namespace oblast::python
