// All edges that the judge of zones looks at, and where they meet.
#pragma once

#include "verify/zones.h"

namespace oblast::verify {

/// An edge of a row, of an object or of the frame. Edges that two rows share are there once.
struct ZoneEdge : Stroke {
  enum Of : std::uint8_t { row, region, line, frame } of;
  std::uint32_t object = no_feature;
  bool may_move = false;  ///< noding may have moved it: see ZoneCoverBounds::moved
};

/// True if p is on the edge, but not an end of it.
bool has_inside(const Stroke& e, const Point& p);

/// True if p is on the edge, its ends included.
bool has(const Stroke& e, const Point& p);

class ZoneArrangement {
 public:
  ZoneArrangement(const JudgedZones& zones, double moved);

  const std::vector<ZoneEdge>& edges() const { return edges_; }
  const NumberedAreas& rows() const { return rows_; }    ///< a number is an object
  const NumberedAreas& frame() const { return frame_; }  ///< all with the number 0

  /// The other edges whose box comes as near as this to that of `e`.
  template <class Visit>
  void for_each_near(const ZoneEdge& e, double margin, const Visit& visit) const {
    Box box = e.box();
    box.low = {box.low.x - margin, box.low.y - margin};
    box.high = {box.high.x + margin, box.high.y + margin};
    tree_.meeting(box, [&](std::uint32_t k) {
      if (&edges_[k] != &e) visit(edges_[k]);
    });
  }

  /// Where others meet an edge, with its ends, along it.
  std::vector<Location> cuts_of(const ZoneEdge& e) const;

 private:
  void collect(const JudgedZones& zones);
  void find_moved(double moved);
  bool spread_along_lines();

  std::vector<ZoneEdge> edges_;
  NumberedAreas rows_, frame_;
  BoxTree tree_;
};

}  // namespace oblast::verify
