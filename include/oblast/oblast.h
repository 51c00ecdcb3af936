// The whole public interface of oblast.
#pragma once

#include <oblast/domain.h>
#include <oblast/error.h>
#include <oblast/options.h>
#include <oblast/overlay.h>
#include <oblast/point.h>
#include <oblast/region_set.h>
#include <oblast/triangulate.h>
#include <oblast/workspace.h>
