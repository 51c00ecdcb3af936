// The arguments of a driver, and the lines that it prints: one JSON object per run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "workloads/workload_file.h"

namespace oblast::bench {

struct Arguments {
  std::string workload;
  std::string operation;  ///< "default": the operation of the workload
  int repeat = 1;
  int threads = 1;
  std::string dump;  ///< file for the last result; empty: none
};

/// What a peer needs besides the operands.
struct Settings {
  Operation operation = Operation::unite;
  FillRule::Kind fill = FillRule::Kind::polygons;
  OperandKind kind_a = OperandKind::region_set;
  OperandKind kind_b = OperandKind::region_set;
  bool unary = false;     ///< B is empty, and the task is the union of A's polygons
  bool coverage = false;  ///< A is a coverage
  bool integer = false;   ///< all coordinates are integers
  double largest = 0;     ///< the largest magnitude of a coordinate
  int threads = 1;
};

/// WORKLOAD OPERATION [--repeat N] [--threads T] [--dump FILE]. Prints the usage if the arguments are wrong.
std::optional<Arguments> parse(int argc, char** argv);
Settings settings_for(const Arguments& arguments, const Workload& workload);

/// Starts measuring the peak of resident memory. The memory at this time is the input and the program.
class Memory {
 public:
  Memory();
  std::uint64_t input_kib() const { return input_kib_; }
  std::uint64_t peak_kib() const;  ///< the peak since construction

 private:
  std::uint64_t input_kib_ = 0;
};

void print_run(const std::string& peer, const std::string& version, const Arguments& arguments, double seconds,
               const Memory& memory, const Operand& result);
void print_failure(const std::string& peer, const std::string& version, const Arguments& arguments,
                   const std::string& kind, const std::string& message);

void append(Operand& target, const Operand& part);
void write_result(const std::string& path, Operand result);

}  // namespace oblast::bench
