// Rows: every operation on layers cut from the operands keeps the promises that can be checked quickly.
#include <cstdio>
#include <cstdlib>

#include "bytes_to_operands.h"
#include "features/row_trial.h"
#include "generators/wkt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const oblast::fuzz::Input input = oblast::fuzz::input_from(bytes, size);
  const auto failure = oblast::testing::run_row_trial(input.operands, input.request.seed, false);
  if (!failure) return 0;
  std::printf("%s in %s: %s\n  A %s\n  B %s\n", oblast::testing::to_text(failure->broken), failure->operation.c_str(),
              failure->what.c_str(), oblast::generators::soup_to_wkt(input.operands.a).c_str(),
              oblast::generators::soup_to_wkt(input.operands.b).c_str());
  std::abort();
}
