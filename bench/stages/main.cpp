// oblast_stages: in-process benchmarks of the pipeline (Google Benchmark).
//
//   stage/NAME/INPUT            one stage of the pipeline, with its time from Options::statistics; one thread
//   whole/INPUT/threads:T       the whole call, as a user makes it
//   growth/KIND/EDGES           the same from 10^4 to 10^6 edges; one thread
//
//   oblast_stages [--benchmark_filter=REGEX ...] [WORKLOAD_FILE...]      files (oblast_workload) are inputs as well
//
// An input of many pairs is processed call by call. Items per second are edges of the input. For a stage, the column of
// processor time has no meaning.
#include <benchmark/benchmark.h>
#include <oblast/oblast.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "workloads/workloads.h"

namespace oblast::bench {
namespace {

using StageSeconds = std::array<double, stage_count>;

/// A workload, made when it is first needed. So a filtered run makes only the workloads that it measures.
class Input {
 public:
  Input(std::string name, std::function<Workload()> make) : name_(std::move(name)), make_(std::move(make)) {}

  const std::string& name() const { return name_; }

  const Workload& workload() {
    if (workload_.pairs() == 0) workload_ = make_();
    return workload_;
  }

  std::int64_t edges() {
    return static_cast<std::int64_t>(workload().a.arrays.points.size() + workload().b.arrays.points.size());
  }

  /// The times of the call with that number. All stages share the calls, so their times add up to that of the pipeline.
  const StageSeconds& stage_seconds(std::size_t call);

 private:
  std::string name_;
  std::function<Workload()> make_;
  Workload workload_;
  std::vector<StageSeconds> calls_;
};

/// Overlays every pair of the workload. With `stages`, adds up the statistics of the pipeline by stage.
void call(const Workload& workload, int threads, StageSeconds* stages) {
  Statistics statistics;
  Options options;
  options.fill_a.kind = options.fill_b.kind = workload.fill;
  options.threads = threads;
  if (stages) options.statistics = &statistics;
  const bool unary = workload.b.arrays.points.empty();
  for (std::size_t i = 0; i < workload.pairs(); ++i) {
    const RegionView a = workload.a.pair(i);
    benchmark::DoNotOptimize(unary ? unite(a, options) : overlay(a, workload.b.pair(i), workload.operation, options));
    if (!stages) continue;
    for (std::size_t stage = 0; stage < stage_count; ++stage) (*stages)[stage] += statistics.seconds[stage];
  }
}

const StageSeconds& Input::stage_seconds(std::size_t number) {
  while (calls_.size() <= number) {
    StageSeconds seconds = {};
    call(workload(), 1, &seconds);
    calls_.push_back(seconds);
  }
  return calls_[number];
}

void measure_stage(benchmark::State& state, Input& input, std::size_t stage, std::size_t& next_call) {
  for ([[maybe_unused]] auto run : state) state.SetIterationTime(input.stage_seconds(next_call++)[stage]);
  state.SetItemsProcessed(state.iterations() * input.edges());
}

void measure_whole(benchmark::State& state, Input& input, int threads) {
  const Workload& workload = input.workload();
  for ([[maybe_unused]] auto run : state) call(workload, threads, nullptr);
  state.SetItemsProcessed(state.iterations() * input.edges());
  state.SetComplexityN(input.edges());
}

void register_input(const std::shared_ptr<Input>& input, std::initializer_list<int> thread_counts) {
  constexpr const char* stage_names[stage_count] = {"collect", "node", "label", "select", "link", "assemble"};
  for (std::size_t stage = 0; stage < stage_count; ++stage) {
    const auto measure = [input, stage, next_call = std::size_t{0}](benchmark::State& state) mutable {
      measure_stage(state, *input, stage, next_call);
    };
    // An iteration is a whole call. Their number is fixed; otherwise a short stage would be repeated for minutes.
    benchmark::RegisterBenchmark(("stage/" + std::string(stage_names[stage]) + "/" + input->name()).c_str(), measure)
        ->UseManualTime()
        ->Iterations(5)
        ->Unit(benchmark::kMillisecond);
  }
  for (const int threads : thread_counts) {
    benchmark::RegisterBenchmark(("whole/" + input->name() + "/threads:" + std::to_string(threads)).c_str(),
                                 [input, threads](benchmark::State& state) { measure_whole(state, *input, threads); })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

/// `size` returns the SIZE of the generator for a total number of edges in both operands.
void register_growth(const NamedWorkload& kind, std::uint32_t (*size)(std::int64_t edges)) {
  benchmark::RegisterBenchmark(("growth/" + std::string(kind.name)).c_str(),
                               [kind, size](benchmark::State& state) {
                                 Input input(kind.name, [&] { return kind.make(size(state.range(0)), 1); });
                                 measure_whole(state, input, 1);
                               })
      ->RangeMultiplier(10)
      ->Range(10'000, 1'000'000)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond)
      ->Complexity(benchmark::oNLogN);
}

void register_all(int files, char** paths) {
  const auto generated = [](const char* name, std::uint32_t size) {
    const NamedWorkload& kind = *find_workload(name);
    return std::make_shared<Input>(std::string(name) + "-" + std::to_string(size),
                                   [kind, size] { return kind.make(size, 1); });
  };
  register_input(generated("stars", 100'000), {1, 2});  // long chains, few meetings
  register_input(generated("crossing", 500), {1, 2});   // meetings and nothing else
  register_input(generated("slabs", 200), {1, 2});      // long edges that each meet all of the other operand
  register_input(generated("coverage", 60), {1, 2});    // shared borders, holes filled and not
  register_input(generated("pairs", 10'000), {1});      // calls so small that they are never divided
  for (int i = 0; i < files; ++i) {
    const std::string path = paths[i];
    const std::string name = path.substr(path.rfind('/') + 1);
    register_input(std::make_shared<Input>(name, [path] { return read_workload(path); }), {1, 2});
  }
  register_growth(*find_workload("stars"), [](std::int64_t n) { return static_cast<std::uint32_t>(n / 2); });
  register_growth(*find_workload("checkerboard"), [](std::int64_t n) {  // as many meetings as squares
    return static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n) / 8)));
  });
}

}  // namespace
}  // namespace oblast::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  oblast::bench::register_all(argc - 1, argv + 1);
  try {
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "oblast_stages: %s\n", error.what());
    return 1;
  }
  return 0;
}
