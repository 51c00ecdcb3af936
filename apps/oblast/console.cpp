// The progress line, numbers in words, peak memory.
#include "oblast/console.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace oblast::app {

namespace {

// What a phase takes of a job, roughly.
constexpr double weights[] = {2, 4, 3, 1};  // by Phase

constexpr int bar_length = 24;
constexpr double first_estimate = 1;  // seconds: before, the time left would be a guess

}  // namespace

ProgressLine::ProgressLine(bool wanted)
    : wanted_(wanted && isatty(STDERR_FILENO)), begin_(std::chrono::steady_clock::now()) {}

void ProgressLine::show(const std::string& what, double fraction) {
  if (!wanted_) return;
  const auto now = std::chrono::steady_clock::now();
  if (shown_ && what == last_ && now - when_ < std::chrono::milliseconds(100)) return;
  when_ = now;
  last_ = what;
  shown_ = true;
  most_ = std::clamp(fraction, most_, 1.0);
  const double spent = std::chrono::duration<double>(now - begin_).count();
  std::string left;
  if (spent > first_estimate && most_ > 0.02) left = ", " + waiting_time(spent * (1 - most_) / most_) + " left";
  const int full = static_cast<int>(most_ * bar_length);
  fmt::print(stderr, "\r\033[K[{:<{}}] {:3.0f} %  {}{}", std::string(full, '#'), bar_length, most_ * 100, what, left);
  std::fflush(stderr);
}

void JobProgress::show(Phase phase, const std::string& what, double fraction) {
  double before = 0, whole = 0;
  for (const Phase other : {Phase::reading, Phase::computing, Phase::writing, Phase::drawing}) {
    if (other == Phase::drawing && !with_picture_) continue;
    const double weight = weights[static_cast<int>(other)];
    whole += weight;
    if (other < phase) before += weight;
  }
  line_.show(what, (before + weights[static_cast<int>(phase)] * fraction) / whole);
}

std::string waiting_time(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
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
