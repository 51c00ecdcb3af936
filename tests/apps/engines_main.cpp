// Compares the bytes of the three engines on every input, or, with --triangulations, verifies the triangulation of
// every input with exact arithmetic. Prints one line with totals. The exit code is 1 if anything is wrong.
//
//   oblast_engines corpus FOLDER
//   oblast_engines hostile --cases 10000           of every generator
//   oblast_engines files --a PATH... --b PATH...
#include <fmt/format.h>
#include <oblast/error.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>

#include "generators/hostile.h"
#include "generators/random.h"
#include "generators/trial.h"
#include "io/read.h"
#include "oblast/corpus_case.h"
#include "support/engine_agreement.h"

namespace {

using namespace oblast;
using generators::Operands;
using testing::Question;

class Tally {
 public:
  explicit Tally(bool triangulations) : triangulations_(triangulations) {}

  void add(const std::string& name, const Operands& operands, std::span<const Question> questions) {
    ++inputs_;
    if (triangulations_) {
      std::uint64_t triangles = 0;
      report(name, testing::triangulation_fault(operands, triangles));
      items_ += triangles;
      return;
    }
    for (const Question& question : questions) {
      ++items_;
      if (report(name, testing::difference(operands, question))) return;
    }
  }

  /// Prints the totals. Returns an exit code.
  int finish(const char* what) const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    fmt::print("{}: {} inputs, {} {}, {} {}, {:.1f} s\n", what, inputs_.load(), items_.load(),
               triangulations_ ? "triangles verified" : "questions to three engines", faults_.load(),
               triangulations_ ? "faults" : "differ", passed.count());
    return faults_ == 0 && inputs_ > 0 ? 0 : 1;
  }

 private:
  bool report(const std::string& name, const std::optional<std::string>& fault) {
    if (!fault) return false;
    const std::lock_guard lock(printing_);
    if (++faults_ <= 20) fmt::print("{}: {}\n", name, *fault);
    return true;
  }

  bool triangulations_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::atomic<std::uint64_t> inputs_ = 0, items_ = 0, faults_ = 0;
  std::mutex printing_;
};

/// Cases run in parallel, each on one thread.
std::vector<Question> on_one_thread(std::span<const Question> questions) {
  std::vector<Question> result(questions.begin(), questions.end());
  for (Question& question : result) question.options.threads = 1;
  return result;
}

/// The first operand against all others together.
Operands operands_of(const app::CorpusCase& corpus_case) {
  std::string others;
  for (std::size_t k = 1; k < corpus_case.operands.size(); ++k) others += corpus_case.operands[k] + "\n";
  Operands operands;
  operands.a = io::read_wkt(corpus_case.operands[0], corpus_case.id).regions;
  if (!others.empty()) operands.b = io::read_wkt(others, corpus_case.id).regions;
  return operands;
}

/// Cases that differ only in their operation are one input, because every operation is run on each: the union of one
/// operand, all operations of two.
void run_corpus(const std::string& folder, Tally& tally) {
  std::uint64_t cases = 0;
  std::map<std::vector<std::string>, app::CorpusCase> inputs;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().filename() != "cases.jsonl") continue;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      if (line.empty()) continue;
      app::CorpusCase corpus_case = app::parse_case(line);
      inputs.emplace(corpus_case.operands, std::move(corpus_case));
      ++cases;
    }
  }
  fmt::print("{} cases\n", cases);
  std::vector<const app::CorpusCase*> corpus_cases;
  for (const auto& input : inputs) corpus_cases.push_back(&input.second);
  const std::vector<Question> questions = on_one_thread(testing::all_questions());
  std::vector<Question> unions;
  std::copy_if(questions.begin(), questions.end(), std::back_inserter(unions),
               [](const Question& question) { return question.operation == Operation::unite; });
  tbb::parallel_for(std::size_t{0}, corpus_cases.size(), [&](std::size_t i) {
    tally.add(corpus_cases[i]->id, operands_of(*corpus_cases[i]),
              corpus_cases[i]->operands.size() == 1 ? unions : questions);
  });
}

void run_hostile(std::uint64_t cases, Tally& tally) {
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    tbb::parallel_for(std::uint64_t{0}, cases, [&](std::uint64_t i) {
      const std::uint64_t seed = i + 1;
      const generators::Request request = generators::draw_request(seed);
      std::vector<Question> questions;
      for (const Operation operation :
           {Operation::intersection, Operation::unite, Operation::difference, Operation::symmetric_difference}) {
        Question question{operation, {}};
        question.options.fill_a = request.fill_a;
        question.options.fill_b = request.fill_b;
        question.options.contours = request.contours;
        question.options.collinear = request.collinear;
        question.options.threads = 1;
        questions.push_back(question);
      }
      const int size = generators::Random(seed ^ 0x517eu).between(8, 60);
      tally.add(fmt::format("{} seed {}", generator.name, seed), generator.make(seed, size), questions);
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("The three engines on the same input: the same bytes, or triangulations that verify.");
  app.require_subcommand(1);
  app.fallthrough();
  bool triangulations = false, all = false;
  app.add_flag("--triangulations", triangulations, "verify the triangulations instead of comparing the engines");
  std::string folder;
  std::uint64_t cases = 1000;
  std::vector<std::string> a, b;
  CLI::App* corpus = app.add_subcommand("corpus", "every cases.jsonl under a folder, all questions");
  corpus->add_option("FOLDER", folder)->required();
  CLI::App* hostile = app.add_subcommand("hostile", "random cases, all operations, rules and conventions drawn");
  hostile->add_option("--cases", cases, "of every generator")->capture_default_str();
  CLI::App* files = app.add_subcommand("files", "two layers");
  files->add_option("--a", a, "files or folders")->required();
  files->add_option("--b", b, "files or folders")->required();
  files->add_flag("--all", all, "every operation under every rule");
  CLI11_PARSE(app, argc, argv);
  try {
    Tally tally(triangulations);
    if (*corpus) run_corpus(folder, tally);
    if (*hostile) run_hostile(cases, tally);
    if (*files)
      tally.add("files", {io::read(a).regions, io::read(b).regions},
                all ? testing::all_questions() : testing::some_questions());
    return tally.finish(*corpus ? "corpus" : *hostile ? "hostile" : "files");
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
