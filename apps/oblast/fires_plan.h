// The parameters of the fires generator, by month. They are tuned so that the union resembles the paper's Table 3.
#pragma once

namespace oblast::app {

struct FirePlan {
  int month;
  double long_share;       ///< share of the contours that belong to fires seen tens of times
  double radius_km;        ///< largest radius of such a fire
  double density;          ///< chance that a pixel of a burning disc is detected
  double merged;           ///< chance that adjacent pixels in such a fire become one contour
  double patch_km;         ///< largest radius of a patch: a fire seen once to three times, its pixels merged
  double patch_density;    ///< as `density`, for patches
  double seen_twice;       ///< share of the small fires that are seen twice
  double seen_thrice;      ///< share of the small fires that are seen three times
  double flare_shares[2];  ///< share of the visible passes that see each of the two brightest gas flares
};

inline constexpr FirePlan fire_plans[] = {
    {4, 0.24, 4.0, 0.6, 0.1, 7, 0.58, 0.15, 0.06, {0.05, 0.30}},
    {5, 0.55, 5.0, 0.6, 0.1, 9, 0.52, 0.17, 0.10, {0.39, 0.10}},
    {6, 0.34, 5.0, 0.6, 0.1, 18, 0.5, 0.12, 0.12, {0.40, 0.10}},
    {7, 0.40, 4.0, 0.5, 0, 1, 0.5, 0.23, 0.15, {0.75, 0.2}},
    {9, 0.27, 4.0, 0.5, 0, 1, 0.5, 0.17, 0.14, {0.1, 0.81}},
    {10, 0.20, 4, 0.5, 0, 1, 0.5, 0.12, 0.11, {0.08, 0.56}},
};

inline constexpr double stray_pixels_dropped = 0.35;  ///< share of the single pixels beside a merged patch
inline constexpr int flare_count = 160;               ///< gas flares, mostly in Western Siberia
inline constexpr int fire_region_count = 70;          ///< regions with frequent fires, the same in every month
inline constexpr double fire_region_km = 400;         ///< approximate radius of such a region
inline constexpr double scattered_share = 0.1;        ///< share of the fires that are anywhere

}  // namespace oblast::app
