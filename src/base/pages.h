// Hints to the system about the pages of arrays. Only time and memory depend on them.
#pragma once

#include <cstddef>

namespace oblast::internal {

/// Requests large pages for the pages that lie completely in [begin, end), which is about to be filled.
void ask_for_large_pages(char* begin, const char* end);

/// Gives the large pages that lie completely in [begin, end) back to the system. The contents of the range are lost;
/// the next use gets new pages.
void release_pages(char* begin, const char* end);

}  // namespace oblast::internal
