// A million small overlays. One result is used again and again, and a workspace keeps the memory of the calls, so that
// after the first few a call allocates next to nothing.
#include <oblast/oblast.h>

#include <cstdio>

int main() {
  oblast::Workspace workspace;
  oblast::Options options;
  options.threads = 1;  // each call is small: run many calls side by side instead, each thread with a workspace
  options.workspace = &workspace;
  oblast::RegionSet a{{{0, 0}, {4, 1}, {3, 5}, {1, 4}, {-1, 2}}, {5}, {1}}, result;
  const oblast::RegionSet b{{{1, 1}, {5, 2}, {4, 6}, {2, 3}}, {4}, {1}};
  double area = 0;
  constexpr int calls = 1'000'000;
  for (int i = 0; i < calls; ++i) {
    a.points[2].x = 3 + 1e-6 * i;
    oblast::overlay(a, b, oblast::Operation::intersection, options, result);
    area += oblast::signed_area(result);
  }
  std::printf("mean area %.6f\n", area / calls);
}
