#include "noding/source_changes.h"

#include <cstdlib>

#include "base/index.h"

namespace oblast::internal::noding {

SourceChanges::SourceChanges(std::size_t source_count)
    : source_count_(checked_index(source_count, "rows in one operand", most_chains)) {}

std::int32_t SourceChanges::add(std::int32_t p, std::int32_t q) {
  if (p == -q) return 0;
  if (p == 0) return q;
  if (q == 0) return p;
  const std::lock_guard lock(mutex_);
  if (p != last_p_ || q != last_q_) {
    last_sum_ = sum_of(p, q);
    last_p_ = p;
    last_q_ = q;
  }
  return last_sum_;
}

SourceSets::Set SourceChanges::set_of(std::uint32_t number) {
  if (number <= source_count_) return sets_.changed(SourceSets::empty, number - 1, 1);
  if (number < first_pair) return number - source_count_;
  const Pair pair = pairs_[number - first_pair];
  return sets_.changed(sets_.changed(SourceSets::empty, pair.more, 1), pair.less, -1);
}

std::int32_t SourceChanges::add_pair(std::uint32_t more, std::uint32_t less) {
  check_count(pairs_.size() + 1, "borders between rows", 0x7fffffff - first_pair);
  pairs_.push_back({more, less});
  return static_cast<std::int32_t>(first_pair + (pairs_.size() - 1));
}

std::int32_t SourceChanges::sum_of(std::int32_t p, std::int32_t q) {
  const SourceSets::Set of_p = set_of(static_cast<std::uint32_t>(std::abs(p)));
  const SourceSets::Set of_q = set_of(static_cast<std::uint32_t>(std::abs(q)));
  // Turned as p is.
  const SourceSets::Set sum = (p < 0) == (q < 0) ? sets_.sum(of_p, of_q) : sets_.difference(of_p, of_q);
  if (sum == SourceSets::empty) return 0;
  std::int32_t handle = 0;
  if (sets_.size(sum) == 1)
    sets_.for_each_count(sum, [&](std::uint32_t source, std::int32_t count) {
      if (std::abs(count) == 1) handle = count * static_cast<std::int32_t>(source + 1);
    });
  if (handle == 0) {
    check_count(std::size_t{sum} + source_count_, "rows, and sets of rows that share an edge", first_pair - 1);
    handle = static_cast<std::int32_t>(sum + source_count_);
  }
  return p < 0 ? -handle : handle;
}

}  // namespace oblast::internal::noding
