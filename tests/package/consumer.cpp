// A program of somebody who only has the installed library.
#include <oblast/classics.h>
#include <oblast/hull.h>
#include <oblast/layers.h>
#include <oblast/oblast.h>
#include <oblast/version.h>

#include <cstdio>

int main() {
  const oblast::RegionSet a{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {4}, {1}};
  const oblast::RegionSet b{{{2, 2}, {6, 2}, {6, 6}, {2, 6}}, {4}, {1}};
  const oblast::RegionSet difference = oblast::overlay(a, b, oblast::Operation::difference);
  const bool right = oblast::signed_area(difference) == 12 && oblast::hull(difference).points.size() == 5 &&
                     oblast::layers(a).count == 1 && oblast::triangulate(a).triangles.size() == 2 &&
                     oblast::check(difference).is_valid();
  bool refused = false;
  try {
    const oblast::RegionSet bad{{{0, 0}, {1, 0}}, {3}, {1}};
    oblast::unite(bad);
  } catch (const oblast::Error& error) {  // an exception of the shared library
    refused = error.code() == oblast::ErrorCode::bad_offsets;
  }
  std::printf("oblast %d.%d.%d: %s\n", OBLAST_VERSION_MAJOR, OBLAST_VERSION_MINOR, OBLAST_VERSION_PATCH,
              right && refused ? "right" : "WRONG");
  return right && refused ? 0 : 1;
}
