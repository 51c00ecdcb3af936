// Marks what the shared library exports. Everything else in it is hidden.
#pragma once

#if defined(__GNUC__)
#define OBLAST_API __attribute__((visibility("default")))
#else
#define OBLAST_API
#endif
