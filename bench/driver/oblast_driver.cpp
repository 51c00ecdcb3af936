// The driver of oblast itself.
#include <oblast/oblast.h>

#include "driver/driver.h"

namespace {

using namespace oblast;

struct Ours {
  static constexpr bool keeps_views = true;  // the caller's arrays are the input
  static std::string name() { return "oblast"; }
  static std::string version() { return OBLAST_VERSION; }

  struct Prepared {
    RegionView a, b;
  };

  explicit Ours(const bench::Settings& settings) : settings_(settings) {
    options_.fill_a.kind = settings.fill;
    options_.fill_b.kind = settings.fill;
    options_.threads = settings.threads;
    static thread_local Workspace workspace;
    options_.workspace = &workspace;
  }

  Prepared prepare(const RegionView& a, const RegionView& b) { return {a, b}; }

  void run(const Prepared& input, RegionSet& result) {
    result = settings_.unary ? unite(input.a, options_) : overlay(input.a, input.b, settings_.operation, options_);
  }

 private:
  bench::Settings settings_;
  Options options_;
};

}  // namespace

int main(int argc, char** argv) { return bench::drive<Ours>(argc, argv); }
