// Part of every test program: lets oneTBB start eight threads, however few cores the machine has. Otherwise a test that
// asks for eight threads on two cores runs on two.
#include <tbb/global_control.h>

namespace {

const tbb::global_control eight_threads(tbb::global_control::max_allowed_parallelism, 8);

}  // namespace
