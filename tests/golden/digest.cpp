// XXH3 by the library of its author.
#include "golden/digest.h"

#include <bit>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace oblast::golden {

static_assert(std::endian::native == std::endian::little, "numbers are digested as they lie in memory");
static_assert(sizeof(Point) == 2 * sizeof(double));

struct Digest::State {
  XXH3_state_t* xxh3;
};

void Digest::Free::operator()(State* state) const {
  XXH3_freeState(state->xxh3);
  delete state;
}

Digest::Digest() : state_(new State{XXH3_createState()}) {
  if (state_->xxh3 == nullptr) throw std::bad_alloc();
  XXH3_64bits_reset(state_->xxh3);
}

void Digest::add_bytes(const void* bytes, std::size_t size) { XXH3_64bits_update(state_->xxh3, bytes, size); }

void Digest::add(std::uint64_t number) { add_bytes(&number, sizeof number); }

void Digest::add(std::span<const std::uint32_t> numbers) {
  add(numbers.size());
  add_bytes(numbers.data(), numbers.size_bytes());
}

void Digest::add(std::span<const Point> points) {
  add(points.size());
  add_bytes(points.data(), points.size_bytes());
}

void Digest::add(const RegionView& regions) {
  add(regions.points);
  add(regions.contour_ends);
  add(regions.polygon_ends);
}

std::uint64_t Digest::value() const { return XXH3_64bits_digest(state_->xxh3); }

}  // namespace oblast::golden
