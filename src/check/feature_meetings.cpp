#include "check/feature_meetings.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <numeric>

#include "base/parallel.h"
#include "check/edge_pair.h"
#include "check/vertex_passes.h"
#include "noding/edge_pairs.h"
#include "noding/monotone_runs.h"
#include "noding/pair_finder.h"
#include "noding/simple_ring.h"
#include "plane/ring_tree.h"

namespace oblast::internal::checking {
namespace {

using enum FeatureFaultKind;

/// A meeting by indices of the rings' points.
struct Meeting {
  EdgeContact contact;
  std::uint32_t i, j;  ///< edges; of vertex_on_edge the vertex and the edge
  Point point;

  friend bool operator==(const Meeting&, const Meeting&) = default;
};

bool before(const Meeting& a, const Meeting& b) {
  if (a.contact != b.contact) return a.contact < b.contact;
  return a.i != b.i ? a.i < b.i : a.j < b.j;
}

/// True if no edges meet; false says nothing.
bool surely_apart(const FeatureRings& rings) {
  if (rings.size() == 1) {
    const std::span<const Point> ring(rings.points.data(), rings.points.size() - 1);
    if (convex_turn(ring) != 0) return true;
  }
  RingTree tree;
  tree.build(rings.points, rings.ends);
  return tree.edges_meet() == false;
}

Array<Meeting> find_meetings(const FeatureRings& rings) {
  noding::Strands strands;
  strands.points.assign(rings.points.begin(), rings.points.end());
  strands.ends = rings.ends;
  strands.flags.assign(rings.points.size(), 0);
  strands.group.assign(rings.size(), noding::any_group);
  strands.change.resize(rings.size());
  strands.simplicity.assign(rings.size(), noding::Simplicity::known);
  for (std::size_t r = 0; r < rings.size(); ++r)
    strands.flags[rings.begin(r)] = strands.flags[rings.ends[r] - 1] = noding::closed_flag;

  Array<Meeting> meetings;
  std::mutex mutex;
  const Point* const points = rings.points.data();
  const auto visit = [&](std::span<const noding::RunPair> pairs) {
    poll();
    Array<Meeting> found;
    for (const noding::RunPair& pair : pairs)
      noding::for_edge_pairs(points, pair, [&](std::uint32_t i, std::uint32_t j) {
        if (i == j) return;
        for_contacts(points, std::min(i, j), std::max(i, j),
                     [&](EdgeContact contact, std::uint32_t p, std::uint32_t q, const Point& at) {
                       found.push_back({contact, p, q, at});
                     });
      });
    if (found.empty()) return;
    const std::lock_guard lock(mutex);
    meetings.insert(meetings.end(), found.begin(), found.end());
  };
  noding::find_pairs(strands.points, noding::monotone_runs(strands, noding::Grouping::none), std::ref(visit));
  std::sort(meetings.begin(), meetings.end(), before);
  meetings.erase(std::unique(meetings.begin(), meetings.end()), meetings.end());
  return meetings;
}

/// Two passes through one point, or an edge with another one, as faults by the roles of their rings.
class Judge {
 public:
  Judge(FeatureRings& rings, std::vector<FeatureFault>& faults, Array<RingTouch>& touches)
      : rings_(rings), faults_(faults), touches_(touches) {}

  void cross(std::uint32_t i, std::uint32_t j, const Point& at) {
    const std::uint32_t a = rings_.ring_of(i), b = rings_.ring_of(j);
    add(crossing_kind(a, b), a, i, b, j, at);
  }

  void run_along(std::uint32_t i, std::uint32_t j, const Point& at) {
    const std::uint32_t a = rings_.ring_of(i), b = rings_.ring_of(j);
    add(a == b                                   ? ring_runs_along_itself
        : rings_.polygon[a] == rings_.polygon[b] ? rings_share_edge
                                                 : parts_share_edge,
        a, i, b, j, at);
  }

  void touch(std::uint32_t i, std::uint32_t j, const Point& at) {
    const std::uint32_t a = rings_.ring_of(i), b = rings_.ring_of(j);
    if (a == b)
      faults_.push_back({ring_touches_itself, rings_.place(a, std::max(i, j)), rings_.place(b, std::min(i, j)), at});
    else if (rings_.polygon[a] == rings_.polygon[b])
      touches_.push_back({at, a, i, b, j});
  }

 private:
  FeatureFaultKind crossing_kind(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return ring_crosses_itself;
    if (rings_.polygon[a] != rings_.polygon[b]) return parts_overlap;
    return rings_.is_hole[a] && rings_.is_hole[b] ? holes_overlap : hole_crosses_shell;
  }

  /// The later one is named first: it is the one that is not right.
  void add(FeatureFaultKind kind, std::uint32_t a, std::uint32_t i, std::uint32_t b, std::uint32_t j, const Point& at) {
    rings_.broken[a] = rings_.broken[b] = 1;
    if (i < j) std::swap(a, b), std::swap(i, j);
    faults_.push_back({kind, rings_.place(a, i), rings_.place(b, j), at});
  }

  FeatureRings& rings_;
  std::vector<FeatureFault>& faults_;
  Array<RingTouch>& touches_;
};

/// One of each stretch: pairs of edges follow one another if both edges are the same or neighbours in their rings.
class Stretches {
 public:
  explicit Stretches(const FeatureRings& rings) : rings_(rings) {}

  /// Whether the pair begins a stretch. A spike does not: it is a fault of its own, and so is what goes on from it.
  /// REQUIRES: pairs come in descending order.
  bool begins(std::uint32_t i, std::uint32_t j) {
    std::erase_if(open_, [&](const auto& pair) { return pair.first > i + 1; });
    const bool goes_on =
        std::any_of(open_.begin(), open_.end(), [&](const auto& pair) { return near(pair.second, j); });
    open_.emplace_back(i, j);
    return !goes_on && !near(i, j);
  }

 private:
  /// The same edge, or neighbours in their ring.
  bool near(std::uint32_t p, std::uint32_t q) const {
    const std::uint32_t ring = rings_.ring_of(p), distance = p < q ? q - p : p - q;
    if (ring != rings_.ring_of(q)) return false;
    return distance <= 1 || distance == rings_.ends[ring] - rings_.begin(ring) - 2;
  }

  const FeatureRings& rings_;
  Array<std::pair<std::uint32_t, std::uint32_t>> open_;
};

void judge_vertex_on_edge(const FeatureRings& rings, const Meeting& m, Judge& judge) {
  const std::uint32_t ring = rings.ring_of(m.i);
  const Point &c = rings.points[m.j], &d = rings.points[m.j + 1];
  const int in = exact::orientation(c, d, rings.points[rings.before(m.i, ring)]);
  const int out = exact::orientation(c, d, rings.points[m.i + 1]);
  if (in == 0 || out == 0) return;  // the edges run along each other, which is said elsewhere
  in == out ? judge.touch(m.i, m.j, m.point) : judge.cross(m.i, m.j, m.point);
}

}  // namespace

Array<RingTouch> find_feature_meetings(FeatureRings& rings, std::vector<FeatureFault>& faults) {
  Array<RingTouch> touches;
  if (rings.size() == 0 || surely_apart(rings)) return touches;
  Judge judge(rings, faults, touches);
  Stretches stretches(rings);
  const Array<Meeting> meetings = find_meetings(rings);
  for (auto m = meetings.rbegin(); m != meetings.rend(); ++m) {
    if (m->contact == EdgeContact::cross) judge.cross(m->i, m->j, m->point);
    if (m->contact == EdgeContact::vertex_on_edge) judge_vertex_on_edge(rings, *m, judge);
    if (m->contact == EdgeContact::along && stretches.begins(m->i, m->j)) judge.run_along(m->i, m->j, m->point);
  }
  for_common_vertices(rings, [&](VertexMeeting meeting, std::uint32_t i, std::uint32_t j) {
    meeting == VertexMeeting::cross ? judge.cross(i, j, rings.points[i]) : judge.touch(i, j, rings.points[i]);
  });
  return touches;
}

}  // namespace oblast::internal::checking
