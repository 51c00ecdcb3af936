// Locator: one call a point, one call for all points on one thread, and on all cores.
#include <oblast/locator.h>

#include <optional>

#include "locate/contestant.h"

namespace oblast::bench {
namespace {

enum class Way { single_calls, one_thread, all_cores };

class WithOblast : public Contestant {
 public:
  explicit WithOblast(Way way) : way_(way) {}

  std::string name() const override {
    switch (way_) {
      case Way::single_calls:
        return "oblast, a call a point";
      case Way::one_thread:
        return "oblast, one call, 1 thread";
      case Way::all_cores:
        break;
    }
    return "oblast, one call, all cores";
  }
  std::string library() const override { return "oblast"; }
  bool on_all_cores() const override { return way_ == Way::all_cores; }
  void load(const RegionView& regions) override { regions_ = regions; }
  void build() override { locator_.emplace(regions_, options()); }
  void ask(std::span<const Point> points, std::span<std::uint8_t> inside) override {
    if (way_ == Way::single_calls) {
      for (std::size_t i = 0; i < points.size(); ++i) inside[i] = locator_->locate(points[i]) == Location::inside;
      return;
    }
    locations_.resize(points.size());
    locator_->locate(points, locations_, options());
    for (std::size_t i = 0; i < points.size(); ++i) inside[i] = locations_[i] == Location::inside;
  }

 private:
  CallOptions options() const {
    CallOptions options;
    options.threads = way_ == Way::all_cores ? 0 : 1;
    return options;
  }

  Way way_;
  RegionView regions_;
  std::optional<Locator> locator_;
  std::vector<Location> locations_;
};

}  // namespace

std::vector<std::unique_ptr<Contestant>> oblast_contestants() {
  std::vector<std::unique_ptr<Contestant>> result;
  for (const Way way : {Way::single_calls, Way::one_thread, Way::all_cores})
    result.push_back(std::make_unique<WithOblast>(way));
  return result;
}

}  // namespace oblast::bench
