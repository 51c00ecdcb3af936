// Memory that calls keep for later calls.
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

/// Memory that calls keep for later calls. A caller who makes many calls creates one workspace and passes it to each
/// call in Options::workspace. Calls then get fewer pages from the system; for a call on some hundred thousand
/// vertices, this takes about a quarter of the time. Calls on up to 128 vertices that write into an existing result
/// allocate nothing after the first call. A workspace does not change results. A call on more vertices than
/// `most_bytes` / 64 does not use it, and empties it.
///
/// Calls on several threads may share a workspace at the same time; a lock protects it. One workspace per thread is
/// faster. During calls, clear() and kept_bytes() are allowed, but moving or destroying the workspace is not. The
/// workspace must outlive the calls, but not their results.
class OBLAST_API Workspace {
 public:
  static constexpr std::size_t usual_bytes = std::size_t{16} << 20;

  /// The workspace keeps up to `most_bytes` bytes that are not in use, between calls and during calls. Throws
  /// std::bad_alloc.
  explicit Workspace(std::size_t most_bytes = usual_bytes);
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;
  ~Workspace();

  /// The number of bytes that are kept now, at most `most_bytes`.
  std::size_t kept_bytes() const;
  /// Frees all memory that is kept.
  void clear();

 private:
  friend internal::KeptBlocks* internal::kept_blocks(oblast::Workspace* workspace, std::size_t vertices);

  std::unique_ptr<internal::KeptBlocks> blocks_;
};

}  // namespace oblast
