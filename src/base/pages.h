// What the system is told of the pages of memory that arrays are in. It is advice: nothing depends on it but time and
// memory.
#pragma once

#include <cstddef>

namespace oblast::internal {

/// Pages that lie whole in [begin, end), which are about to be filled, shall be large.
void ask_for_large_pages(char* begin, const char* end);

/// Nothing in [begin, end) is needed any more: large pages that lie whole in it go back to the system, and come again
/// at their next use.
void release_pages(char* begin, const char* end);

}  // namespace oblast::internal
