// Well-Known Text: written text reads back to the same bits, and text of anything other than polygons is refused.
#include <gtest/gtest.h>
#include <oblast/overlay.h>
#include <oblast/wkt.h>

#include <algorithm>
#include <memory>

#include "generators/hostile.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using verify::regions_of;

/// Reads from a block of exactly that size, so the address sanitizer detects reads past its end.
RegionSet read(std::string_view text) {
  const auto block = std::make_unique<char[]>(text.size());
  std::copy(text.begin(), text.end(), block.get());
  return read_wkt({block.get(), text.size()});
}

Error refusal(std::string_view text) {
  try {
    (void)read(text);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused: " << text;
  return {ErrorCode::bad_option, ""};
}

TEST(Wkt, isWrittenWithTheFewestDigits) {
  EXPECT_EQ(to_wkt(regions_of("0 0, 4 0, 0.1 3")), "POLYGON ((0 0, 4 0, 0.1 3, 0 0))");
  EXPECT_EQ(to_wkt(regions_of("0 0, 9 0, 9 9; 1 1, 1 2, 2 2 | 20 0, 21 0, 20 1")),
            "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 0), (1 1, 1 2, 2 2, 1 1)), ((20 0, 21 0, 20 1, 20 0)))");
  EXPECT_EQ(to_wkt(RegionSet{}), "MULTIPOLYGON EMPTY");
  EXPECT_EQ(to_wkt(RegionSet{{}, {0, 0}, {1, 2}}), "MULTIPOLYGON EMPTY");
  EXPECT_EQ(to_wkt(RegionSet{{{0, 0}, {1, 0}, {0, 1}}, {0, 3, 3}, {1, 3}}), "POLYGON ((0 0, 1 0, 0 1, 0 0))");
  const RegionSet set = regions_of("0 0, 4 0, 0 3 | 20 0, 21 0, 20 1");
  EXPECT_EQ(to_wkt(set.polygon(1)), "POLYGON ((20 0, 21 0, 20 1, 20 0))");
}

TEST(Wkt, hostileResultsReadBackToTheSameBits) {
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto [a, b] = generator.make(seed, generator.usual);
      for (const RegionSet& regions : {unite(a), overlay(a, b, Operation::symmetric_difference)}) {
        const std::string text = to_wkt(regions);
        EXPECT_EQ(read(text), regions) << generator.name;
        EXPECT_EQ(to_wkt(read(text)), text) << generator.name;
      }
    }
  }
}

TEST(Wkt, readsAllItsForms) {
  const RegionSet triangle = regions_of("0 0, 4 0, 0 3");
  for (const char* text : {
           "POLYGON((0 0,4 0,0 3,0 0))",
           "polygon((0 0,4 0,0 3))",
           "  Polygon\t(\n( 0   0 , +4 0 , 0 3e0 , 0 0 ) )  ;  ",
           "POLYGON Z ((0 0 1, 4 0 2, 0 3 3, 0 0 1))",
           "POLYGONZ ((0 0 1, 4 0 2, 0 3 3, 0 0 1))",
           "POLYGON M ((0 0 nan, 4 0 inf, 0 3 3))",
           "POLYGON ZM ((0 0 1 2, 4 0 2 3, 0 3 3 4))",
           "POLYGON ((0 0 1 2, 4 0 2 3, 0 3 3 4))",
           "SRID=4326;POLYGON ((0 0, 4 0, 0 3, 0 0))",
           "MULTIPOLYGON (EMPTY, ((0 0, 4 0, 0 3, 0 0), EMPTY))",
           "MULTIPOLYGON Z (((0 0 1, 4 0 2, 0 3 3)))",
           "GEOMETRYCOLLECTION (POLYGON EMPTY, MULTIPOLYGONZM EMPTY, POLYGON M ((0 0 1, 4 0 2, 0 3 3)))",
           "GEOMETRYCOLLECTION Z (GEOMETRYCOLLECTION (POLYGON ((.0 0., 40e-1 -0, 0 3))))",
       })
    EXPECT_EQ(read(text), triangle) << text;
  for (const char* text : {"POLYGON EMPTY", "POLYGON Z EMPTY", "MULTIPOLYGON EMPTY", "GEOMETRYCOLLECTION M EMPTY",
                           "MULTIPOLYGON (EMPTY, (EMPTY))"})
    EXPECT_TRUE(read(text).empty() && read(text).polygon_ends.empty()) << text;
}

TEST(Wkt, refusesTheRestWithItsPlace) {
  const std::pair<const char*, std::size_t> cases[] = {
      {"", 0},
      {"POINT (0 0)", 0},
      {"POLYGONAL ((0 0, 1 0, 0 1))", 0},
      {" CURVEPOLYGON EMPTY", 1},
      {"POLYGON", 7},
      {"POLYGON ()", 9},
      {"POLYGON (())", 10},
      {"POLYGON ((0))", 11},
      {"POLYGON ((0 0 1 2 3))", 18},
      {"POLYGON ((0 0, 4 0, 4 4 0 4))", 24},  // a comma is missing
      {"POLYGON ((0 0 1, 4 0 1, 4 4))", 27},
      {"POLYGON Z ((0 0, 1 1, 2 2))", 15},
      {"POLYGON ZM ((0 0 1, 1 1, 2 2))", 18},
      {"POLYGON ((0 0, 1 x))", 17},
      {"POLYGON ((0 0, 1 2x))", 17},
      {"POLYGON ((0 0, 1 +-2))", 17},
      {"POLYGON ((0 0, 1 0x10))", 17},
      {"POLYGON ((0 0, 1 0)", 19},
      {"POLYGON ((0 0, 1 0)) POLYGON EMPTY", 21},
      {"MULTIPOLYGON ((0 0, 1 0, 0 1))", 15},
      {"MULTIPOLYGON (POLYGON EMPTY)", 14},
      {"GEOMETRYCOLLECTION (POINT (1 1))", 20},
      {"SRID=;POLYGON EMPTY", 5},
      {"SRID=4326 POLYGON EMPTY", 10},
  };
  for (const auto& [text, byte] : cases) {
    const Error error = refusal(text);
    EXPECT_EQ(error.code(), ErrorCode::bad_wkt) << text;
    EXPECT_EQ(error.place().byte, byte) << text;
  }
  const auto code = [](const char* text) { return refusal(text).code(); };
  EXPECT_EQ(code("POLYGON ((nan 0, 1 0, 0 1))"), ErrorCode::not_finite);
  EXPECT_EQ(code("POLYGON ((0 0, inf 0, 0 1))"), ErrorCode::not_finite);
  EXPECT_EQ(code("POLYGON ((0 0, 1e91 0, 0 1))"), ErrorCode::out_of_domain);
  EXPECT_EQ(code("POLYGON ((0 0, 1e400 0, 0 1))"), ErrorCode::out_of_domain);
  EXPECT_EQ(refusal("POLYGON ((0 0, 1 1e-400, 0 1))").place().byte, 17u);
}

TEST(Wkt, refusesCollectionsThatAreTooDeep) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "GEOMETRYCOLLECTION(";
    return text + "POLYGON EMPTY" + std::string(static_cast<std::size_t>(depth), ')');
  };
  EXPECT_TRUE(read(nested(64)).empty());
  EXPECT_EQ(refusal(nested(65)).code(), ErrorCode::bad_wkt);
  EXPECT_EQ(refusal(nested(100000)).code(), ErrorCode::bad_wkt);
}

TEST(Wkt, everyPrefixIsRefused) {
  const std::string all =
      "SRID=1;GEOMETRYCOLLECTION(POLYGON Z((0 0 1,4 0 1,0 3 1)),MULTIPOLYGON(((0 0,1 0,0 1)),EMPTY))";
  EXPECT_EQ(read(all).polygon_ends.size(), 2u);
  for (std::size_t size = 0; size < all.size(); ++size)
    EXPECT_EQ(refusal(std::string_view(all).substr(0, size)).code(), ErrorCode::bad_wkt) << size;
}

TEST(Wkt, changedCharactersAreReadOrRefused) {
  std::string text = "MULTIPOLYGON Z (((0 0 1, 4.5e0 0 1, 0 3 1)), EMPTY)";
  for (char& c : text) {
    const char kept = c;
    for (int value = 0; value < 256; ++value) {
      c = static_cast<char>(value);
      try {
        const RegionSet set = read(text);
        EXPECT_EQ(read(to_wkt(set)), set);
      } catch (const Error& error) {
        EXPECT_NE(error.place().byte, Place::npos);
      }
    }
    c = kept;
  }
}

}  // namespace
}  // namespace oblast::internal
