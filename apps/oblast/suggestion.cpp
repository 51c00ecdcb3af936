// Edit distance, and a list of words that other programs use.
#include "oblast/suggestion.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace oblast::app {

namespace {

// Words of other programs, and operations that are not commands by themselves.
constexpr std::pair<const char*, const char*> known_elsewhere[] = {
    {"intersection", "overlay intersection"},
    {"intersect", "overlay intersection"},
    {"difference", "overlay difference"},
    {"diff", "overlay difference"},
    {"symdifference", "overlay symdifference"},
    {"xor", "overlay symdifference"},
    {"identity", "overlay identity"},
    {"join", "overlay identity"},
    {"subtract", "erase"},
    {"minus", "erase"},
    {"mask", "erase"},
    {"cut", "clip"},
    {"crop", "clip"},
    {"merge", "union"},
    {"unite", "union"},
    {"combine", "union"},
    {"aggregate", "dissolve"},
    {"group", "dissolve"},
    {"count", "depth"},
    {"coverage", "depth"},
    {"planarize", "partition"},
    {"split", "partition"},
    {"valid", "check"},
    {"validate", "check"},
    {"verify", "check"},
    {"convex-hull", "hull"},
    {"delaunay", "triangulate"},
    {"usage", "help"},
    {"examples", "help recipes"},
    {"recipes", "help recipes"},
};

// Insertions, deletions, replacements, and swaps of neighbours, that turn one word into the other.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, above, row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

// The nearest word, if it is near enough to be meant: a slip for every three letters.
std::string nearest(const std::string& word, const std::vector<std::string>& words) {
  std::string best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& known : words) {
    if (const std::size_t distance = edit_distance(word, known); distance < least) {
      least = distance;
      best = known;
    }
  }
  return best;
}

}  // namespace

std::string suggested_command(const CLI::App& program, const std::string& word) {
  for (const auto& [elsewhere, here] : known_elsewhere)
    if (word == elsewhere) return std::string("oblast ") + here;
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  const std::string found = nearest(word, names);
  return found.empty() ? "" : "oblast " + found;
}

std::string suggested_option(const CLI::App& command, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return nearest(word.substr(0, word.find('=')), names);
}

}  // namespace oblast::app
