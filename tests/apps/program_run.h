// Runs the program as a user would, in a separate folder, and captures its output.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace oblast::test {

struct ProgramRun {
  int code = -1;  ///< exit code; -1 if a signal ended the program
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
  /// The sorted names in the folder, including hidden ones.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// Runs `oblast ARGUMENTS` with `input` on its standard input.
ProgramRun oblast_program(const std::vector<std::string>& arguments, const std::string& input = {});

/// Runs `oblast ARGUMENTS` with a terminal as its standard error; `err` is all that the terminal got.
ProgramRun program_on_terminal(const std::vector<std::string>& arguments);

/// Writes `input` without closing it, and sends SIGINT after the program has read most of it.
ProgramRun interrupted_program(const std::vector<std::string>& arguments, const std::string& input);

/// Writes all of `input`, and sends SIGINT a moment later, while the program computes.
ProgramRun program_interrupted_at_work(const std::vector<std::string>& arguments, const std::string& input);

/// Sends SIGINT this long after the start of the program.
ProgramRun program_interrupted_after(std::chrono::microseconds delay, const std::vector<std::string>& arguments);

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace oblast::test
