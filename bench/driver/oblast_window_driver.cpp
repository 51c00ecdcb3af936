// oblast's prepared clip window.
#include <oblast/classics.h>

#include "driver/driver.h"

namespace {

using namespace oblast;

struct PreparedWindow {
  static constexpr bool keeps_views = true;
  static std::string name() { return "oblast-window"; }
  static std::string version() { return OBLAST_VERSION; }

  struct Prepared {
    RegionView a;
    ClipWindow window;
  };

  explicit PreparedWindow(const bench::Settings& settings) {
    if (settings.operation != Operation::intersection) throw bench::Unsupported("clips only");
  }

  Prepared prepare(const RegionView& a, const RegionView& b) { return {a, ClipWindow(b)}; }

  void run(const Prepared& input, RegionSet& result) { result = input.window.clip(input.a); }
};

}  // namespace

int main(int argc, char** argv) { return bench::drive<PreparedWindow>(argc, argv); }
