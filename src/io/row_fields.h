// Fills features of GDAL with the attributes of rows. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <ogrsf_frmts.h>

#include <string>
#include <vector>

#include "io/field_plan.h"

namespace oblast::io {

class RowFields {
 public:
  RowFields(std::span<const OutputColumn> columns, const FieldPlan& plan) : columns_(columns), plan_(plan) {}

  std::size_t size() const { return columns_.size(); }
  const FieldPlan& plan() const { return plan_; }

  /// Field i of `feature` gets column i. REQUIRES: the fields of the feature have the types of the plan. Throws
  /// IoError for text that is too long or is not UTF-8.
  void fill(OGRFeature& feature, std::size_t row) const;

 private:
  void set_from_table(OGRFeature& feature, int field, const OutputColumn& column, std::size_t row) const;
  void set_text(OGRFeature& feature, int field, const std::string& text, std::size_t row) const;

  std::span<const OutputColumn> columns_;
  const FieldPlan& plan_;
};

/// Counts, by column, values that a file has in another form than they were given, and says so.
class ChangedValues {
 public:
  explicit ChangedValues(const RowFields& fields) : changed_(fields.size(), 0) {}
  /// `read`: the fields of the file, which may have others of its own.
  ChangedValues(const RowFields& fields, const OGRFeatureDefn& read);
  void compare(const OGRFeature& given, const OGRFeature& read);
  /// `changed` values of a column, counted elsewhere.
  void add(std::size_t column, std::uint64_t changed) { changed_[column] += changed; }
  std::vector<std::string> notes(const RowFields& fields) const;

 private:
  std::vector<std::uint64_t> changed_;
  std::vector<int> field_read_;  // by column; -1: the file does not have it
};

}  // namespace oblast::io
