// The words of the command line for the enumerators of the library.
#pragma once

#include <oblast/features.h>
#include <oblast/options.h>

#include <optional>
#include <string>

namespace oblast::app {

/// These functions throw CLI::ValidationError, whose message lists the valid words.
Operation parse_operation(const std::string& word);  ///< intersection | union | difference | symdifference
FeatureOperation parse_feature_operation(const std::string& word);  ///< those, and identity
Engine parse_engine(const std::string& word);                       ///< leonov-nikitin | vatti | skvortsov
FillRule parse_fill(const std::string& word);  ///< polygons | atleast:K | evenodd | nonzero | positive | negative
ContourConvention parse_contours(const std::string& word);  ///< ogc | leonov-nikitin

std::string name(Operation operation);
std::string name(FeatureOperation operation);
std::string name(Engine engine);
std::string name(const FillRule& rule);
std::string name(ContourConvention convention);
std::string name(Stage stage);
/// What the stage does, for somebody who waits: "finding crossings".
std::string plain_name(Stage stage);

/// The operation of two regions with the same name; none for identity.
std::optional<Operation> merged_operation(FeatureOperation operation);

}  // namespace oblast::app
