#include "features/row_trial.h"

#include <oblast/features.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <functional>
#include <map>

#include "features/layers.h"
#include "generators/far.h"
#include "generators/random.h"
#include "verify/rows.h"

namespace oblast::testing {
namespace {

/// Rows with names that do not depend on their number.
struct NamedRows {
  FeatureSet rows;
  std::vector<std::vector<FeatureSource>> names;  ///< by row; of partition

  bool operator==(const NamedRows&) const = default;
};

struct Operation {
  std::string name;
  std::function<NamedRows(const Layer& a, const Layer& b, const Options&)> run;
  verify::KeysOfPlace keys;  ///< null: not checked
};

constexpr std::uint32_t group_count = 3;

/// Groups by feature: of new rows behind the old ones, the old ones keep theirs.
std::vector<std::uint32_t> groups_of(const Layer& layer, std::uint64_t seed) {
  return random_groups(layer, group_count, seed);
}

std::vector<std::uint32_t> present_groups(const std::vector<std::uint32_t>& features,
                                          const std::vector<std::uint32_t>& groups) {
  std::vector<std::uint32_t> found;
  found.reserve(features.size());
  for (const std::uint32_t f : features) found.push_back(groups[f]);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<Operation> operations(const Layers& layers, std::uint64_t seed) {
  std::vector<Operation> all;
  const std::pair<const char*, FeatureOperation> overlays[] = {
      {"intersection", FeatureOperation::intersection},
      {"identity", FeatureOperation::identity},
      {"union", FeatureOperation::unite},
      {"difference", FeatureOperation::difference},
      {"symmetric difference", FeatureOperation::symmetric_difference}};
  for (const auto& overlay : overlays) {
    const FeatureOperation operation = overlay.second;
    all.push_back({overlay.first,
                   [=](const Layer& a, const Layer& b, const Options& options) {
                     return NamedRows{overlay_features(a, b, operation, options), {}};
                   },
                   [=](const auto& i, const auto& j) { return verify::keys_of_place(operation, i, j); }});
  }
  const auto groups = groups_of(layers.a, seed);
  all.push_back({"dissolve",
                 [=](const Layer& a, const Layer&, const Options& options) {
                   return NamedRows{dissolve(a, groups_of(a, seed), options), {}};
                 },
                 [=](const auto& i, const auto&) {
                   std::vector<FeatureKey> keys;
                   for (const std::uint32_t g : present_groups(i, groups)) keys.push_back({g, no_feature});
                   return keys;
                 }});
  all.push_back({"depth",
                 [=](const Layer& a, const Layer&, const Options& options) {
                   return NamedRows{depth(a, {}, options), {}};
                 },
                 [=](const auto& i, const auto&) {
                   std::vector<FeatureKey> keys;
                   if (!i.empty()) keys.push_back({static_cast<std::uint32_t>(i.size()), no_feature});
                   return keys;
                 }});
  all.push_back({"depth by group",
                 [=](const Layer& a, const Layer&, const Options& options) {
                   return NamedRows{depth(a, groups_of(a, seed), options), {}};
                 },
                 [=](const auto& i, const auto&) {
                   std::vector<FeatureKey> keys;
                   const auto present = present_groups(i, groups);
                   if (!present.empty()) keys.push_back({static_cast<std::uint32_t>(present.size()), no_feature});
                   return keys;
                 }});
  all.push_back({"partition",
                 [=](const Layer& a, const Layer& b, const Options& options) {
                   const FeatureView views[] = {a, b};
                   Partition found = partition(views, options);
                   NamedRows rows;
                   for (std::size_t row = 0; row < found.rows.size(); ++row) {
                     const auto sources = found.sources_of(row);
                     rows.names.emplace_back(sources.begin(), sources.end());
                   }
                   rows.rows = std::move(found.rows);
                   return rows;
                 },
                 nullptr});
  return all;
}

class RowTrial {
 public:
  RowTrial(const generators::Operands& operands, std::uint64_t seed, bool exact)
      : operands_(operands), layers_(random_layers(operands, seed)), seed_(seed), exact_(exact) {
    generators::Random random(seed);
    options_.threads = 1;
    if (random.one_in(3)) options_.contours = ContourConvention::leonov_nikitin;
    if (random.one_in(3)) options_.collinear = CollinearVertices::drop;
    threads_ = random.one_in(8);
  }

  std::optional<RowFailure> run() const {
    for (const Operation& operation : operations(layers_, seed_)) {
      try {
        if (auto failure = run(operation)) return failure;
      } catch (const std::exception& e) {
        return RowFailure{BrokenRows::threw, operation.name, e.what()};
      }
    }
    return check_identities();
  }

 private:
  /// Equal results of calls that node the same edges: the same bytes.
  std::optional<RowFailure> check_identities() const {
    const std::vector<std::uint32_t> one(layers_.a.feature_ends.size(), 0);
    const FeatureSet row = dissolve(layers_.a, one, options_);
    if (row.regions != unite(layers_.a.regions, options_))
      return RowFailure{BrokenRows::identities, "dissolve", "one row is not the union"};
    const FeatureView twice[] = {layers_.a, layers_.a};
    const Partition alone = partition(std::span(twice, 1), options_), both = partition(twice, options_);
    // The rows of one are in another order than those of the other.
    if (by_first_layer(alone) != by_first_layer(both) || 2 * alone.sources.size() != both.sources.size())
      return RowFailure{BrokenRows::identities, "partition", "a layer with itself is not the layer"};
    return std::nullopt;
  }

  std::optional<RowFailure> run(const Operation& operation) const {
    const auto failure = [&](BrokenRows broken, std::string what) {
      return RowFailure{broken, operation.name, std::move(what)};
    };
    const NamedRows found = operation.run(layers_.a, layers_.b, options_);
    if (const auto fault = verify::check_rows(found.rows, options_.contours))
      return failure(BrokenRows::unverified, fault->what);
    const Layer a = shuffled_within_rows(layers_.a, seed_ + 1), b = shuffled_within_rows(layers_.b, seed_ + 2);
    if (operation.run(a, b, options_) != found) return failure(BrokenRows::order, "bytes change with the order");
    if (threads_) {
      Options two = options_;
      two.threads = 2;
      if (operation.run(a, b, two) != found) return failure(BrokenRows::threads, "bytes change with the threads");
    }
    if (auto what = changed_by_others(operation, found)) return failure(BrokenRows::far, *what);
    if (exact_ && operation.keys) {
      const bool one_layer = operation.name == "dissolve" || operation.name.starts_with("depth");
      const auto fault = verify::check_rows_against(layers_.a, one_layer ? Layer() : layers_.b, operation.keys,
                                                    found.rows, found.rows.keys);
      if (fault) return failure(BrokenRows::wrong, fault->what);
    }
    return std::nullopt;
  }

  static std::map<std::vector<std::uint32_t>, RegionSet> by_first_layer(const Partition& found) {
    std::map<std::vector<std::uint32_t>, RegionSet> rows;
    for (std::size_t row = 0; row < found.rows.size(); ++row) {
      std::vector<std::uint32_t> name;
      for (const FeatureSource& source : found.sources_of(row))
        if (source.layer == 0) name.push_back(source.feature);
      generators::append(rows[name], verify::regions_of(found.rows, row));
    }
    return rows;
  }

  using Rows = std::map<std::pair<FeatureKey, std::vector<FeatureSource>>, std::vector<RegionSet>>;

  static void add(Rows& rows, const NamedRows& from) {
    for (std::size_t row = 0; row < from.rows.size(); ++row) {
      RegionSet regions;
      generators::append(regions, verify::regions_of(from.rows, row));
      const bool named = !from.names.empty();
      rows[{named ? FeatureKey{} : from.rows.keys[row], named ? from.names[row] : std::vector<FeatureSource>{}}]
          .push_back(std::move(regions));
    }
  }

  /// Promise G7: with squares elsewhere, each row is that of the case and that of the squares, put in order.
  std::optional<std::string> changed_by_others(const Operation& operation, const NamedRows& alone) const {
    const generators::FarSquares squares = generators::far_squares(operands_, seed_);
    const NamedRows all = operation.run(with_rows(layers_.a, squares.a), with_rows(layers_.b, squares.b), options_);
    const NamedRows others =
        operation.run(only_new_rows(layers_.a, squares.a), only_new_rows(layers_.b, squares.b), options_);
    Rows expected, found;
    add(expected, alone);
    add(expected, others);
    add(found, all);
    if (expected.size() != found.size()) return "other rows with squares elsewhere";
    for (auto& [name, parts] : expected) {
      const auto it = found.find(name);
      if (it == found.end()) return "a row is missing with squares elsewhere";
      if (generators::put_in_order(parts) != it->second[0]) return "bytes change with squares elsewhere";
    }
    return std::nullopt;
  }

  const generators::Operands& operands_;
  Layers layers_;
  std::uint64_t seed_;
  bool exact_;
  Options options_;
  bool threads_ = false;
};

}  // namespace

const char* to_text(BrokenRows broken) {
  constexpr const char* names[] = {"unverified", "order", "far", "threads", "wrong", "identities", "exception"};
  return names[static_cast<int>(broken)];
}

std::optional<RowFailure> run_row_trial(const generators::Operands& operands, std::uint64_t seed, bool exact) {
  return RowTrial(operands, seed, exact).run();
}

}  // namespace oblast::testing
