// Scans one line at a time. Each crossing with an edge is widened to a blur, the distance by which rounding may have
// moved it.
//
//      a      b  c               d
//   ---(x)---(x)(x)----(r)------(x)---     x: an input edge crosses the line near the middle of ( )
//      1    2         3        4           r: an edge of the result does
//
// In the stretches between the blurs, A op B does not change. So the result must not change either: r is a fault. At a
// blur the scan steps over all its edges, including those of the result. Then both are compared again.
//
// The crossing of an edge with the line at c is computed from the nearer end. So its rounding error is below 8 units of
// the largest coordinate (five operations, none with a larger result than that). Each blur is 16 units wider on either
// side, for its own error and for that of the edges of the result.
//
// Lines are between numbers, just above c: an edge crosses if one end is at most c and the other is greater.
#include "verify/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <future>

#include "verify/membership.h"
#include "verify/slabs.h"

namespace oblast::verify {
namespace {

constexpr std::size_t crossings_at_a_time = std::size_t{1} << 22;

struct Crossing {
  double low, high;  // the blur; both are equal for edges of the result
  std::uint32_t edge;
};

// For horizontal lines, across is y and along is x. For vertical lines the reverse.
struct Axis {
  bool upright;

  double across(const Point& p) const { return upright ? p.x : p.y; }
  double along(const Point& p) const { return upright ? p.y : p.x; }
  Point point(double along, double across) const { return upright ? Point{across, along} : Point{along, across}; }
  // The side of the edge after crossing it with increasing `along`.
  int side_after(const Segment& s) const { return (across(s.to) > across(s.from)) == upright ? 1 : -1; }
};

class LineSet {
 public:
  LineSet(const Segments& segments, const Question& question, Axis axis, std::vector<double> lines, double bound)
      : segments_(segments),
        question_(question),
        axis_(axis),
        lines_(std::move(lines)),
        bound_(bound),
        rounding_(rounding_along(segments)) {
    std::sort(lines_.begin(), lines_.end());
  }

  std::optional<WrongPlace> judge(int threads, OracleReport& report) {
    const std::vector<std::size_t> counts = count_crossings();
    for (std::size_t first = 0; first < lines_.size();) {
      std::size_t last = first, sum = 0;
      while (last < lines_.size() && (last == first || sum + counts[last] <= crossings_at_a_time))
        sum += counts[last++];
      if (auto wrong = judge_some(first, last, threads, report)) return wrong;
      first = last;
    }
    return std::nullopt;
  }

 private:
  // The lines that edge s crosses.
  std::pair<std::size_t, std::size_t> crossed_by(const Segment& s) const {
    const auto [low, high] = std::minmax({axis_.across(s.from), axis_.across(s.to)});
    const auto first = std::lower_bound(lines_.begin(), lines_.end(), low);
    const auto last = std::lower_bound(first, lines_.end(), high);
    return {first - lines_.begin(), last - lines_.begin()};
  }

  std::vector<std::size_t> count_crossings() const {
    std::vector<std::ptrdiff_t> change(lines_.size() + 1);
    for (std::uint32_t e = 0; e < segments_.size(); ++e) {
      const auto [first, last] = crossed_by(segments_[e]);
      ++change[first];
      --change[last];
    }
    std::vector<std::size_t> counts(lines_.size());
    std::ptrdiff_t open = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = static_cast<std::size_t>(open += change[i]);
    return counts;
  }

  Crossing crossing(std::uint32_t e, double line) const {
    const Segment& s = segments_[e];
    Point near = s.from, far = s.to;
    if (std::abs(axis_.across(far) - line) < std::abs(axis_.across(near) - line)) std::swap(near, far);
    const double rise = axis_.across(far) - axis_.across(near), run = axis_.along(far) - axis_.along(near);
    const auto [low, high] = std::minmax({axis_.along(near), axis_.along(far)});
    const double at = std::clamp(axis_.along(near) + (line - axis_.across(near)) / rise * run, low, high);
    if (s.owner == EdgeOf::result) return {at, at, e};
    const double reach = bound_ * (1 + 0x1p-40) * (std::hypot(rise, run) / std::abs(rise)) + rounding_;
    return {std::max(at - reach, low - rounding_), std::min(at + reach, high + rounding_), e};
  }

  struct Found {
    std::uint64_t stretches = 0;
    std::size_t line = static_cast<std::size_t>(-1);
    WrongPlace wrong;
  };

  std::optional<WrongPlace> judge_some(std::size_t first, std::size_t last, int threads, OracleReport& report) const {
    std::vector<std::vector<Crossing>> input(last - first), result(last - first);
    for (std::uint32_t e = 0; e < segments_.size(); ++e) {
      const auto [begin, end] = crossed_by(segments_[e]);
      auto& lists = segments_[e].owner == EdgeOf::result ? result : input;
      for (std::size_t i = std::max(begin, first); i < std::min(end, last); ++i) {
        lists[i - first].push_back(crossing(e, lines_[i]));
      }
    }
    std::vector<std::future<Found>> workers;
    workers.reserve(static_cast<std::size_t>(threads));
    for (int t = 0; t < threads; ++t) {
      workers.push_back(std::async(std::launch::async, [&, t] {
        Found found;
        for (std::size_t i = static_cast<std::size_t>(t); i < input.size() && found.wrong.what.empty();
             i += static_cast<std::size_t>(threads)) {
          found.line = i;
          follow(lines_[first + i], input[i], result[i], found);
        }
        return found;
      }));
    }
    Found first_wrong;
    for (auto& worker : workers) {
      Found found = worker.get();
      report.stretches += found.stretches;
      if (!found.wrong.what.empty() && found.line < first_wrong.line) first_wrong = std::move(found);
    }
    report.lines += last - first;
    if (first_wrong.wrong.what.empty()) return std::nullopt;
    return first_wrong.wrong;
  }

  void follow(double line, std::vector<Crossing>& input, std::vector<Crossing>& result, Found& found) const {
    const auto less = [](const Crossing& c, const Crossing& d) { return c.low < d.low; };
    std::sort(input.begin(), input.end(), less);
    std::sort(result.begin(), result.end(), less);
    Membership walker(question_.rule_a, question_.polygons_a, question_.rule_b, question_.polygons_b);
    const auto step = [&](const Crossing& c) {
      walker.step_over(segments_[c.edge], axis_.side_after(segments_[c.edge]));
    };
    const auto wrong = [&](double along, const char* what) {
      found.wrong = {what, axis_.point(along, line), walker.in_a(), walker.in_b()};
    };
    std::size_t r = 0;
    for (std::size_t i = 0; i < input.size();) {
      if (r < result.size() && result[r].low < input[i].low) break;
      double end = input[i].high;
      for (; i < input.size() && input[i].low <= end; ++i) {
        end = std::max(end, input[i].high);
        step(input[i]);
      }
      for (; r < result.size() && result[r].low <= end; ++r) step(result[r]);
      if (i == input.size()) break;  // nothing is inside after the last edge
      ++found.stretches;
      const bool inside = selects(question_.operation, walker.in_a(), walker.in_b());
      if (walker.result_winding() == (inside ? 1 : 0)) continue;
      return wrong(end / 2 + input[i].low / 2, inside ? "outside of the result, but the operation says inside"
                                                      : "inside the result, but the operation says outside");
    }
    if (r < result.size()) wrong(result[r].low, "an edge of the result lies where no input edge is within the bound");
  }

  const Segments& segments_;
  const Question& question_;
  Axis axis_;
  std::vector<double> lines_;
  double bound_, rounding_;
};

// Every other line is anywhere; the others are near vertices, because edges are there.
std::vector<double> choose_lines(const Segments& segments, Axis axis, std::uint32_t count, std::mt19937_64& random) {
  const Box& box = segments.box();
  const double low = axis.across({box.x0, box.y0}), high = axis.across({box.x1, box.y1});
  std::vector<double> lines;
  lines.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double u = uniform(random), v = uniform(random);
    if (i % 2 == 0) {
      lines.push_back(low + u * (high - low));
    } else {
      const auto e = static_cast<std::uint32_t>(u * segments.size());
      lines.push_back(axis.across(segments[e].from) + 100 * (v - 0.5) * segments.unit());
    }
  }
  return lines;
}

}  // namespace

std::optional<WrongPlace> judge_lines(const Segments& segments, const Question& question, std::uint32_t lines,
                                      std::uint64_t seed, double bound, int threads, OracleReport& report) {
  std::mt19937_64 random(seed ^ 0x6c696e6573);
  for (const Axis axis : {Axis{false}, Axis{true}}) {
    const std::uint32_t count = axis.upright ? lines / 2 : lines - lines / 2;
    LineSet set(segments, question, axis, choose_lines(segments, axis, count, random), bound);
    if (auto wrong = set.judge(threads, report)) return wrong;
  }
  return std::nullopt;
}

}  // namespace oblast::verify
