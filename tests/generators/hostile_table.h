// What the hostile programs of rows, buffers and zones have in common: options, a run over seeds on all cores, failures
// as they come, and a table with a line for each generator. tools/hostile adds up such tables.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generators/hostile.h"

namespace oblast::generators {

struct HostileTable {
  std::uint64_t cases = 100, first_seed = 1, show = 2;
  std::string only;

  /// What a case came to that failed.
  struct Failure {
    int broken;        ///< the number of the promise
    std::string what;  ///< printed behind its name
  };

  /// Runs a case. Many are run at once.
  using Case = std::function<std::optional<Failure>(const HostileGenerator& generator, std::uint64_t seed)>;

  /// The columns behind the counts of failures: their names, and what a generator came to. Asking for it begins anew.
  struct Figures {
    std::string names;
    std::function<std::string()> take;
  };

  void add_options(CLI::App& app);

  /// Prints the table, with a column for each promise. Returns the exit code: 1 when a case failed.
  int run(const std::vector<const char*>& promises, const Figures& figures, const Case& run_case) const;
};

/// From 8 edges to `largest`; small ones are more frequent.
int size_of_hostile_case(std::uint64_t seed, int largest);

}  // namespace oblast::generators
