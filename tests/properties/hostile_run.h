// A run over hostile cases: each alone, with others far away, and in a crowd. oblast_hostile and a test are such runs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generators/trial.h"

namespace oblast::generators {

struct HostileSettings {
  std::uint64_t cases = 1000;  ///< of every generator
  std::uint64_t first_seed = 1;
  int smallest = 8;        ///< edges
  int largest = 0;         ///< edges; 0: the usual size of the generator
  int large = 1000;        ///< one of so many cases has up to HostileGenerator::largest edges; 0: none
  int threads = 0;         ///< 0: all cores
  bool against = true;     ///< ask verify::check_against in every case, not in one of 256 small ones
  bool engines = false;    ///< compare all engines in every case, not in one of four
  bool recompute = false;  ///< recompute the arrangement in every case, not in one of 256
  double patience = 0;     ///< seconds after which a call is given up; 0: never
  std::uint64_t show = 2;  ///< crowds whose failures are made smaller
  std::string only;        ///< the name of the only generator; empty: all
};

/// What became of the cases of one generator.
struct HostileRow {
  const HostileGenerator* generator = nullptr;
  std::uint64_t cases = 0;
  std::uint64_t failed[broken_count] = {};
  Figures figures;

  std::uint64_t failures() const;
  void add(const HostileRow& other);
};

struct FailedCase {
  const HostileGenerator* generator;
  std::uint64_t seed;
  Operands operands;  ///< as the generator made them; none if it threw
  Request request;    ///< that of the case alone
  Failure failure;
};

/// Runs cases of all generators in blocks of about a thousand, which are the crowds; blocks of later seeds are the same
/// whatever came before, so slices of a run can be run anywhere. A row a generator. `report` is called for every
/// failure, by one thread at a time.
std::vector<HostileRow> run_hostile(const HostileSettings& settings,
                                    const std::function<void(const FailedCase&)>& report);

}  // namespace oblast::generators
