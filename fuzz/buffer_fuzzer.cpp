// Buffer zones: shapes drawn from the operands keep the promises that a hostile case checks.
#include <cstdio>
#include <cstdlib>

#include "buffer/buffer_trial.h"
#include "bytes_to_operands.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const oblast::fuzz::Input input = oblast::fuzz::input_from(bytes, size);
  const std::uint64_t seed = input.request.seed;
  const auto question = oblast::testing::draw_question(input.operands, seed);
  const auto failure = oblast::testing::run_buffer_trial(question, seed);
  if (!failure) return 0;
  std::printf("%s: %s\n  %s\n", oblast::testing::to_text(failure->broken), failure->what.c_str(),
              oblast::testing::to_text(question).c_str());
  std::abort();
}
