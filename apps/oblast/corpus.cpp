// `oblast corpus`: runs every case of every cases.jsonl in a folder.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>

#include "io/layer.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/corpus_case.h"
#include "oblast/interrupt.h"

namespace oblast::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* footer = R"(
A case passes if its result verifies, uniting the result again changes no byte, all
engines give the same bytes, and the area is right. The expected area is
ref.exact_area; if that is missing, ref.area (both within 1e-9 of the input's area); if
both are missing, expect.area, with the tolerance that its source states.
The --excuse file lists cases whose source contradicts the definitions, one
`id<TAB>reason` per line. They are run and reported, but do not count as failed.

Example
  oblast corpus corpora --excuse excused.txt --filter clipper2/)";

struct Arguments {
  std::string folder;
  std::string excuses;
  std::string filter;
};

struct Entry {
  std::string file;
  std::size_t line = 0;
  std::string text;
  std::string id;
  std::optional<std::string> failure;
};

std::vector<fs::path> case_files(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw io::IoError(folder + ": no such folder");
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().filename() == "cases.jsonl") files.push_back(entry.path());
  }
  if (files.empty()) throw io::IoError(folder + ": there is no cases.jsonl in this folder or its subfolders");
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Entry> read_entries(const Arguments& arguments) {
  std::vector<Entry> entries;
  for (const fs::path& file : case_files(arguments.folder)) {
    std::ifstream stream(file);
    if (!stream) throw io::IoError(file.string() + ": cannot be read");
    std::string text;
    for (std::size_t line = 1; std::getline(stream, text); ++line) {
      if (!text.empty()) entries.push_back({file.string(), line, std::move(text), {}, {}});
    }
  }
  return entries;
}

std::map<std::string, std::string> read_excuses(const std::string& path) {
  std::map<std::string, std::string> excuses;
  if (path.empty()) return excuses;
  std::ifstream stream(path);
  if (!stream) throw io::IoError(path + ": cannot be read");
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    const auto tab = line.find('\t');
    if (tab == std::string::npos || tab + 1 == line.size())
      throw io::IoError(fmt::format("{}, line {}: expected `id<TAB>reason`", path, number));
    excuses[line.substr(0, tab)] = line.substr(tab + 1);
  }
  return excuses;
}

// Runs the cases that match the filter, and removes the others.
void run_entries(std::vector<Entry>& entries, const std::string& filter, ProgressLine& progress) {
  std::atomic<std::size_t> done = 0;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t k) {
    if (interrupted()) throw Interrupted();
    Entry& entry = entries[k];
    try {
      const CorpusCase corpus_case = parse_case(entry.text);
      entry.id = corpus_case.id;
      if (entry.id.find(filter) != std::string::npos) entry.failure = run_case(corpus_case);
    } catch (const std::exception& error) {
      entry.id = fmt::format("{}:{}", entry.file, entry.line);
      entry.failure = std::string("cannot be read: ") + error.what();
    }
    entry.text.clear();
    const std::size_t count = ++done;
    if (const std::unique_lock lock(mutex, std::try_to_lock); lock) {
      progress.show("cases", static_cast<double>(count) / static_cast<double>(entries.size()));
    }
  });
  std::erase_if(entries, [&](const Entry& entry) { return entry.id.find(filter) == std::string::npos; });
}

int report(const std::vector<Entry>& entries, const std::map<std::string, std::string>& excuses, bool json) {
  std::size_t passed = 0, failed = 0, excused = 0;
  std::vector<std::string> needless;
  nlohmann::ordered_json failures = nlohmann::ordered_json::array(), excused_cases = failures;
  for (const Entry& entry : entries) {
    const auto excuse = excuses.find(entry.id);
    if (!entry.failure) {
      ++passed;
      if (excuse != excuses.end()) needless.push_back(entry.id);
      continue;
    }
    nlohmann::ordered_json object{{"id", entry.id}, {"reason", *entry.failure}};
    if (excuse == excuses.end()) {
      ++failed;
      if (!json) fmt::print("failed   {}: {}\n", entry.id, *entry.failure);
      failures.push_back(std::move(object));
    } else {
      ++excused;
      if (!json) fmt::print("excused  {}: {} ({})\n", entry.id, excuse->second, *entry.failure);
      object["excuse"] = excuse->second;
      excused_cases.push_back(std::move(object));
    }
  }
  if (json) {
    const nlohmann::ordered_json object{{"passed", passed},
                                        {"failed", failed},
                                        {"failures", failures},
                                        {"excused", excused_cases},
                                        {"needless_excuses", needless}};
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else {
    for (const std::string& id : needless) fmt::print("needless excuse: {} passes; remove it from the file\n", id);
    if (excused) fmt::print("{} excused\n", excused);
    fmt::print("{} passed, {} failed\n", passed, failed);
  }
  return failed ? exit_data : exit_done;
}

int run(const Arguments& arguments, bool json) {
  const InterruptFlag watch;
  const std::map<std::string, std::string> excuses = read_excuses(arguments.excuses);
  std::vector<Entry> entries = read_entries(arguments);
  ProgressLine progress;
  run_entries(entries, arguments.filter, progress);
  progress.clear();
  if (entries.empty()) throw CallError(fmt::format("no case has '{}' in its id", arguments.filter));
  return report(entries, excuses, json);
}

}  // namespace

void add_corpus(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("corpus", "Run the cases of every cases.jsonl in a folder.");
  command->footer(footer);
  command->add_option("DIR", arguments->folder, "the folder; its subfolders are searched, too")
      ->required()
      ->type_name("");
  command->add_option("--excuse", arguments->excuses, "a list of cases that may fail, with reasons")->type_name("FILE");
  command->add_option("--filter", arguments->filter, "run only cases whose id contains this text")->type_name("TEXT");
  command->add_flag("--json", invocation.json, "print the results as one JSON object on standard output");
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
