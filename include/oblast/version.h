// The version of the library: semantic versioning. Until 1.0.0 a minor version may change the interface.
#pragma once

#define OBLAST_VERSION_MAJOR 0
#define OBLAST_VERSION_MINOR 1
#define OBLAST_VERSION_PATCH 0

/// 10000 * major + 100 * minor + patch, for #if.
#define OBLAST_VERSION_NUMBER (10000 * OBLAST_VERSION_MAJOR + 100 * OBLAST_VERSION_MINOR + OBLAST_VERSION_PATCH)
