// Memory that calls leave for the next ones.
#pragma once

#include <oblast/export.h>

#include <cstddef>
#include <memory>

namespace oblast {

class Workspace;
namespace internal {
class KeptBlocks;
KeptBlocks* kept_blocks(Workspace* workspace, std::size_t vertices);
}  // namespace internal

/// Memory that calls leave behind for the next ones, so that these need not ask the system, whose pages cost a call on
/// some hundred thousand vertices about a quarter of its time. Given in Options::workspace to call after call, it makes
/// no difference to the results. Calls on a few dozen vertices do without it; so do calls on more vertices than it has
/// 64 bytes for, which empty it.
///
/// Calls on any threads may share one at the same time, under a lock; one a thread is best. clear() and kept_bytes()
/// may be called meanwhile, but to move or destroy it may not. It must outlive the calls, not their results.
class OBLAST_API Workspace {
 public:
  static constexpr std::size_t usual_bytes = std::size_t{16} << 20;

  /// Keeps up to `most_bytes` between calls, and within a call beyond what is in use. Throws std::bad_alloc.
  explicit Workspace(std::size_t most_bytes = usual_bytes);
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;
  ~Workspace();

  /// Bytes kept now, at most what the constructor was told.
  std::size_t kept_bytes() const;
  /// Gives them all back to the system.
  void clear();

 private:
  friend internal::KeptBlocks* internal::kept_blocks(oblast::Workspace* workspace, std::size_t vertices);

  std::unique_ptr<internal::KeptBlocks> blocks_;
};

}  // namespace oblast
