#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "verify/distance.h"
#include "verify/zone_objects.h"
#include "zones/oracles/nearest.h"
#include "zones/oracles/objects.h"

namespace zones {

using namespace oblast;
using verify::Interval, verify::Rational, verify::Stroke;

namespace {

/// The distance of a place from the nearest of some strokes: an estimate, and the strokes that it may be from.
struct Near {
  Interval distance{HUGE_VAL, HUGE_VAL};
  std::vector<Stroke> strokes;

  void add(const Point& p, const Stroke& s) {
    const Interval found = verify::estimated_distance(p, s);
    if (found.low > distance.high) return;
    distance = {std::min(distance.low, found.low), std::min(distance.high, found.high)};
    strokes.push_back(s);
  }
  void set_inside() { distance = {0, 0}, strokes.clear(); }
  Rational square(const Point& p) const {
    if (strokes.empty()) return 0;
    Rational least = verify::squared_distance(verify::RationalPoint(p), strokes[0].a, strokes[0].b);
    for (const Stroke& s : strokes)
      least = std::min(least, verify::squared_distance(verify::RationalPoint(p), s.a, s.b));
    return least;
  }
  double middle() const { return (distance.low + distance.high) / 2; }
};

class Judge {
 public:
  Judge(const Objects& objects, double error, double rounding)
      : objects_(objects.view()), by_object_(objects.size()), further_(error + rounding), rounding_(rounding) {
    for (const auto& e : objects_.edges) {
      by_object_[e.object].push_back(e);
      for (const Stroke& s : {Stroke(e), Stroke{e.a, e.a}, Stroke{e.b, e.b}}) {
        std::vector<std::uint32_t>& list = by_site_[key(s)];
        if (list.empty() || list.back() != e.object) list.push_back(e.object);
      }
    }
  }

  void compare(const Point& p, std::uint32_t row, const Stroke& answer) {
    const auto found = by_site_.find(key(answer));
    if (found == by_site_.end()) throw std::runtime_error("the oracle's site is none of the sites");
    const std::vector<std::uint32_t> holders = objects_.regions.closed_at(p);
    const auto holds = [&](std::uint32_t object) { return std::ranges::binary_search(holders, object); };
    Near ours, theirs;
    for (const Stroke& s : by_object_[row]) ours.add(p, s);
    theirs.add(p, answer);
    if (holds(row)) ours.set_inside();
    if (std::ranges::any_of(found->second, holds)) theirs.set_inside();
    const double difference = ours.middle() - theirs.middle();
    most_ = std::max(most_, difference);
    least_ = std::min(least_, difference);
    others_ += std::ranges::find(found->second, row) == found->second.end();
    if (!is_within(p, ours, theirs, further_)) note(ours_is_further_, p, row, answer, difference);
    if (!is_within(p, theirs, ours, rounding_)) note(theirs_is_further_, p, row, answer, difference);
  }

  nlohmann::json report() const {
    return {{"other_object", others_},
            {"ours_is_further", ours_is_further_},
            {"theirs_is_further", theirs_is_further_},
            {"exactly", exactly_},
            {"largest", most_},
            {"largest_of_theirs", -least_},
            {"examples", examples_}};
  }

 private:
  static std::array<double, 4> key(const Stroke& s) {
    if (s.b.x < s.a.x || (s.b.x == s.a.x && s.b.y < s.a.y)) return {s.b.x, s.b.y, s.a.x, s.a.y};
    return {s.a.x, s.a.y, s.b.x, s.b.y};
  }

  bool is_within(const Point& p, const Near& a, const Near& b, double bound) {
    if (a.distance.high * (1 + 0x1p-50) <= (b.distance.low + bound) * (1 - 0x1p-50)) return true;
    ++exactly_;
    return verify::root_is_within(a.square(p), b.square(p), Rational(bound));
  }

  void note(std::uint64_t& count, const Point& p, std::uint32_t row, const Stroke& answer, double difference) {
    ++count;
    if (examples_.size() < 3)
      examples_.push_back({{"place", {p.x, p.y}},
                           {"row", row},
                           {"site", {answer.a.x, answer.a.y, answer.b.x, answer.b.y}},
                           {"difference", difference}});
  }

  verify::ZoneObjects objects_;
  std::vector<std::vector<Stroke>> by_object_;
  std::map<std::array<double, 4>, std::vector<std::uint32_t>> by_site_;
  double further_, rounding_;
  double most_ = 0, least_ = 0;
  std::uint64_t others_ = 0, ours_is_further_ = 0, theirs_is_further_ = 0, exactly_ = 0;
  nlohmann::json examples_ = nlohmann::json::array();
};

template <class T>
std::vector<T> read_all(const std::string& path, std::size_t skipped, std::size_t count) {
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(skipped));
  std::vector<T> values(count);
  buffers::transfer(in, values);
  if (!in) throw std::runtime_error(path + ": ends too early");
  return values;
}

}  // namespace

nlohmann::json judge_answers(const NearestFiles& files, double error, double rounding) {
  const Objects objects(files.shapes);
  const std::size_t count = read_all<std::uint64_t>(files.places, 0, 1)[0];
  const auto places = read_all<Point>(files.places, sizeof(std::uint64_t), count);
  const auto rows = read_all<std::uint32_t>(files.rows, 0, count);
  const auto answers = read_all<Stroke>(files.answers, 0, count);
  Judge judge(objects, error, rounding);
  for (std::size_t k = 0; k < count; ++k) judge.compare(places[k], rows[k], answers[k]);
  return judge.report();
}

}  // namespace zones
