#include "base/control.h"

#include "base/call.h"

namespace oblast::internal {

bool Control::answer(double fraction) const {
  const WorkingForCaller caller(callers_);
  return progress_(stage_.load(std::memory_order_relaxed), fraction);
}

}  // namespace oblast::internal
