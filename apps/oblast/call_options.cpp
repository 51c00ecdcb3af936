#include "oblast/call_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <utility>

namespace oblast::app {

std::size_t parse_bytes(const std::string& word) {
  static constexpr std::pair<const char*, double> units[] = {
      {"", 1},         {"B", 1},    {"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30},
      {"TiB", 0x1p40}, {"KB", 1e3}, {"MB", 1e6},     {"GB", 1e9},     {"TB", 1e12},
  };
  double number = 0;
  const char* const past = word.data() + word.size();
  auto [rest, error] = std::from_chars(word.data(), past, number, std::chars_format::fixed);
  while (rest != past && *rest == ' ') ++rest;
  if (error == std::errc())
    for (const auto& [unit, bytes] : units)
      if (std::string_view(rest, static_cast<std::size_t>(past - rest)) == unit && number * bytes >= 1 &&
          number * bytes < 0x1p63)
        return static_cast<std::size_t>(number * bytes);
  throw CLI::ValidationError(fmt::format(
      "'{}' is not an amount of memory; write a number and a unit, such as 4GiB, 500MB or 1.5GiB (units: B, "
      "KiB, MiB, GiB, TiB, KB, MB, GB, TB)",
      word));
}

namespace {

std::string check_threads(const std::string& word) {
  int number = 0;
  const char* const past = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), past, number);
  if (error == std::errc() && rest == past && number >= 0 && number <= CallOptions::most_threads) return {};
  return fmt::format("'{}' is not a number of threads; write a number from 1 to {}, or 0 for all cores", word,
                     CallOptions::most_threads);
}

}  // namespace

void add_call_options(CLI::App& command, CallOptions& options) {
  CallOptions* const call = &options;
  command.add_option("--threads", call->threads, "number of threads; 0 (default) is all cores. The result is the same")
      ->check(check_threads)
      ->type_name("N");
  command
      .add_option_function<std::string>(
          "--memory", [call](const std::string& word) { call->most_bytes = parse_bytes(word); },
          "memory limit of the computation (not of reading and writing), such as 4GiB or 500MB")
      ->type_name("SIZE");
}

}  // namespace oblast::app
