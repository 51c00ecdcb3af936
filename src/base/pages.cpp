#include "base/pages.h"

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>

#include "base/tuning.h"
#endif

namespace oblast::internal {

#ifdef __linux__
namespace {

void advise(char* begin, const char* end, int advice) {
  constexpr std::uintptr_t page = tuning::large_page;
  const auto start = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (start + page - 1) / page * page,
                       last = reinterpret_cast<std::uintptr_t>(end) / page * page;
  if (first < last) madvise(begin + (first - start), last - first, advice);
}

}  // namespace

void ask_for_large_pages(char* begin, const char* end) { advise(begin, end, MADV_HUGEPAGE); }
void release_pages(char* begin, const char* end) { advise(begin, end, MADV_DONTNEED); }
#else
void ask_for_large_pages(char*, const char*) {}
void release_pages(char*, const char*) {}
#endif

}  // namespace oblast::internal
