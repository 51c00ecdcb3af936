// Writes a file, or a set of files, completely or not at all: it is written in a hidden folder beside its target, and
// renamed at the end.
//
//   out/burnt.shp                                   the target, perhaps with an older file there
//   out/.burnt.shp.writing-Xk2f9a/burnt.shp, ...    what is being written
//
// Both are in the same folder, so renaming stays in one file system and cannot run out of space.
#pragma once

#include <string>
#include <vector>

namespace oblast::io {

struct UnfinishedOutput;

/// The files of one output, given by suffixes of the target's name: "" is the target itself, ".dbf" or "_x.fgb" replace
/// its extension, "-wal" is appended.
struct OutputFiles {
  std::vector<std::string> parts = {""};  ///< renamed in this order; the target itself must be last
  std::vector<std::string> scratch;       ///< may appear during writing, and are removed
  std::vector<std::string> stale;         ///< made by other programs for an older output, and removed with it
};

class StagedOutput {
 public:
  /// Removes what killed programs left of earlier outputs to this target. Throws IoError if the target's folder is not
  /// writable.
  StagedOutput(const std::string& target, OutputFiles files);
  /// Removes the stage with everything in it.
  ~StagedOutput();
  StagedOutput(const StagedOutput&) = delete;
  StagedOutput& operator=(const StagedOutput&) = delete;

  /// The path to write to instead of the target; it has the target's file name.
  const std::string& path() const { return path_; }

  /// Renames the new files to the target's names. Parts of an older output that the new one does not have are removed.
  /// Before an older file is replaced, the new one is flushed to the disk. Throws IoError.
  void commit();

 private:
  std::string target_;
  OutputFiles files_;
  std::string path_;
  int lock_ = -1;  // the stage, opened and locked while it is used
  UnfinishedOutput* unfinished_ = nullptr;
};

}  // namespace oblast::io
