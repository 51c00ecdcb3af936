#include "graph/connectivity_lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/parallel.h"
#include "base/tuning.h"
#include "graph/angular_order.h"

namespace oblast::internal {
namespace {

/// A descriptor with the point it aims at, so that sorting by angle finds it at hand.
struct Aimed {
  Point at;
  Descriptor descriptor;
  std::uint32_t to;  ///< node it comes to
};

void sort_by_angle(const Point& x, Array<Aimed>& list) {
  std::sort(list.begin(), list.end(), [&](const Aimed& p, const Aimed& q) { return angularly_less(x, p.at, q.at); });
}

/// Puts the descriptors from x in order, without branches, by how many come before each. False where directions are too
/// near each other for that, or too many.
bool place_by_angle(const Point& x, const Array<Aimed>& list, std::span<Descriptor> places) {
  if (list.size() > tuning::most_counted_directions) return false;
  std::array<double, tuning::most_counted_directions> angles;
  std::array<std::uint32_t, tuning::most_counted_directions> before;
  bool clear = true;
  for (std::size_t i = 0; i < list.size(); ++i) {
    angles[i] = rough_angle(x, list[i].at);
    before[i] = 0;
    for (std::size_t j = 0; j < i; ++j) {
      const double ahead = angles[i] - angles[j];
      clear = static_cast<int>(clear) & static_cast<int>(std::fabs(ahead) > rough_angle_error);
      before[i] += ahead > 0;
      before[j] += ahead < 0;
    }
  }
  if (!clear) return false;
  for (std::size_t i = 0; i < list.size(); ++i) places[before[i]] = list[i].descriptor;
  return true;
}

/// Makes the chains that leave the nodes of a range, and the lists of these nodes.
class ListBuilder {
 public:
  ListBuilder(ChainGraph& graph, const Stops& stops, Array<Coincident>& coincident)
      : graph_(graph), stops_(stops), coincident_(coincident) {
    list_.reserve(16);
  }

  void run(std::uint32_t node) {
    list_.clear();
    for (std::uint32_t i = node == 0 ? 0 : stops_.ends[node - 1]; i < stops_.ends[node]; ++i) {
      fetch_ahead(i);
      add_chains_at(stops_.order[i].index, node);
    }
    const Point& at = graph_.point(graph_.node_vertex[node]);
    const std::uint32_t place = node == 0 ? 0 : graph_.list_ends[node - 1];
    if (place_by_angle(at, list_, std::span(graph_.lists).subspan(place, list_.size()))) return;
    sort_by_angle(at, list_);
    for (std::uint32_t i = 0; i < list_.size(); ++i) graph_.lists[place + i] = list_[i].descriptor;
    note_coincident(node, place);
  }

 private:
  void fetch_ahead(std::uint32_t i) const {
    stops_.fetch_ahead(i, stops_.order.size());
    if (i + fetched_ahead / 2 < stops_.order.size())
      fetch_around(graph_.strands.points, stops_.along[stops_.order[i + fetched_ahead / 2].index].vertex);
  }

  /// The chain that ends in stop k, and the one that begins there. The latter is made.
  void add_chains_at(std::uint32_t k, std::uint32_t node) {
    const Stop& stop = stops_.along[k];
    std::uint32_t chain_before = none;
    if (stops_.has_chain_before(k)) {
      const Stop& previous = stops_.along[k - 1];
      chain_before = previous.chain;
      list_.push_back({graph_.point(stop.vertex - 1), opposite(forward(chain_before)), previous.node});
    }
    if (!stops_.has_chain_after(k)) return;
    const Stop& next = stops_.along[k + 1];
    list_.push_back({graph_.point(stop.vertex + 1), forward(stop.chain), next.node});
    graph_.chains[stop.chain] = {
        stop.vertex, next.vertex, node, next.node, chain_before, stop.chain, graph_.strands.change[stop.strand]};
  }

  /// Descriptors of one direction. Both ends of their edge see them; one of them says so.
  void note_coincident(std::uint32_t node, std::uint32_t place) {
    for (std::uint32_t first = 0, last; first < list_.size(); first = last) {
      for (last = first + 1; last < list_.size() && list_[last].at == list_[first].at; ++last) continue;
      if (last - first > 1 && node < list_[first].to) coincident_.push_back({place + first, place + last});
    }
  }

  ChainGraph& graph_;
  const Stops& stops_;
  Array<Coincident>& coincident_;
  Array<Aimed> list_;
};

}  // namespace

Array<Array<Coincident>> build_connectivity_lists(ChainGraph& graph, const Stops& stops) {
  constexpr std::size_t nodes_a_range = tuning::listed_nodes_a_range;
  Array<Array<Coincident>> coincident(range_count(graph.node_count(), nodes_a_range));
  for_numbered_ranges(graph.node_count(), nodes_a_range, [&](std::size_t range, std::size_t begin, std::size_t end) {
    ListBuilder builder(graph, stops, coincident[range]);
    for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) builder.run(node);
  });
  return coincident;
}

}  // namespace oblast::internal
