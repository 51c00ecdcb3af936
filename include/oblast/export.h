// What a shared library of oblast exports: everything else of it is hidden.
#pragma once

#if defined(__GNUC__)
#define OBLAST_API __attribute__((visibility("default")))
#else
#define OBLAST_API
#endif
