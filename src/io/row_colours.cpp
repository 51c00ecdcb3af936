#include "io/row_colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/row_neighbours.h"

namespace oblast::io {
namespace {

constexpr const char* from_light_to_dark[] = {"#fac62d", "#f8850f", "#e45a31", "#bc3754",
                                              "#8a226a", "#56106e", "#210c4a"};
constexpr const char* distinct[] = {"#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7"};
constexpr const char* pale[] = {"#cfe3b4", "#f6d5a8", "#bcd8ea", "#f2bfc4", "#fbf3b9", "#d6c8e6", "#dcdcd2"};
constexpr const char* colour_of_others = "#bbbbbb";
constexpr std::size_t most_classes = std::size(distinct);
constexpr std::size_t longest_label = 24;

void append_row(const FeatureView& rows, std::size_t row, RegionSet& to) {
  for (std::uint32_t p = rows.feature_begin(row); p < rows.feature_end(row); ++p) {
    for (const std::span<const Point> contour : rows.regions.polygon(p).contours()) {
      to.points.insert(to.points.end(), contour.begin(), contour.end());
      to.contour_ends.push_back(static_cast<std::uint32_t>(to.points.size()));
    }
    to.polygon_ends.push_back(static_cast<std::uint32_t>(to.contour_ends.size()));
  }
}

/// UTF-8 is cut between characters.
std::string shortened(const std::string& text) {
  if (text.size() <= longest_label) return text;
  std::size_t end = longest_label;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

}  // namespace

std::vector<PictureClass> classes_by_number(const FeatureView& rows, std::span<const double> numbers) {
  std::vector<double> sorted;  // a number for each polygon: rows of many polygons count as much as these
  for (std::size_t row = 0; row < numbers.size(); ++row)
    if (!std::isnan(numbers[row]))
      sorted.insert(sorted.end(), rows.feature_end(row) - rows.feature_begin(row), numbers[row]);
  if (sorted.empty()) return {};
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> different = sorted;
  different.erase(std::unique(different.begin(), different.end()), different.end());
  // The largest number of each class: every number one of its own if there are few, else quantiles.
  std::vector<double> most = different;
  if (different.size() > most_classes) {
    most.clear();
    for (std::size_t i = 1; i <= most_classes; ++i) most.push_back(sorted[(sorted.size() - 1) * i / most_classes]);
    most.erase(std::unique(most.begin(), most.end()), most.end());
  }
  std::vector<PictureClass> classes(most.size());
  for (std::size_t i = 0; i < most.size(); ++i) {
    const double least = i == 0 ? sorted.front() : *std::upper_bound(different.begin(), different.end(), most[i - 1]);
    classes[i].colour = from_light_to_dark[most.size() == 1 ? 0 : i * (most_classes - 1) / (most.size() - 1)];
    classes[i].label = least == most[i] ? fmt::format("{}", least) : fmt::format("{} to {}", least, most[i]);
  }
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    if (rows.feature_begin(row) == rows.feature_end(row) || std::isnan(numbers[row])) continue;
    const auto i = std::lower_bound(most.begin(), most.end(), numbers[row]) - most.begin();
    append_row(rows, row, classes[static_cast<std::size_t>(i)].regions);
  }
  return classes;
}

std::vector<PictureClass> classes_by_text(const FeatureView& rows, std::span<const std::string> texts) {
  std::map<std::string, std::size_t> counts;
  for (const std::string& text : texts) ++counts[text];
  std::vector<std::pair<std::string, std::size_t>> frequent(counts.begin(), counts.end());
  std::stable_sort(frequent.begin(), frequent.end(), [](const auto& p, const auto& q) { return p.second > q.second; });
  const bool all = frequent.size() <= most_classes;
  if (!all) frequent.resize(most_classes);
  std::vector<PictureClass> classes;
  std::map<std::string, std::size_t> class_of;
  for (const auto& [text, count] : frequent) {
    class_of[text] = classes.size();
    classes.push_back({{}, distinct[classes.size()], text.empty() ? "(none)" : shortened(text)});
  }
  if (!all) classes.push_back({{}, colour_of_others, fmt::format("{} others", counts.size() - most_classes)});
  for (std::size_t row = 0; row < texts.size(); ++row) {
    const auto it = class_of.find(texts[row]);
    append_row(rows, row, classes[it == class_of.end() ? most_classes : it->second].regions);
  }
  return classes;
}

std::vector<PictureClass> classes_by_neighbours(const FeatureView& rows, const std::string& label) {
  // Pairs ascend by their smaller row; here each row needs those before it.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs = neighbours_of(rows);
  std::sort(pairs.begin(), pairs.end(), [](const auto& p, const auto& q) { return p.second < q.second; });
  std::vector<std::size_t> colour_of_row(rows.feature_count());
  std::vector<PictureClass> classes;
  auto pair = pairs.begin();
  for (std::uint32_t row = 0; row < rows.feature_count(); ++row) {
    bool taken[std::size(pale)] = {};
    for (; pair != pairs.end() && pair->second == row; ++pair) taken[colour_of_row[pair->first]] = true;
    if (rows.feature_begin(row) == rows.feature_end(row)) continue;
    const auto first = static_cast<std::size_t>(std::find(taken, std::end(taken) - 1, false) - taken);
    colour_of_row[row] = first;
    while (classes.size() <= first) classes.push_back({{}, pale[classes.size()], ""});
    append_row(rows, row, classes[first].regions);
  }
  if (!classes.empty()) classes.back().label = label;
  return classes;
}

}  // namespace oblast::io
