// oblast_workload: writes workload files. `oblast_workload list` names what it can generate.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <map>

#include "workloads/workloads.h"
#ifdef OBLAST_BENCH_WITH_IO
#include "io/read.h"
#include "io/write.h"
#endif

namespace oblast::bench {
namespace {

void list() {
  for (const auto list : {general_workloads(), window_workloads(), ioverlay_workloads()}) {
    for (const NamedWorkload& workload : list) fmt::print("{:16}SIZE: {}\n", workload.name, workload.size);
  }
}

struct Arguments {
  std::string name, input, output;
  std::uint32_t size = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> a, b;
  Operation operation = Operation::unite;
  bool overlapping_a = false, overlapping_b = false, coverage = false;
};

#ifdef OBLAST_BENCH_WITH_IO
Workload from_files(const Arguments& arguments) {
  const auto kind = [](bool overlapping) { return overlapping ? OperandKind::overlapping : OperandKind::region_set; };
  RegionSet a = io::read(arguments.a).regions;
  RegionSet b = arguments.b.empty() ? RegionSet{} : io::read(arguments.b).regions;
  Workload workload = single(arguments.operation, std::move(a), std::move(b), kind(arguments.overlapping_a),
                             kind(arguments.overlapping_b));
  workload.coverage = arguments.coverage;
  return workload;
}

void to_files(const Arguments& arguments) {
  const Workload workload = read_workload(arguments.input);
  if (workload.pairs() != 1) throw std::runtime_error("only workloads of one pair are exported");
  const io::WriteOptions options{io::Existing::overwrite, {}, {}};
  io::write(arguments.a.front(), workload.a.pair(0), options);
  if (!arguments.b.empty()) io::write(arguments.b.front(), workload.b.pair(0), options);
}
#else
Workload from_files(const Arguments&) { throw std::runtime_error("built without GDAL: no layers"); }
void to_files(const Arguments&) { throw std::runtime_error("built without GDAL: no layers"); }
#endif

int run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Writes a workload file for the drivers.");
  app.require_subcommand(1);
  app.add_subcommand("list", "what can be generated");

  CLI::App* generate = app.add_subcommand("generate", "a generated workload");
  generate->add_option("NAME", arguments.name)->required();
  generate->add_option("SIZE", arguments.size)->required();
  generate->add_option("--seed", arguments.seed);
  generate->add_option("-o", arguments.output)->required();

  const std::map<std::string, Operation> operations = {{"intersection", Operation::intersection},
                                                       {"union", Operation::unite},
                                                       {"difference", Operation::difference},
                                                       {"symdifference", Operation::symmetric_difference}};
  CLI::App* layer = app.add_subcommand("layer", "files GDAL reads, one operand or two");
  layer->add_option("--a", arguments.a, "files or folders of operand A")->required();
  layer->add_option("--b", arguments.b, "files or folders of operand B");
  layer->add_option("--operation", arguments.operation)->transform(CLI::CheckedTransformer(operations));
  layer->add_flag("--overlapping-a", arguments.overlapping_a, "polygons of A may overlap or share borders");
  layer->add_flag("--overlapping-b", arguments.overlapping_b, "polygons of B may overlap or share borders");
  layer->add_flag("--coverage", arguments.coverage, "polygons of A share borders vertex by vertex");
  layer->add_option("-o", arguments.output)->required();

  CLI::App* exported = app.add_subcommand("export", "the operands of a workload of one pair, as files");
  exported->add_option("FILE", arguments.input)->required();
  exported->add_option("--a", arguments.a, "operand A as .wkt, .gpkg, ...; replaced")->required()->expected(1);
  exported->add_option("--b", arguments.b, "operand B")->expected(1);
  CLI11_PARSE(app, argc, argv);

  if (app.got_subcommand("list")) {
    list();
    return 0;
  }
  if (app.got_subcommand(exported)) {
    to_files(arguments);
    return 0;
  }
  if (app.got_subcommand(layer)) {
    write_workload(arguments.output, from_files(arguments));
    return 0;
  }
  const NamedWorkload* workload = find_workload(arguments.name);
  if (workload == nullptr) {
    fmt::print(stderr, "no workload '{}'; oblast_workload list names them\n", arguments.name);
    return 2;
  }
  write_workload(arguments.output, workload->make(arguments.size, arguments.seed));
  return 0;
}

}  // namespace
}  // namespace oblast::bench

int main(int argc, char** argv) {
  try {
    return oblast::bench::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "oblast_workload: {}\n", error.what());
    return 1;
  }
}
