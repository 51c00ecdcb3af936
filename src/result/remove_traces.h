// Taking out traces of noding: stage 6.
#pragma once

#include <oblast/options.h>

#include "result/rings.h"

namespace oblast::internal {

/// Takes out every trace vertex that may go (promise G3a, trace_spans.h), and, under CollinearVertices::drop, exactly
/// collinear ones. Cost: O((n + k) log n), where k vertices lie near edges that had traces; linear if there are none.
Rings remove_traces(Rings rings, CollinearVertices collinear);

}  // namespace oblast::internal
