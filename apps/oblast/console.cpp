// The progress line, numbers in words, peak memory.
#include "oblast/console.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

namespace oblast::app {

ProgressLine::ProgressLine(bool wanted) : wanted_(wanted && isatty(STDERR_FILENO)) {}

void ProgressLine::show(const std::string& what, double fraction) {
  if (!wanted_) return;
  const auto now = std::chrono::steady_clock::now();
  if (shown_ && what == last_ && now - when_ < std::chrono::milliseconds(100)) return;
  when_ = now;
  last_ = what;
  shown_ = true;
  fmt::print(stderr, "\r\033[K{} {:3.0f} %", what, fraction * 100);
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (!shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

std::string grouped(unsigned long long number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

std::string counted(unsigned long long number, const std::string& noun) {
  std::string text = grouped(number) + " " + noun;
  if (number == 1) return text;
  if (noun == "vertex") return grouped(number) + " vertices";
  if (noun == "geometry") return grouped(number) + " geometries";
  return text + "s";
}

unsigned long long peak_memory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<unsigned long long>(usage.ru_maxrss) * 1024;
}

}  // namespace oblast::app
