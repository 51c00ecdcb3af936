// What the program prints on standard error while it works.
#pragma once

#include <chrono>
#include <string>

namespace oblast::app {

/// A line that is rewritten in place: a bar, what is being done, and the time that is left. It prints on a terminal
/// only. Several threads may call it, but one at a time.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted = true);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows "[#####     ]  42 %  what, 12 s left"; at most ten times a second. `fraction` is the share of the whole that
  /// is done. The bar never goes back.
  void show(const std::string& what, double fraction);
  void clear();

 private:
  bool shown_ = false;
  bool wanted_;
  std::string last_;
  double most_ = 0;
  std::chrono::steady_clock::time_point begin_, when_;
};

/// The parts of a job from files to files.
enum class Phase { reading, computing, writing, drawing };

/// One bar over all phases of a job.
class JobProgress {
 public:
  JobProgress(bool wanted, bool with_picture) : line_(wanted), with_picture_(with_picture) {}

  /// `fraction` is the share of the phase that is done.
  void show(Phase phase, const std::string& what, double fraction);
  void clear() { line_.clear(); }

 private:
  ProgressLine line_;
  bool with_picture_;
};

/// "12 s", "3 min 20 s", "2 h 5 min": rounded for somebody who waits.
std::string waiting_time(double seconds);

/// 1234567 as "1,234,567".
std::string grouped(unsigned long long number);

/// "1 file", "3 files".
std::string counted(unsigned long long number, const std::string& noun);

/// The most memory that the program has held so far, in bytes.
unsigned long long peak_memory();

}  // namespace oblast::app
