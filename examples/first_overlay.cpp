// What two squares have in common, what only the first has, and their union.
#include <oblast/oblast.h>

#include <cstdio>

void print(const char* name, const oblast::RegionSet& regions) {
  std::printf("%s:\n", name);
  for (const auto polygon : regions.polygons()) {
    for (const auto contour : polygon.contours()) {
      for (const oblast::Point& p : contour) std::printf(" (%g %g)", p.x, p.y);
      std::printf("\n");
    }
  }
}

int main() {
  // Points, where each contour ends in them, and where each polygon ends in the contours.
  const oblast::RegionSet a{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {4}, {1}};
  const oblast::RegionSet b{{{2, 2}, {6, 2}, {6, 6}, {2, 6}}, {4}, {1}};
  print("intersection", oblast::overlay(a, b, oblast::Operation::intersection));
  print("difference", oblast::overlay(a, b, oblast::Operation::difference));
  print("union", oblast::overlay(a, b, oblast::Operation::unite));
}
