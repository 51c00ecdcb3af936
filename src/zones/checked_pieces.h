// What the checks of pieces found, and which pieces are to be checked again.
#pragma once

#include <cstdint>

#include "zones/piece_check.h"

namespace oblast::internal::zoning {

class CheckedPieces {
 public:
  /// Pieces that were not checked yet, or divided since, are unsettled.
  void resize(std::size_t pieces) { checked_.resize(pieces); }

  /// Checks some pieces on all cores. By place in the list: into how many parts to divide the piece, 1 for none.
  Array<std::uint32_t> check(const Array<std::uint32_t>& some, const Diagram& diagram, const PieceEnds& ends,
                             const Room& room);

  /// The pieces that were divided, or have a change near (GrowingDiagram::is_near_change), ascending. Cost: linear in
  /// the triangles of all pieces.
  Array<std::uint32_t> unsettled(const GrowingDiagram& diagram) const;

  std::size_t size() const { return checked_.size(); }
  double error(std::size_t piece) const { return checked_[piece].error; }
  bool is_narrow(std::size_t piece) const { return checked_[piece].is_narrow; }

 private:
  struct Checked {
    double error = 0;
    std::size_t begin = 0;    ///< its triangles, in the list of all
    std::uint32_t count = 0;  ///< how many; 0 if the piece is too long, or short enough whatever is near
    bool is_narrow = false;
    bool is_settled = false;
  };

  bool is_unsettled(const Checked& checked, const GrowingDiagram& diagram) const;
  void keep(const Array<std::uint32_t>& some, Array<Array<std::uint32_t>>& triangles);

  Array<Checked> checked_;               ///< by piece
  LargeArray<std::uint32_t> triangles_;  ///< those of all pieces that are short enough; also what they had before
};

}  // namespace oblast::internal::zoning
