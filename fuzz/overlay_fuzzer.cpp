// Overlay and unite: all operations, under every fill rule and convention, keep the promises a trial checks.
#include "bytes_to_operands.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  oblast::fuzz::Input input = oblast::fuzz::input_from(bytes, size);
  oblast::generators::Figures figures;
  if (const auto failure = run_trial(input.operands, input.request, figures)) oblast::fuzz::report(*failure, input);
  return 0;
}
