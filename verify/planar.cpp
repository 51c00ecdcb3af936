// The status is the list of edges that the sweep line cuts, from below to above; see sweep.cpp on why looking at
// neighbours is enough.
#include "verify/planar.h"

#include <algorithm>
#include <set>

#include "verify/predicates.h"

namespace oblast::verify {
namespace {

// Edges that meet badly at the newer one's left end compare as equal, so that inserting finds them.
struct Below {
  bool operator()(const PlainEdge* e, const PlainEdge* f) const {
    return e != f && stands_below(e->left, e->right, f->left, f->right);
  }
};

struct Event {
  Point at;
  const PlainEdge* edge;
  bool begins;
};

}  // namespace

std::optional<std::pair<PlainEdge, PlainEdge>> find_bad_meeting(const std::vector<PlainEdge>& edges) {
  using Status = std::set<const PlainEdge*, Below>;
  std::vector<Event> events;
  events.reserve(2 * edges.size());
  for (const PlainEdge& e : edges) {
    events.push_back({e.left, &e, true});
    events.push_back({e.right, &e, false});
  }
  std::sort(events.begin(), events.end(), [](const Event& p, const Event& q) {
    return p.at != q.at ? lexicographically_less(p.at, q.at) : p.begins < q.begins;
  });
  Status status;
  std::vector<Status::iterator> places(edges.size());
  const auto place_of = [&](const PlainEdge* e) -> Status::iterator& {
    return places[static_cast<std::size_t>(e - edges.data())];
  };
  const auto are_bad = [](const PlainEdge* e, const PlainEdge* f) {
    return meet_badly(e->left, e->right, f->left, f->right);
  };
  for (const Event& event : events) {
    if (event.begins) {
      const auto [place, is_new] = status.insert(event.edge);
      if (!is_new) return std::pair(**place, *event.edge);
      place_of(event.edge) = place;
      if (place != status.begin() && are_bad(*std::prev(place), event.edge))
        return std::pair(**std::prev(place), *event.edge);
      if (std::next(place) != status.end() && are_bad(*std::next(place), event.edge))
        return std::pair(**std::next(place), *event.edge);
    } else {
      const auto after = status.erase(place_of(event.edge));
      if (after != status.begin() && after != status.end() && are_bad(*std::prev(after), *after))
        return std::pair(**std::prev(after), **after);
    }
  }
  return std::nullopt;
}

}  // namespace oblast::verify
