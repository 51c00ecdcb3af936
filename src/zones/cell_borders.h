// Step 4 of zones: the borders between cells of different objects, as strands for noding.
//
// Each side of a triangle with ends of different objects has a border across it, from centre to centre:
//
//          p                the border runs from the centre of the triangle on the right of the side (p, q) to that of
//       r  |  l             the one on its left, and has the object of p on its left. So it changes the sources of a
//     -----+-----           place by +p -q.
//          |                A triangle has two such sides, and the border passes through, or three, where borders meet.
//          q                (drawn turned: p is above)
//
// The centres are rounded, and edges may cross. But around each centre the changes add up to nothing. So how often the
// borders of each object wind around a place is well defined, and these numbers add up to one for every place that is
// not far outside, wherever the centres are: some object has every place.
#pragma once

#include <span>

#include "noding/strands.h"
#include "zones/diagram.h"

namespace oblast::internal::zoning {

/// Appends the borders, with changes of operand B. `changes` is where their handles are from. A border between two
/// sites of one contact goes through the contact. Vertices that do not end a border, nor are contacts, are left out
/// where this moves the border by `flattening` at most, and by an eighth of the distance between the two sites. (0: all
/// stay.)
void append_cell_borders(const Diagram& diagram, std::span<const Contact> contacts, double flattening,
                         noding::SourceChanges& changes, noding::Strands& strands);

}  // namespace oblast::internal::zoning
