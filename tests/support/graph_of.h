// Stages 1 to 5 alone, for tests of the later ones.
#pragma once

#include <oblast/overlay.h>

#include <string>

#include "result/link.h"
#include "result/rings.h"
#include "result/select.h"
#include "support/noded.h"

namespace oblast::testing {
using namespace internal;

/// A drawing of a question: two operands (verify/text_regions.h), what to do with them.
struct Question {
  std::string a, b;
  Operation operation = Operation::unite;
  Options options = {};
};

struct Linked {
  ChainGraph graph;
  Selection selection;
  LinkedContours contours;
  Rings rings;
};

/// Everything up to the rings of the result.
Linked linked_of(const RegionView& a, const RegionView& b, Operation operation, const Options& options);
Linked linked_of(const Question& question);

}  // namespace oblast::testing
