#include "memory/call_memory.h"

namespace oblast {

void free_in_system(void* block, std::size_t bytes) { ::operator delete(block, bytes); }

}  // namespace oblast
