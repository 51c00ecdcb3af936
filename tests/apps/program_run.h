// Starts the program as a person would, in a folder of its own, and catches what it says.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace oblast::test {

struct ProgramRun {
  int code = -1;  ///< exit code; -1 when a signal ended it
  std::string out;
  std::string err;
};

/// A fresh folder that is removed at the end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::string path(const std::string& name) const { return (path_ / name).string(); }
  /// Names in the folder, hidden ones too, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// Runs `oblast ARGUMENTS` with `input` on its standard input.
ProgramRun oblast_program(const std::vector<std::string>& arguments, const std::string& input = {});

/// Feeds `input` without ending it, and when the program has read most of it, sends SIGINT.
ProgramRun interrupted_program(const std::vector<std::string>& arguments, const std::string& input);

/// Feeds all of `input` and a moment later, when the program is at work on it, sends SIGINT.
ProgramRun program_interrupted_at_work(const std::vector<std::string>& arguments, const std::string& input);

/// Sends SIGINT so long after the program was started.
ProgramRun program_interrupted_after(std::chrono::microseconds delay, const std::vector<std::string>& arguments);

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace oblast::test
