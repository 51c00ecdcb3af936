#include "oblast/fault_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/picture.h"
#include "io/picture_file.h"
#include "oblast/console.h"
#include "oblast/job_picture.h"

namespace oblast::app {

namespace {

// Apart from each other for colour-blind readers, too, and from the blue of the features (Okabe and Ito; Tol).
constexpr const char* colours[] = {"#d55e00", "#cc79a7", "#009e73", "#f0e442", "#000000",
                                   "#882255", "#e69f00", "#332288", "#999933"};
constexpr const char* colour_of_notes = "#888888";
constexpr double size_of_fault = 7, size_among_many = 5, size_of_note = 3;
constexpr std::size_t many = 1000;

struct Kind {
  FeatureFaultKind kind;
  std::vector<Point> points;
};

// The kinds that there are, the most frequent ones first.
std::vector<Kind> kinds_of(std::span<const FeatureFault> faults) {
  std::vector<Kind> kinds;
  for (std::size_t i = 0; i < feature_fault_kinds; ++i) kinds.push_back({static_cast<FeatureFaultKind>(i), {}});
  for (const FeatureFault& fault : faults) kinds[static_cast<std::size_t>(fault.kind)].points.push_back(fault.point);
  std::erase_if(kinds, [](const Kind& kind) { return kind.points.empty(); });
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const Kind& a, const Kind& b) { return a.points.size() > b.points.size(); });
  return kinds;
}

// Notes lie below faults, and frequent faults below rare ones.
std::vector<io::PictureMarks> marks_of(std::span<const FeatureFault> faults) {
  const double size = faults.size() > many ? size_among_many : size_of_fault;
  std::vector<io::PictureMarks> notes, marks;
  for (Kind& kind : kinds_of(faults)) {
    const std::string label = fmt::format("{}: {}", name(kind.kind), grouped(kind.points.size()));
    if (is_note(kind.kind))
      notes.push_back({std::move(kind.points), colour_of_notes, label + " (note)", size_of_note});
    else
      marks.push_back({std::move(kind.points), colours[marks.size() % std::size(colours)], label, size});
  }
  notes.insert(notes.end(), marks.begin(), marks.end());
  return notes;
}

}  // namespace

void draw_faults(const io::Layer& layer, std::span<const FeatureFault> faults, const std::string& name,
                 const std::string& path, io::Existing existing) {
  const auto count = static_cast<std::size_t>(
      std::count_if(faults.begin(), faults.end(), [](const FeatureFault& fault) { return !is_note(fault.kind); }));
  io::Picture picture;
  picture.a = layer.regions;
  picture.label_a = name;
  picture.label_result.clear();
  picture.title = count == 0 ? "no faults in " + name : fmt::format("{} in {}", counted(count, "fault"), name);
  picture.marks = marks_of(faults);
  const io::Layer* const layers[] = {&layer};
  set_plane(picture, layers);
  io::write_picture(path, io::to_svg(picture), existing);
}

}  // namespace oblast::app
