/* A C program of somebody who only has the installed library. */
#include <oblast/c.h>
#include <stdio.h>

int main(void) {
  const double a_points[] = {0, 0, 4, 0, 4, 4, 0, 4}, b_points[] = {2, 2, 6, 2, 6, 6, 2, 6};
  const uint32_t ends[] = {4};
  const oblast_view a = {a_points, 4, ends, 1, NULL, 0}, b = {b_points, 4, ends, 1, NULL, 0};
  oblast_regions* result = NULL;
  oblast_error error;
  if (oblast_overlay(&a, &b, OBLAST_DIFFERENCE, NULL, &result, &error) != OBLAST_OK) {
    printf("oblast: %s\n", error.message);
    return 1;
  }
  const oblast_view difference = oblast_regions_view(result);
  const int right = oblast_signed_area(&difference, NULL) == 12 && difference.point_count == 6;
  oblast_regions_free(result);
  const uint32_t wrong_ends[] = {5};
  const oblast_view bad = {a_points, 4, wrong_ends, 1, NULL, 0};
  const int refused = oblast_unite(&bad, NULL, &result, &error) == OBLAST_BAD_OFFSETS && result == NULL;
  printf("oblast %d: %s\n", oblast_version(), right && refused ? "right" : "WRONG");
  return right && refused ? 0 : 1;
}
