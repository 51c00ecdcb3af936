// oblast_golden: digests of results, written to files or compared with them. See CONTRIBUTING.md, "Golden digests".
//
//   oblast_golden --check FOLDER                      every family whose data is there
//   oblast_golden --check FOLDER --slice 3/20         every twentieth input, from the third on
//   oblast_golden --write FOLDER --only hostile       one family's file anew
//
// The exit code is 1 if any digest differs, or if a requested family has no data.
#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "golden/inputs.h"

namespace {

using namespace oblast::golden;
namespace fs = std::filesystem;

const std::vector<std::string> family_names{"hostile", "other_functions", "rows",   "buffers", "zones",
                                            "large",   "corpora",         "layers", "fires"};

struct Settings {
  std::string write, check, slice = "1/1", shared = OBLAST_SHARED;
  std::vector<std::string> only;
  std::size_t slice_index = 0, slice_count = 1;
  int show = 10;      // differences, by family
  double slow = 1e9;  // seconds from which an input is named

  bool wants(const char* family) const {
    return only.empty() || std::find(only.begin(), only.end(), family) != only.end();
  }
};

void parse_slice(Settings& settings) {
  const auto bar = settings.slice.find('/');
  const int index = bar == std::string::npos ? 0 : std::atoi(settings.slice.c_str());
  const int count = bar == std::string::npos ? 0 : std::atoi(settings.slice.c_str() + bar + 1);
  if (index < 1 || count < index) throw std::runtime_error("--slice N/M: N from 1 to M");
  settings.slice_index = static_cast<std::size_t>(index - 1);
  settings.slice_count = static_cast<std::size_t>(count);
}

void take_slice(std::vector<Input>& inputs, const Settings& settings) {
  std::sort(inputs.begin(), inputs.end(), [](const Input& a, const Input& b) { return a.name < b.name; });
  std::vector<Input> taken;
  for (std::size_t i = settings.slice_index; i < inputs.size(); i += settings.slice_count)
    taken.push_back(std::move(inputs[i]));
  inputs = std::move(taken);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Digests compute(const Family& family, const Settings& settings) {
  std::vector<InputAndResult> results(family.inputs.size());
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  const auto work = [&] {
    for (std::size_t i; (i = next++) < results.size();) {
      const auto start = std::chrono::steady_clock::now();
      try {
        results[i] = family.inputs[i].compute();
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s %s: %s\n", family.name, family.inputs[i].name.c_str(), error.what());
        failed = true;
      }
      const double seconds = seconds_since(start);
      if (seconds >= settings.slow)
        std::printf("  %s %s: %.1f s\n", family.name, family.inputs[i].name.c_str(), seconds);
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned w = family.side_by_side ? std::thread::hardware_concurrency() : 1; w-- > 0;)
      workers.emplace_back(work);
  }
  if (failed) throw std::runtime_error(std::string(family.name) + ": not every input has a result");
  Digests digests;
  for (std::size_t i = 0; i < results.size(); ++i) digests[family.inputs[i].name] = results[i];
  if (digests.size() != results.size()) throw std::runtime_error(std::string(family.name) + ": two inputs of one name");
  return digests;
}

fs::path file_of(const std::string& folder, const Family& family) {
  return fs::path(folder) / (family.name + std::string(".txt"));
}

void write(const fs::path& path, const Family& family, const Digests& digests) {
  std::ofstream file(path, std::ios::binary);
  file << "# Golden digests of " << family.what << ".\n# By oblast_golden --write; see CONTRIBUTING.md.\n"
       << to_text(digests);
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

Digests read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return parse_digests({std::istreambuf_iterator<char>(file), {}});
}

/// Prints the digests that differ, and returns their number.
std::size_t compare(const Family& family, const Digests& computed, const Digests& golden, const Settings& settings) {
  std::size_t other_results = 0, other_inputs = 0, unknown = 0, gone = 0;
  int left = settings.show;
  const auto show = [&](const std::string& name, const char* what) {
    if (left-- > 0) std::printf("  %s %s: %s\n", family.name, name.c_str(), what);
  };
  for (const auto& [name, digest] : computed) {
    const auto was = golden.find(name);
    if (was == golden.end()) {
      ++unknown;
      show(name, "has no golden digest");
    } else if (digest.input != was->second.input) {
      ++other_inputs;
      show(name, "another input, so nothing is known of its result");
    } else if (digest.result != was->second.result) {
      ++other_results;
      show(name, "another result");
    }
  }
  for (const auto& [name, digest] : golden) {
    if (settings.slice_count > 1 || computed.contains(name)) continue;
    ++gone;
    show(name, "has a golden digest, but is no input any more");
  }
  const std::size_t differing = other_results + other_inputs + unknown;
  std::printf("%-16s %6zu inputs, %zu the same, %zu other results, %zu other inputs, %zu unknown, %zu gone",
              family.name, computed.size(), computed.size() - differing, other_results, other_inputs, unknown, gone);
  return differing + gone;
}

/// Writes or checks one family. Returns the number of differences.
std::size_t run(Family family, const Settings& settings) {
  if (!settings.wants(family.name)) return 0;
  if (family.inputs.empty()) {
    std::printf("%-16s has no data at %s: left out\n", family.name, settings.shared.c_str());
    return settings.only.empty() ? 0 : 1;
  }
  const auto start = std::chrono::steady_clock::now();
  take_slice(family.inputs, settings);
  const Digests digests = compute(family, settings);
  std::size_t differing = 0;
  if (!settings.write.empty()) {
    write(file_of(settings.write, family), family, digests);
    std::printf("%-16s %6zu inputs written", family.name, digests.size());
  } else {
    differing = compare(family, digests, read(file_of(settings.check, family)), settings);
  }
  std::printf(" (%.1f s)\n", seconds_since(start));
  std::fflush(stdout);
  return differing;
}

int run_all(const Settings& settings) {
  const fs::path shared = settings.shared;
  std::size_t differing = 0;
  differing += run(hostile(), settings);
  differing += run(other_functions(), settings);
  differing += run(rows(), settings);
  differing += run(buffers(), settings);
  differing += run(zones(), settings);
  differing += run(large(), settings);
  differing += run(corpora(shared / "corpora"), settings);
  differing += run(layers(shared / "realworld"), settings);
  differing += run(fires(), settings);
  std::printf("%zu differing\n", differing);
  return differing == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app{"Digests of results: written to the files of a folder, or compared with them"};
  auto* write = app.add_option("--write", settings.write, "write the digests into this folder");
  app.add_option("--check", settings.check, "compare the digests with those in this folder")->excludes(write);
  app.add_option("--slice", settings.slice, "N/M: every M-th input of a family, from the N-th on");
  app.add_option("--only", settings.only, "only these families")->check(CLI::IsMember(family_names));
  app.add_option("--shared", settings.shared, "the folder with the corpora and real layers")->capture_default_str();
  app.add_option("--show", settings.show, "differences shown, by family")->capture_default_str();
  app.add_option("--slow", settings.slow, "name inputs that take so many seconds");
  CLI11_PARSE(app, argc, argv);
  try {
    if (settings.write.empty() == settings.check.empty()) throw std::runtime_error("--write FOLDER or --check FOLDER");
    parse_slice(settings);
    if (!settings.write.empty() && settings.slice_count > 1) throw std::runtime_error("a slice is not written");
    return run_all(settings);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "oblast_golden: %s\n", error.what());
    return 1;
  }
}
