// The faults of a file's features as text, as JSON, and as columns of a point layer.
#pragma once

#include <oblast/check_features.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/layer.h"
#include "io/write_points.h"

namespace oblast::app {

class FaultReport {
 public:
  /// The layer and the features must stay.
  FaultReport(const io::Layer& layer, const FeatureView& features, std::vector<FeatureFault> faults);

  /// With notes.
  const std::vector<FeatureFault>& faults() const { return faults_; }
  bool has_faults() const;

  /// Counts by kind, and the first 20 faults that are no notes.
  std::string to_text(bool coverage) const;
  nlohmann::ordered_json to_json(const std::string& file, bool coverage) const;
  std::vector<io::PlaceColumn> columns() const;

 private:
  /// A place in the words of the file. Parts and rings count from 1, vertices from 0; -1: does not apply.
  struct Words {
    std::string file;
    std::int64_t feature = -1, part = -1, ring = -1, vertex = -1;
  };
  struct Counts {
    std::size_t faults = 0, features = 0;
  };

  Words words(const FeaturePlace& place) const;
  std::string text(const FeaturePlace& place) const;
  std::string text(const FeatureFault& fault) const;
  std::vector<Counts> count() const;
  nlohmann::ordered_json json(const FeaturePlace& place) const;

  const io::Layer& layer_;
  const FeatureView& features_;
  std::vector<FeatureFault> faults_;
};

}  // namespace oblast::app
