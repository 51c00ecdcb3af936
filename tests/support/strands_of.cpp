// Strands from lists of points.
#include "support/strands_of.h"

namespace oblast::testing {

noding::Strands strands_of(const std::vector<Path>& paths, noding::Winding change, noding::Group group) {
  noding::Strands strands;
  for (const Path& path : paths) {
    const bool is_closed = path.front() == path.back();
    strands.points.insert(strands.points.end(), path.begin(), path.end());
    strands.flags.resize(strands.points.size(), 0);
    if (is_closed) strands.flags[strands.points.size() - path.size()] = strands.flags.back() = noding::closed_flag;
    strands.close_strand(change, group);
  }
  return strands;
}

std::vector<std::uint32_t> edges_of(const noding::Strands& strands) {
  std::vector<std::uint32_t> edges;
  for (std::size_t s = 0; s < strands.size(); ++s)
    for (std::uint32_t e = strands.begin(s); e + 1 < strands.ends[s]; ++e) edges.push_back(e);
  return edges;
}

Path closed(Path ring) {
  ring.push_back(ring.front());
  return ring;
}

Path box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

}  // namespace oblast::testing
