// Regions from WKT and WKB, as databases and GIS libraries give them, and the result as WKB. Bad input says where.
#include <oblast/oblast.h>

#include <cstdio>

int main() {
  const oblast::RegionSet lake = oblast::read_wkt("POLYGON ((0 0, 8 0, 8 6, 0 6, 0 0), (3 2, 3 4, 5 4, 5 2, 3 2))");
  const std::vector<std::byte> stored = oblast::to_wkb(lake);  // as a column of a database
  const oblast::RegionSet again = oblast::read_wkb(stored);
  const oblast::RegionSet east = oblast::overlay(again, oblast::read_wkt("POLYGON ((4 -1, 9 -1, 9 7, 4 7, 4 -1))"),
                                                 oblast::Operation::intersection);
  std::printf("%zu bytes of WKB, %s\n", stored.size(), oblast::to_wkt(east).c_str());
  try {
    oblast::read_wkt("POLYGON ((0 0, 1 0, 1 x, 0 0))");
  } catch (const oblast::Error& error) {
    std::printf("refused: %s\n", error.what());
  }
}
