// Trace vertices of spans that may not go as a whole: some of their vertices may.
#pragma once

#include "base/call_memory.h"
#include "result/trace_spans.h"

namespace oblast::internal {

/// Takes trace vertices of the refused spans out one by one, until none can go: the one with the shortest edge in its
/// place first, of equal ones the lexicographically smallest. `near` is of find_near_vertices(); `gone`, by vertex,
/// says what is out already, and is added to. Spans that are not monotone stay as they are.
/// Cost: O((n + k) log n) for k vertices near the refused spans, where few of them lie near each single edge.
void retry_traces(const TraceSpans& spans, const Array<bool>& refused, const Array<NearVertex>& near,
                  Array<bool>& gone);

}  // namespace oblast::internal
