// A crowd of hostile cases. Each must have the same result as alone.
#include "generators/crowd.h"

#include <oblast/overlay.h>

#include <algorithm>
#include <exception>
#include <numeric>

#include "generators/random.h"
#include "generators/shrink.h"
#include "generators/trial.h"
#include "generators/wkt.h"

namespace oblast::generators {
namespace {

// The four operations on A and B, and the union of the contours of both as one operand.
constexpr int forms = 5;

RegionSet run_form(const Operands& operands, int form, const Options& options) {
  if (form < 4) return overlay(operands.a, operands.b, static_cast<Operation>(form), options);
  return unite(operands.a, options);
}

// The last form has one operand.
Operands operands_of_form(Operands operands, int form) {
  if (form == forms - 1) {
    append(operands.a, operands.b);
    operands.b = {};
  }
  return operands;
}

const char* name_of(int form) {
  static constexpr const char* names[forms] = {"intersection", "union", "difference", "symdifference", "unite"};
  return names[form];
}

class Crowd {
 public:
  Crowd(std::vector<CrowdMember> members, std::uint64_t seed) : members_(std::move(members)), seed_(seed) {
    Random random(seed ^ 0xc20edu);
    request_ = draw_request(random.next());
    places_ = random.one_in(2) ? Places::row : Places::scale;
    alone_ = crowded_ = options_of(request_);
    if (random.one_in(2)) crowded_.threads = 2;
    if (random.one_in(8)) crowded_.engine = random.one_in(2) ? Engine::vatti : Engine::skvortsov;
    put_in_places(members_, places_);
  }

  std::vector<CrowdFailure> run(Shrink shrink) const {
    std::vector<std::size_t> all(members_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<CrowdFailure> failures;
    for (int form = 0; form < forms && failures.empty(); ++form) {
      for (const std::size_t member : differing(all, form)) failures.push_back({member, what(form, all.size())});
      if (!failures.empty() && shrink == Shrink::yes) failures[0].what += fewest(failures[0].member, form);
    }
    return failures;
  }

 private:
  // The chosen members whose polygons in the crowd differ from those that they have alone.
  std::vector<std::size_t> differing(const std::vector<std::size_t>& chosen, int form) const {
    std::vector<RegionSet> results(chosen.size());
    Operands all;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const Operands member = operands_of_form(members_[chosen[i]].operands, form);
      results[i] = run_form(member, form, alone_);
      append(all.a, member.a);
      append(all.b, member.b);
    }
    const std::uint64_t seed = seed_ + static_cast<std::uint64_t>(form);
    const Operands mixed{shuffled(all.a, request_.fill_a, seed), shuffled(all.b, request_.fill_b, seed ^ 1)};
    const RegionSet result = run_form(mixed, form, crowded_);
    if (result == put_in_order(results)) return {};
    return whose(result, chosen, results);
  }

  // The members with missing or different polygons. If each has the right ones, only the order is wrong: then the first
  // member.
  std::vector<std::size_t> whose(const RegionSet& result, const std::vector<std::size_t>& chosen,
                                 const std::vector<RegionSet>& results) const {
    const RegionView view = result;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const Box box = box_of(members_[chosen[i]].operands);
      RegionSet mine;
      for (std::size_t p = 0; p < view.polygon_count(); ++p) {
        if (box.contains(view.contour(view.polygon_begin(p)).front())) append_polygon(mine, view, p);
      }
      if (mine != results[i]) found.push_back(chosen[i]);
    }
    if (found.empty()) found.push_back(chosen.front());
    return found;
  }

  std::string what(int form, std::size_t size) const {
    const char* places = places_ == Places::row ? "row" : "scale";
    return std::string(name_of(form)) + " in a crowd of " + std::to_string(size) + ", seed " + std::to_string(seed_) +
           ", places " + places + ", " + to_text(request_) + (crowded_.threads == 2 ? " threads=2" : "") +
           " engine=" + std::to_string(static_cast<int>(crowded_.engine));
  }

  // Drops runs of other members while this one still differs.
  std::string fewest(std::size_t member, int form) const {
    std::vector<std::size_t> others;
    for (std::size_t m = 0; m < members_.size(); ++m) {
      if (m != member) others.push_back(m);
    }
    const auto fails = [&](const std::vector<std::size_t>& kept) {
      std::vector<std::size_t> chosen = kept;
      chosen.push_back(member);
      const std::vector<std::size_t> found = differing(chosen, form);
      return std::find(found.begin(), found.end(), member) != found.end();
    };
    if (!fails(others)) return "; it differs only in this very order";
    for (std::size_t run = others.size(); run > 0; run /= 2) {
      for (std::size_t i = 0; i < others.size();) {
        std::vector<std::size_t> fewer = others;
        const auto begin = fewer.begin() + static_cast<std::ptrdiff_t>(i);
        fewer.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(run, fewer.size() - i)));
        if (fails(fewer)) {
          others = std::move(fewer);
        } else {
          i += run;
        }
      }
    }
    return report(member, others, form);
  }

  std::string report(std::size_t member, const std::vector<std::size_t>& others, int form) const {
    std::string text = "; it still differs with " + std::to_string(others.size()) + " others:";
    Operands all = members_[member].operands;
    for (std::size_t i = 0; i < others.size(); ++i) {
      const CrowdMember& other = members_[others[i]];
      append(all.a, other.operands.a);
      append(all.b, other.operands.b);
      if (i < 8) text += std::string(" ") + other.generator->name + " " + std::to_string(other.seed);
    }
    all = operands_of_form(std::move(all), form);
    const Operation operation = form < 4 ? static_cast<Operation>(form) : Operation::unite;
    const auto fails = [&](const Operands& o) { return !is_local(o, operation, crowded_); };
    if (others.size() <= 8 && fails(all)) all = shrink(std::move(all), fails, 600);
    if (all.a.points.size() + all.b.points.size() > 400) return text;
    return text + "\n  A " + soup_to_wkt(all.a) + "\n  B " + soup_to_wkt(all.b);
  }

  std::vector<CrowdMember> members_;
  std::uint64_t seed_;
  Request request_;
  Places places_ = Places::row;
  Options alone_, crowded_;
};

}  // namespace

std::vector<CrowdFailure> run_crowd(std::vector<CrowdMember> members, std::uint64_t seed, Shrink shrink) {
  if (members.empty()) return {};
  try {
    return Crowd(std::move(members), seed).run(shrink);
  } catch (const std::exception& e) {
    return {{0, std::string("exception in a crowd, seed ") + std::to_string(seed) + ": " + e.what()}};
  }
}

}  // namespace oblast::generators
