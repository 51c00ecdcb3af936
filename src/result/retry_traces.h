// For spans of trace vertices that may not be removed as a whole: removes single vertices.
#pragma once

#include "base/call_memory.h"
#include "result/trace_spans.h"

namespace oblast::internal {

/// Removes trace vertices of the refused spans one by one, until none can be removed. The vertex with the shortest new
/// edge is first; of equal ones, the lexicographically smallest. `near` is from find_near_vertices(). `gone`, by
/// vertex, says which vertices are removed already; this function adds to it. Spans that are not monotone do not
/// change. Cost: O((n + k) log n) for k vertices near the refused spans, if few of them lie near each single edge.
void retry_traces(const TraceSpans& spans, const Array<bool>& refused, const Array<NearVertex>& near,
                  Array<bool>& gone);

}  // namespace oblast::internal
