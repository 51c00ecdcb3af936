// The noded chains of two operands, for tests of single steps of the engine.
#pragma once

#include <oblast/options.h>

#include "generators/hostile.h"
#include "support/noded.h"

namespace oblast::testing {
using namespace internal;

inline ChainGraph arrangement_of(const generators::Operands& operands, const Options& options) {
  const RegionView b = operands.b;
  return graph_of(operands.a, &b, options);
}

}  // namespace oblast::testing
