// Includes overlays, layers with rows, buffer and proximity zones, checks of results, triangulation, point-in-region
// queries, WKT and WKB. The papers' other algorithms have headers of their own: classics.h, hull.h, layers.h. The C
// interface is c.h.
#pragma once

#include <oblast/buffer.h>
#include <oblast/check.h>
#include <oblast/check_features.h>
#include <oblast/domain.h>
#include <oblast/error.h>
#include <oblast/features.h>
#include <oblast/locator.h>
#include <oblast/measure.h>
#include <oblast/options.h>
#include <oblast/overlay.h>
#include <oblast/point.h>
#include <oblast/region_builder.h>
#include <oblast/region_set.h>
#include <oblast/repair.h>
#include <oblast/triangulate.h>
#include <oblast/version.h>
#include <oblast/wkb.h>
#include <oblast/wkt.h>
#include <oblast/workspace.h>
#include <oblast/zones.h>
