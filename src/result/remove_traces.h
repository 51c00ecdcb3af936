// Stage 6: removes traces of noding.
#pragma once

#include <oblast/options.h>

#include "result/rings.h"

namespace oblast::internal {

/// Removes every trace vertex that may be removed (promise G3a, trace_spans.h), and with CollinearVertices::drop also
/// exactly collinear ones. Cost: O((n + k) log n) if k vertices lie near edges with traces; linear if there are no
/// traces.
Rings remove_traces(Rings rings, CollinearVertices collinear);

}  // namespace oblast::internal
