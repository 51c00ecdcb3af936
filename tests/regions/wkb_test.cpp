// Well-Known Binary: written bytes read back, and any other bytes are refused without harm.
#include <gtest/gtest.h>
#include <oblast/overlay.h>
#include <oblast/wkb.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>

#include "generators/hostile.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using Bytes = std::vector<std::byte>;
using verify::regions_of;

/// Writes bytes by hand, in either order.
class Maker {
 public:
  explicit Maker(bool little = true) : little_(little) {}

  Maker& order(int value = -1) {
    bytes.push_back(static_cast<std::byte>(value < 0 ? static_cast<int>(little_) : value));
    return *this;
  }
  template <class T>
  Maker& add(T value) {
    std::array<std::byte, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    if (little_ != (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
    for (const std::byte byte : raw) bytes.push_back(byte);
    return *this;
  }
  Maker& words(std::initializer_list<std::uint32_t> values) {
    for (const std::uint32_t value : values) add(value);
    return *this;
  }
  Maker& doubles(std::initializer_list<double> values) {
    for (const double value : values) add(value);
    return *this;
  }
  Maker& geometry(std::initializer_list<std::uint32_t> values) { return order().words(values); }

  Bytes bytes;

 private:
  bool little_;
};

/// Reads from a block of exactly that size, so the address sanitizer detects reads past its end.
RegionSet read(const Bytes& bytes) {
  const auto block = std::make_unique<std::byte[]>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), block.get());
  return read_wkb({block.get(), bytes.size()});
}

Error refusal(const Bytes& bytes) {
  try {
    (void)read(bytes);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return {ErrorCode::bad_option, ""};
}

RegionSet filled(const RegionView& regions) {
  RegionSet result;
  for (const PolygonView polygon : regions.polygons()) {
    const std::size_t before = result.contour_ends.size();
    for (const std::span<const Point> contour : polygon.contours()) {
      if (contour.empty()) continue;
      result.points.insert(result.points.end(), contour.begin(), contour.end());
      result.contour_ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    }
    if (result.contour_ends.size() > before)
      result.polygon_ends.push_back(static_cast<std::uint32_t>(result.contour_ends.size()));
  }
  return result;
}

RegionSet sample() { return regions_of("0 0, 9 0, 9 9, 0 9; 1 1, 1 2, 2 2 | 20 0, 21 0, 20 1"); }

TEST(Wkb, hostileRegionsReadBack) {
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto [a, b] = generator.make(seed, generator.usual);
      for (const RegionSet& regions : {a, b, unite(a)})
        EXPECT_EQ(read(to_wkb(regions)), filled(regions)) << generator.name;
    }
  }
}

TEST(Wkb, aPartIsWrittenWithoutTheRest) {
  const RegionSet set = sample();
  EXPECT_EQ(read(to_wkb(set.polygon(1))), regions_of("20 0, 21 0, 20 1"));
  EXPECT_EQ(to_wkb(RegionSet{}), Maker().geometry({6, 0}).bytes);
  EXPECT_TRUE(read(to_wkb(RegionSet{})).empty());
  EXPECT_EQ(to_wkb(regions_of("0 0, 4 0, 0 3")), Maker().geometry({3, 1, 4}).doubles({0, 0, 4, 0, 0, 3, 0, 0}).bytes);
}

TEST(Wkb, bothByteOrdersAndAllDimensions) {
  constexpr std::uint32_t z = 0x80000000, m = 0x40000000, srid = 0x20000000;
  const RegionSet triangle = regions_of("0 0, 4 0, 0 3");
  for (const bool little : {true, false}) {
    for (const std::uint32_t code : {1003u, 2003u, 3 | z, 3 | m, 3 | z | srid, 3 | m | srid}) {
      Maker maker(little);
      maker.geometry({code});
      if (code & srid) maker.words({4326});
      maker.words({1, 4}).doubles({0, 0, NAN, 4, 0, 5, 0, 3, INFINITY, 0, 0, 7});
      EXPECT_EQ(read(maker.bytes), triangle) << code;
    }
    for (const std::uint32_t code : {3003u, 3 | z | m}) {
      Maker maker(little);
      maker.geometry({code, 1, 3}).doubles({0, 0, 1, 2, 4, 0, 1, 2, 0, 3, 1, 2});
      EXPECT_EQ(read(maker.bytes), triangle) << code;
    }
  }
}

TEST(Wkb, collectionsMixedOrdersAndEmptyParts) {
  const auto append = [](Bytes& to, const Bytes& from) { to.insert(to.end(), from.begin(), from.end()); };
  Bytes bytes = Maker(false).geometry({7, 5}).bytes;
  append(bytes, to_wkb(regions_of("0 0, 9 0, 9 9, 0 9; 1 1, 1 2, 2 2")));  // little endian in a big one
  append(bytes, Maker().geometry({7, 0}).bytes);
  append(bytes, Maker(false).geometry({3, 0}).bytes);
  append(bytes, Maker(false).geometry({3, 2, 0, 0}).bytes);
  append(bytes, Maker().geometry({1006, 1}).geometry({1003, 1, 3}).doubles({20, 0, 1, 21, 0, 1, 20, 1, 1}).bytes);
  EXPECT_EQ(read(bytes), sample());
}

TEST(Wkb, refusesOtherTypes) {
  EXPECT_EQ(refusal(Maker().geometry({1}).doubles({0, 0}).bytes).code(), ErrorCode::bad_wkb);
  for (const std::uint32_t type : {0u, 2u, 4u, 5u, 8u, 15u, 17u, 4003u, 0x10000003u})
    EXPECT_EQ(refusal(Maker().geometry({type, 0}).bytes).place().byte, 1u) << type;
  EXPECT_EQ(refusal(Maker().geometry({6, 1}).geometry({7, 0}).bytes).place().byte, 10u);
  EXPECT_EQ(refusal(Maker().order(2).words({3, 0}).bytes).place().byte, 0u);
  EXPECT_EQ(refusal(Maker().geometry({3, 0}).order().bytes).place().byte, 9u);
  EXPECT_EQ(refusal({}).code(), ErrorCode::bad_wkb);
}

TEST(Wkb, refusesCountsThatTheBytesCannotHold) {
  for (const std::uint32_t count : {0xffffffffu, 0x7fffffffu, 0x10000000u, 3u}) {
    for (const std::uint32_t type : {3u, 6u, 7u, 1003u}) {
      const Error error = refusal(Maker().geometry({type, count, 0, 0}).bytes);
      EXPECT_EQ(error.code(), ErrorCode::bad_wkb);
      EXPECT_EQ(error.place().byte, 5u);
    }
    EXPECT_EQ(refusal(Maker().geometry({3, 1, count}).doubles({0}).bytes).place().byte, 9u);
  }
}

TEST(Wkb, refusesCollectionsThatAreTooDeep) {
  const auto nested = [](int depth) {
    Maker maker;
    for (int i = 0; i < depth; ++i) maker.geometry({7, 1});
    maker.geometry({3, 0});
    return maker.bytes;
  };
  EXPECT_TRUE(read(nested(64)).empty());
  EXPECT_EQ(refusal(nested(65)).code(), ErrorCode::bad_wkb);
  EXPECT_EQ(refusal(nested(1000000)).code(), ErrorCode::bad_wkb);
}

TEST(Wkb, coordinatesAreCheckedWithTheirPlace) {
  const auto with = [](double x) { return Maker().geometry({3, 1, 3}).doubles({0, 0, 4, x, 0, 3}).bytes; };
  EXPECT_EQ(refusal(with(NAN)).code(), ErrorCode::not_finite);
  EXPECT_EQ(refusal(with(1e91)).code(), ErrorCode::out_of_domain);
  EXPECT_EQ(refusal(with(-INFINITY)).place().byte, 13u + 3 * 8);
}

TEST(Wkb, everyPrefixIsRefused) {
  for (const RegionSet& set : {sample(), regions_of("0 0, 4 0, 0 3")}) {
    const Bytes all = to_wkb(set);
    for (std::size_t size = 0; size < all.size(); ++size) {
      const Error error = refusal(Bytes(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(size)));
      EXPECT_EQ(error.code(), ErrorCode::bad_wkb) << size;
      EXPECT_LE(error.place().byte, size);
    }
  }
}

TEST(Wkb, changedBytesAreReadOrRefused) {
  Bytes bytes = to_wkb(sample());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::byte kept = bytes[i];
    for (int value = 0; value < 256; ++value) {
      bytes[i] = static_cast<std::byte>(value);
      try {
        const RegionSet set = read(bytes);
        EXPECT_EQ(read(to_wkb(set)), set);
      } catch (const Error& error) {
        EXPECT_NE(error.place().byte, Place::npos);
      }
    }
    bytes[i] = kept;
  }
}

TEST(Wkb, keepsToItsMemoryLimit) {
  RegionSet large;
  for (int i = 0; i < 100000; ++i) large.points.push_back({static_cast<double>(i), 1});
  large.contour_ends = {100000};
  const Bytes bytes = to_wkb(large);
  CallOptions options;
  options.most_bytes = 100000;
  for (const bool writes : {false, true}) {
    try {
      if (writes)
        (void)to_wkb(large, options);
      else
        (void)read_wkb(bytes, options);
      FAIL() << "more than the limit was used";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::memory_limit);
    }
  }
  options.most_bytes = 10000000;
  EXPECT_EQ(read_wkb(bytes, options).points, large.points);
  options.progress = [](Stage, double) { return false; };
  EXPECT_THROW((void)read_wkb(bytes, options), Error);
}

}  // namespace
}  // namespace oblast::internal
