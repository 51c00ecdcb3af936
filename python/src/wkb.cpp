#include "wkb.h"

#include <oblast/wkb.h>

#include <atomic>
#include <optional>

#include "bindings.h"
#include "blocks.h"

namespace oblast::python {

namespace {

// The type of the outermost geometry: ISO has thousands for Z and M, EWKB has bits.
bool has_more_than_two_dimensions(Wkb bytes) {
  if (bytes.size() < 5) return false;
  const bool little = bytes[0] == std::byte{1};
  std::uint32_t type = 0;
  for (int i = 0; i < 4; ++i) type |= std::to_integer<std::uint32_t>(bytes[1 + i]) << (8 * (little ? i : 3 - i));
  return (type & 0xc0000000U) != 0 || (type & 0x0fffffffU) >= 1000;
}

Wkb bytes_of(nb::handle object, std::size_t index) {
  if (object.is_none()) return {};
  char* data = nullptr;
  Py_ssize_t size = 0;
  if (!PyBytes_Check(object.ptr()) || PyBytes_AsStringAndSize(object.ptr(), &data, &size) != 0) {
    PyErr_Clear();
    throw nb::type_error(("geometry " + std::to_string(index) + " is neither bytes nor None").c_str());
  }
  return {reinterpret_cast<const std::byte*>(data), static_cast<std::size_t>(size)};
}

nb::tuple from_wkb(const nb::list& geometries, const Settings& settings) {
  std::vector<Wkb> spans;
  spans.reserve(nb::len(geometries));
  for (const nb::handle geometry : geometries) spans.push_back(bytes_of(geometry, spans.size()));
  bool has_z = false;
  FeatureSet rows = read_rows(spans, settings, has_z);
  return nb::make_tuple(from_features(std::move(rows)), has_z);
}

nb::list to_wkb_list(const Arrays& a, const Settings& settings) {
  std::vector<std::vector<std::byte>> written(a.row_count());
  run(settings, {&a}, [&](const CallOptions& common) {
    CallOptions one = common;
    one.threads = 1;
    one.progress = {};
    for_blocks(written.size(), common, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) written[row] = to_wkb(a.row(row), one);
    });
  });
  nb::list all;
  for (const auto& bytes : written) all.append(nb::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  return all;
}

}  // namespace

FeatureSet read_rows(const std::vector<Wkb>& geometries, const Settings& settings, bool& has_z) {
  FeatureSet rows;
  std::optional<Error> fault;
  std::size_t faulty = 0;
  std::atomic<bool> found_z = false;
  Settings watched = settings;
  run(watched, {}, [&](const CallOptions& common) {
    CallOptions one = common;
    one.threads = 1;
    one.progress = {};
    try {
      rows = collect_rows(geometries.size(), common, [&]() -> AddRow {
        return [&](std::size_t job, FeatureSet& to) {
          const Wkb bytes = geometries[job];
          if (has_more_than_two_dimensions(bytes)) found_z = true;
          add_row(to, bytes.empty() ? RegionSet{} : read_wkb(bytes, one));
        };
      });
    } catch (const JobError& error) {
      fault = error;
      faulty = error.job();
    }
  });
  if (fault) raise_error(*fault, {}, faulty);
  has_z = found_z;
  return rows;
}

void bind_wkb(nb::module_& module) {
  module.def("from_wkb", &from_wkb, nb::arg("geometries"), nb::arg("settings"),
             nb::sig("def from_wkb(geometries: list[bytes | None], settings: Settings) -> tuple[Arrays, bool]"));
  module.def("to_wkb", &to_wkb_list, nb::arg("a"), nb::arg("settings"),
             nb::sig("def to_wkb(a: Arrays, settings: Settings) -> list[bytes]"));
}

}  // namespace oblast::python
