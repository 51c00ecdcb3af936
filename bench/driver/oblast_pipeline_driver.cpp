// oblast without its fast paths: with statistics, every overlay runs all stages of the pipeline.
#include <oblast/oblast.h>

#include "driver/driver.h"

namespace {

using namespace oblast;

struct Pipeline {
  static constexpr bool keeps_views = true;
  static std::string name() { return "oblast-pipeline"; }
  static std::string version() { return OBLAST_VERSION; }

  struct Prepared {
    RegionView a, b;
  };

  explicit Pipeline(const bench::Settings& settings) : settings_(settings) {
    if (settings.unary) throw bench::Unsupported("a union has no fast path");
  }

  Prepared prepare(const RegionView& a, const RegionView& b) { return {a, b}; }

  void run(const Prepared& input, RegionSet& result) {
    Statistics statistics;
    Options options;
    options.fill_a.kind = options.fill_b.kind = settings_.fill;
    options.threads = settings_.threads;
    options.statistics = &statistics;
    result = overlay(input.a, input.b, settings_.operation, options);
  }

 private:
  bench::Settings settings_;
};

}  // namespace

int main(int argc, char** argv) { return bench::drive<Pipeline>(argc, argv); }
