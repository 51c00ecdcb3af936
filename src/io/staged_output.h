// All or nothing: a file, or a set of files, is written in a hidden folder beside its target and renamed at the end.
//
//   out/burnt.shp                                   the target, perhaps with an older file there
//   out/.burnt.shp.writing-Xk2f9a/burnt.shp, ...    what is being written
//
// Same folder, so the rename stays within one file system and cannot run out of space.
#pragma once

#include <string>
#include <vector>

namespace oblast::io {

struct UnfinishedOutput;

/// The files of one output, named by what they add to the target's name: "" is the target itself,
/// ".dbf" or "_x.fgb" replace its extension, "-wal" is put after it.
struct OutputFiles {
  std::vector<std::string> parts = {""};  ///< renamed in this order, so the target itself comes last
  std::vector<std::string> scratch;       ///< may appear while writing, and are never kept
  std::vector<std::string> stale;         ///< made by others for an older output: removed with it
};

class StagedOutput {
 public:
  /// Throws IoError when the target's folder cannot be written to.
  StagedOutput(const std::string& target, OutputFiles files);
  /// Removes the stage with everything in it.
  ~StagedOutput();
  StagedOutput(const StagedOutput&) = delete;
  StagedOutput& operator=(const StagedOutput&) = delete;

  /// The path to write to instead of the target; it has the target's file name.
  const std::string& path() const { return path_; }

  /// Renames what was written over the target. Parts of an older output that the new one does not
  /// have are removed. Where an older file is replaced, the new one is first forced to the disk.
  /// Throws IoError.
  void commit();

 private:
  std::string target_;
  OutputFiles files_;
  std::string path_;
  UnfinishedOutput* unfinished_ = nullptr;
};

}  // namespace oblast::io
