// What the program prints on standard error while it works.
#pragma once

#include <chrono>
#include <string>

namespace oblast::app {

/// A line that is rewritten in place. It prints on a terminal only. Several threads may call it, but one at a time.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted = true);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows "what  42 %"; at most ten times a second.
  void show(const std::string& what, double fraction);
  void clear();

 private:
  bool shown_ = false;
  bool wanted_;
  std::string last_;
  std::chrono::steady_clock::time_point when_;
};

/// 1234567 as "1,234,567".
std::string grouped(unsigned long long number);

/// "1 file", "3 files".
std::string counted(unsigned long long number, const std::string& noun);

/// The most memory that the program has held so far, in bytes.
unsigned long long peak_memory();

}  // namespace oblast::app
