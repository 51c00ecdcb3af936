// What exact arithmetic needs of the compiler: every operation in the precision of its type, rounded on its own.
//
// That no multiplication is fused with an addition cannot be asked here: src/CMakeLists.txt says -ffp-contract=off.
#pragma once

#include <cfloat>
#include <limits>

#if defined(__FAST_MATH__)
#error "oblast must not be built with -ffast-math: it breaks exact arithmetic"
#endif
#if FLT_EVAL_METHOD != 0
#error "oblast needs arithmetic in the precision of its type (on 32-bit x86: -msse2 -mfpmath=sse)"
#endif

static_assert(std::numeric_limits<double>::is_iec559, "oblast needs IEEE doubles");
