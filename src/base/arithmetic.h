// Checks what exact arithmetic requires of the compiler: every operation has the precision of its type, and is rounded
// separately.
//
// The preprocessor cannot test whether multiplications are fused with additions; src/CMakeLists.txt sets
// -ffp-contract=off.
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
