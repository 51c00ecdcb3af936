#include <oblast/classics.h>

#include <array>
#include <cstddef>

#include "base/block_resource.h"
#include "classics/operand.h"
#include "classics/settle.h"
#include "regions/copy_of.h"
#include "regions/validate.h"
#include "window/window_clip.h"

namespace oblast {
using namespace internal;

struct ClipWindow::Prepared {
  RegionSet regions;                     ///< a copy of the window, for the noding of `overlay`
  std::optional<window::Window> window;  ///< nothing if it has too many sides
};

namespace {

std::optional<window::Window> prepare(const RegionView& window) {
  const classics::Operand operand{window, 1, "clip window", "overlay"};
  return window::Window::of(operand.one_convex_contour().points);
}

RegionSet checked_copy(const RegionView& v) {
  validate(v, 1);
  return copy_of(v);
}

RegionSet rectangle(double x0, double y0, double x1, double y1) {
  if (!(x0 < x1) || !(y0 < y1))
    throw Error(ErrorCode::precondition, "the clip window is empty or not a number; it needs x0 < x1 and y0 < y1", {1});
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}};
}

}  // namespace

ClipWindow::ClipWindow(const RegionView& window, const CallOptions& options)
    : prepared_(public_call(options, window.points.size(), [&](Control&) {
        return std::make_unique<const Prepared>(Prepared{checked_copy(window), prepare(window)});
      })) {}

ClipWindow::ClipWindow(double x0, double y0, double x1, double y1) : ClipWindow(rectangle(x0, y0, x1, y1)) {}

ClipWindow::~ClipWindow() = default;
ClipWindow::ClipWindow(ClipWindow&&) noexcept = default;
ClipWindow& ClipWindow::operator=(ClipWindow&&) noexcept = default;

RegionSet ClipWindow::clip(const RegionView& subject, ClassicReport* report, const CallOptions& options) const {
  ClassicReport unused;
  ClassicReport& done = report ? *report : unused;
  done = {};
  return public_call(options, subject.points.size() + prepared_->regions.points.size(), [&](Control&) {
    validate(subject, 0);
    if (prepared_->window) {
      std::array<std::byte, window::scratch_bytes> scratch;
      BlockResource blocks;
      std::pmr::monotonic_buffer_resource memory(scratch.data(), scratch.size(), &blocks);
      window::WindowClip clip(subject, window::kind_of(subject), *prepared_->window, &memory);
      std::optional<RegionSet> result = clip.run(Operation::intersection);
      done.meetings = clip.crossing_count();
      if (result) return *std::move(result);
    }
    return classics::settle(subject, prepared_->regions, Operation::intersection, done,
                            classics::overlay_options(options));
  });
}

}  // namespace oblast
