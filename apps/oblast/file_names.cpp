// Counts how many files have each name; see file_names.h.
#include "oblast/file_names.h"

#include <filesystem>
#include <map>

namespace oblast::app {

std::vector<std::vector<std::string>> file_names(const std::vector<io::Rows>& layers) {
  std::map<std::string, int> uses;
  const auto stem = [](const std::string& file) { return std::filesystem::path(file).stem().string(); };
  for (const io::Rows& layer : layers) {
    for (const std::string& file : layer.layer.files) ++uses[stem(file)];
  }
  std::vector<std::vector<std::string>> names;
  for (const io::Rows& layer : layers) {
    auto& of_layer = names.emplace_back();
    for (const std::string& file : layer.layer.files) of_layer.push_back(uses[stem(file)] > 1 ? file : stem(file));
  }
  return names;
}

}  // namespace oblast::app
