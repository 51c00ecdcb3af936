// A run over hostile cases, block by block.
#include "properties/hostile_run.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "base/index_limits.h"
#include "generators/crowd.h"
#include "generators/random.h"

namespace oblast::generators {
namespace {

// Cases of a crowd: with some thirty edges each they pass every threshold of the library.
constexpr std::uint64_t crowd_size = 950;

int largest_small_case(const HostileSettings& settings, const HostileGenerator& generator) {
  return settings.largest > 0 ? settings.largest : generator.usual;
}

// Small cases more often than large ones, by the square of a number drawn evenly; a few very large, but not so large
// that a test build with low limits of indices refuses them.
int size_of_case(const HostileSettings& settings, const HostileGenerator& generator, std::uint64_t seed) {
  Random random(seed ^ 0x517eu);
  const double drawn = random.unit();
  const int largest = largest_small_case(settings, generator);
  const int very_large = internal::low_index_limits ? generator.larger : generator.largest;
  if (settings.large > 0 && random.one_in(settings.large))
    return random.between(largest, std::max(largest, very_large));
  return settings.smallest + static_cast<int>(drawn * drawn * std::max(1, largest - settings.smallest + 1));
}

class Run {
 public:
  Run(const HostileSettings& settings, const std::function<void(const FailedCase&)>& report)
      : settings_(settings), report_(report) {
    for (const HostileGenerator& generator : hostile_generators()) {
      if (settings.only.empty() || settings.only == generator.name) rows_.push_back({&generator, 0, {}, {}});
    }
    if (!rows_.empty()) seeds_of_a_block_ = (crowd_size + rows_.size() - 1) / rows_.size();
  }

  std::vector<HostileRow> run() {
    {
      std::vector<std::jthread> workers;
      const int threads = settings_.threads > 0 ? settings_.threads
                                                : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
      for (int t = 0; t < threads; ++t) workers.emplace_back([&] { work(); });
    }
    return std::move(rows_);
  }

 private:
  void work() {
    std::vector<HostileRow> rows = rows_without_figures();
    for (std::uint64_t first; (first = next_.fetch_add(seeds_of_a_block_)) < settings_.cases;)
      run_block(settings_.first_seed + first, std::min(seeds_of_a_block_, settings_.cases - first), rows);
    const std::lock_guard lock(mutex_);
    for (std::size_t g = 0; g < rows.size(); ++g) rows_[g].add(rows[g]);
  }

  std::vector<HostileRow> rows_without_figures() {
    const std::lock_guard lock(mutex_);
    std::vector<HostileRow> rows;
    for (const HostileRow& row : rows_) rows.push_back({row.generator, 0, {}, {}});
    return rows;
  }

  void run_block(std::uint64_t first_seed, std::uint64_t seeds, std::vector<HostileRow>& rows) {
    std::vector<CrowdMember> crowd;
    for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
      for (HostileRow& row : rows) run_case(row, seed, crowd);
    }
    const auto shrink = crowds_shown_ < settings_.show ? Shrink::yes : Shrink::no;
    const std::vector<CrowdFailure> failures = run_crowd(crowd, first_seed, shrink);
    if (!failures.empty()) ++crowds_shown_;
    for (const CrowdFailure& failure : failures) {
      const CrowdMember& member = crowd[failure.member];
      const auto row =
          std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.generator == member.generator; });
      fail(*row, {member.generator,
                  member.seed,
                  member.operands,
                  draw_request(member.seed),
                  {Broken::crowd, Operation::unite, failure.what}});
    }
  }

  void run_case(HostileRow& row, std::uint64_t seed, std::vector<CrowdMember>& crowd) {
    ++row.cases;
    Request request = draw_request(seed);
    request.far = true;
    request.against = settings_.against;
    request.other_engines |= settings_.engines;
    request.recompute |= settings_.recompute;
    request.patience = settings_.patience;
    const int size = size_of_case(settings_, *row.generator, seed);
    Operands operands;
    try {
      operands = row.generator->make(seed, size);
    } catch (const std::exception& e) {
      const std::string what = std::string("the generator: ") + e.what();
      return fail(row, {row.generator, seed, {}, request, {Broken::threw, Operation::unite, what}});
    }
    if (auto failure = run_trial(operands, request, row.figures))
      fail(row, {row.generator, seed, operands, request, std::move(*failure)});
    // Very large cases together may have more cuts than low limits of indices allow.
    if (!internal::low_index_limits || size <= largest_small_case(settings_, *row.generator))
      crowd.push_back({row.generator, seed, std::move(operands)});
  }

  void fail(HostileRow& row, const FailedCase& failed) {
    ++row.failed[static_cast<int>(failed.failure.broken)];
    const std::lock_guard lock(mutex_);
    report_(failed);
  }

  const HostileSettings& settings_;
  const std::function<void(const FailedCase&)>& report_;
  std::vector<HostileRow> rows_;
  std::uint64_t seeds_of_a_block_ = 1;
  std::atomic<std::uint64_t> next_{0}, crowds_shown_{0};
  std::mutex mutex_;
};

}  // namespace

std::uint64_t HostileRow::failures() const {
  std::uint64_t sum = 0;
  for (const std::uint64_t f : failed) sum += f;
  return sum;
}

void HostileRow::add(const HostileRow& other) {
  cases += other.cases;
  for (int i = 0; i < broken_count; ++i) failed[i] += other.failed[i];
  figures.rounds = std::max(figures.rounds, other.figures.rounds);
  figures.displacement_ulps = std::max(figures.displacement_ulps, other.figures.displacement_ulps);
}

std::vector<HostileRow> run_hostile(const HostileSettings& settings,
                                    const std::function<void(const FailedCase&)>& report) {
  return Run(settings, report).run();
}

}  // namespace oblast::generators
