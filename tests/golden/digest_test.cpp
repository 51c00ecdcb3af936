// The digest is XXH3 as published, and sees every bit.
#include "golden/digest.h"

#include <gtest/gtest.h>

#include "golden/digest_file.h"

namespace oblast::golden {
namespace {

TEST(Digest, isXxh3) {
  // The author's own test vector: XXH3_64bits of no bytes with seed 0.
  EXPECT_EQ(Digest().value(), 0x2D06800538D394C2u);
  // Eight bytes of value 0, by xxhsum -H3 of xxHash 0.8.1.
  Digest zero;
  zero.add(std::uint64_t{0});
  EXPECT_EQ(zero.value(), 0xc77b3abb6f87acd9u);
}

TEST(Digest, seesSignsOfZeroOffsetsAndLengths) {
  const auto digest = [](const RegionSet& regions) {
    Digest d;
    d.add(regions);
    return d.value();
  };
  const RegionSet triangle{{{0, 0}, {1, 0}, {0, 1}}, {3}, {1}};
  EXPECT_EQ(digest(triangle), digest(RegionSet(triangle)));
  RegionSet other = triangle;
  other.points[0].y = -0.0;
  EXPECT_NE(digest(triangle), digest(other));
  EXPECT_NE(digest(triangle), digest({triangle.points, {2, 3}, {1}}));
  EXPECT_NE(digest(triangle), digest({triangle.points, {3}, {}}));
  EXPECT_NE(digest({{}, {1, 2}, {}}), digest({{}, {1}, {2}}));
}

TEST(DigestFile, readsWhatItWrites) {
  const Digests digests{{"fans 1", {0x1234abcd00000001u, 0xffffffffffffffffu}}, {"geos/a case", {0, 7}}};
  EXPECT_EQ(parse_digests(to_text(digests)), digests);
  EXPECT_THROW(parse_digests("fans 1 1234\n"), std::runtime_error);
  EXPECT_THROW(parse_digests("fans 1 zz 00\n"), std::runtime_error);
}

}  // namespace
}  // namespace oblast::golden
