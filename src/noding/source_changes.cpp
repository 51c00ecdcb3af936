#include "noding/source_changes.h"

#include <algorithm>

#include "base/index.h"

namespace oblast::internal::noding {
namespace {

std::uint64_t hash(std::span<const SourceChanges::Item> list) {
  std::uint64_t h = list.size();
  for (const SourceChanges::Item& item : list)
    h = (h ^ item.source ^ static_cast<std::uint64_t>(static_cast<std::uint32_t>(item.count)) << 32) *
        0x9e3779b97f4a7c15ULL;
  return h ^ h >> 29;
}

}  // namespace

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

std::int32_t SourceChanges::sum_of(std::int32_t p, std::int32_t q) {
  sum_.clear();
  const auto put = [&](std::uint32_t source, std::int32_t count) { sum_.push_back({source, count}); };
  for_each(p, put);
  for_each(q, put);
  std::sort(sum_.begin(), sum_.end(), [](const Item& x, const Item& y) { return x.source < y.source; });
  std::size_t kept = 0;
  for (const Item& item : sum_) {
    if (kept > 0 && sum_[kept - 1].source == item.source)
      sum_[kept - 1].count += item.count;
    else
      sum_[kept++] = item;
    if (sum_[kept - 1].count == 0) --kept;
  }
  sum_.resize(kept);
  if (sum_.empty()) return 0;
  // Of a list and its opposite, the one in the table begins with a positive count.
  const std::int32_t sign = sum_[0].count < 0 ? -1 : 1;
  for (Item& item : sum_) item.count *= sign;
  return sign * handle_of(sum_);
}

std::int32_t SourceChanges::handle_of(std::span<const Item> list) {
  if (list.size() == 1 && list[0].count == 1) return static_cast<std::int32_t>(list[0].source + 1);
  if (2 * (ends_.size() + 1) > slots_.size()) grow();
  std::uint64_t slot = hash(list);
  for (;; ++slot) {
    const std::uint32_t i = slots_[slot & (slots_.size() - 1)];
    if (i == none) break;
    if (std::ranges::equal(this->list(i), list)) return static_cast<std::int32_t>(source_count_ + 1 + i);
  }
  const std::uint32_t i =
      checked_index(ends_.size(), "combinations of rows that share an edge", most_chains - source_count_);
  items_.insert(items_.end(), list.begin(), list.end());
  ends_.push_back(checked_index(items_.size(), "rows that share edges"));
  slots_[slot & (slots_.size() - 1)] = i;
  return static_cast<std::int32_t>(source_count_ + 1 + i);
}

void SourceChanges::grow() {
  slots_.assign(std::max<std::size_t>(16, 2 * slots_.size()), none);
  for (std::uint32_t i = 0; i < ends_.size(); ++i) {
    std::uint64_t slot = hash(list(i));
    while (slots_[slot & (slots_.size() - 1)] != none) ++slot;
    slots_[slot & (slots_.size() - 1)] = i;
  }
}

}  // namespace oblast::internal::noding
