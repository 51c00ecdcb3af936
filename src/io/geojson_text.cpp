// Finding the features; see geojson_text.h.
#include "io/geojson_text.h"

#include <algorithm>
#include <string_view>

namespace oblast::io {

namespace {

constexpr std::string_view white = " \t\r\n";
constexpr std::size_t longest_head = 4096;  // GDAL looks this far for what a JSON file is
constexpr std::uint64_t longest_tail = 4096;
constexpr std::uint64_t longest_gap = 256;        // between a comma and a feature
constexpr std::uint64_t window_size = 64 * 1024;  // in which the next feature is looked for
constexpr std::string_view key = "\"features\"";

std::size_t skip_white(std::string_view text, std::size_t at) {
  const std::size_t found = text.find_first_not_of(white, at);
  return found == std::string_view::npos ? text.size() : found;
}

// `at` is the opening quote of a string. Returns where its closing quote is, or the end of the text.
std::size_t closing_quote(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\';
  return at < text.size() ? at : text.size();
}

// Behind the bracket that opens the member "features" of the outermost object; 0 if there is none.
std::size_t begin_of_features(std::string_view text) {
  text = text.substr(0, longest_head);
  std::size_t at = skip_white(text, 0);
  if (at == text.size() || text[at] != '{') return 0;
  int depth = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (c != '"') continue;
    const std::size_t end = closing_quote(text, at);
    if (end == text.size()) return 0;
    if (depth == 1 && text.substr(at, end + 1 - at) == key) {
      const std::size_t colon = skip_white(text, end + 1);
      if (colon < text.size() && text[colon] == ':') {
        const std::size_t bracket = skip_white(text, colon + 1);
        return bracket < text.size() && text[bracket] == '[' ? bracket + 1 : 0;
      }
    }
    at = end;
  }
  return 0;
}

// Where the bracket is that closes "features", if nothing but the end of the object follows; 0 if something does.
std::uint64_t end_of_features(const TextSource& source) {
  const std::uint64_t begin = source.size() - std::min(source.size(), longest_tail);
  const std::string bytes = source.read(begin, longest_tail);
  std::string_view text = bytes;
  for (const char expected : {'}', ']'}) {
    const std::size_t last = text.find_last_not_of(white);
    if (last == std::string_view::npos || text[last] != expected) return 0;
    text = text.substr(0, last);
  }
  return begin + text.size();
}

// How the first feature begins, to its first key, or to the value of "type": other features begin with the same bytes.
std::string_view begin_of_feature(std::string_view features) {
  if (features.empty() || features[0] != '{') return {};
  const std::size_t quote = skip_white(features, 1);
  if (quote == features.size() || features[quote] != '"') return {};
  std::size_t end = closing_quote(features, quote);
  if (end == features.size()) return {};
  if (features.substr(quote, end + 1 - quote) != "\"type\"") return features.substr(0, end + 1);
  end = skip_white(features, end + 1);
  if (end == features.size() || features[end] != ':') return {};
  const std::size_t value = skip_white(features, end + 1);
  if (!features.substr(value).starts_with("\"Feature\"")) return {};
  return features.substr(0, value + std::string_view("\"Feature\"").size());
}

// The first feature that begins at `from` or later and before `end`, and the comma before it.
struct Cut {
  std::uint64_t comma = 0, feature = 0;
};
std::optional<Cut> next_cut(const TextSource& source, const std::string& beginning, std::uint64_t from,
                            std::uint64_t end) {
  std::string window;
  while (from < end) {
    const std::uint64_t begin = from - std::min(from, longest_gap);
    window.clear();
    source.append(window, begin, std::min(window_size, end - begin));
    std::size_t at = window.find(beginning, from - begin);
    for (; at != std::string::npos; at = window.find(beginning, at + 1)) {
      const std::size_t comma = at == 0 ? std::string::npos : window.find_last_not_of(white, at - 1);
      if (comma != std::string::npos && window[comma] == ',') return Cut{begin + comma, begin + at};
    }
    if (begin + window.size() >= end || window.size() < window_size) break;
    from = begin + window.size() - beginning.size();
  }
  return std::nullopt;
}

}  // namespace

std::optional<GeojsonText> cut_geojson(const TextSource& source, std::uint64_t block_size) {
  const std::string first = source.read(0, 2 * longest_head);
  const std::size_t features = begin_of_features(first);
  const std::uint64_t end = end_of_features(source);
  if (features == 0 || end < features) return std::nullopt;
  GeojsonText cut{first.substr(0, features), {}};
  const std::size_t begin = skip_white(first, features);
  const std::string beginning(begin_of_feature(std::string_view(first).substr(begin)));
  if (beginning.empty()) return std::nullopt;
  std::uint64_t block = begin;
  while (const std::optional<Cut> next = next_cut(source, beginning, block + block_size, end)) {
    cut.blocks.push_back({block, next->comma});
    block = next->feature;
  }
  cut.blocks.push_back({block, end});
  return cut;
}

}  // namespace oblast::io
