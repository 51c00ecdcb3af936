// Overlays and triangulation, with all they need. The papers' other algorithms have headers of their own: classics.h,
// hull.h, layers.h.
#pragma once

#include <oblast/domain.h>
#include <oblast/error.h>
#include <oblast/options.h>
#include <oblast/overlay.h>
#include <oblast/point.h>
#include <oblast/region_set.h>
#include <oblast/triangulate.h>
#include <oblast/workspace.h>
