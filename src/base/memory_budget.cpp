#include "base/memory_budget.h"

#include <oblast/error.h>

#include <string>

namespace oblast::internal {

void MemoryBudget::refuse(std::size_t bytes) {
  give_back(bytes);
  throw Error(ErrorCode::memory_limit, "the call needs more memory than its limit of " + std::to_string(most_bytes_) +
                                           " bytes; raise the limit, or divide the input");
}

}  // namespace oblast::internal
