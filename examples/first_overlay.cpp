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
  const oblast::RegionSet r = oblast::overlay(a, b, oblast::Operation::difference);
  // r.points: (0 0) (4 0) (4 2) (2 2) (2 4) (0 4)
  if (const auto fault = oblast::check(r).fault) std::puts(fault->message.c_str());  // closed, valid and canonical?

  print("difference", r);
  print("intersection", oblast::overlay(a, b, oblast::Operation::intersection));
  print("union", oblast::overlay(a, b, oblast::Operation::unite));
}
