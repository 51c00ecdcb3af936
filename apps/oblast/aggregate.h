// The columns of groups: what becomes of the values of the rows of a group.
#pragma once

#include <string>

#include "oblast/groups.h"
#include "oblast/row_job.h"

namespace oblast::app {

enum class Aggregation {
  first,  ///< the first value that is not null
  last,
  sum,  ///< of numbers; of integers it is a 64-bit integer
  mean,
  min,
  max,
  count,  ///< how many values are not null
  list,   ///< the values that are not null
};

struct Aggregate {
  std::string column;
  Aggregation function;
};

/// "people:sum". Throws CLI::ValidationError.
Aggregate parse_aggregate(const std::string& word);
std::string name(Aggregation function);

/// Adds the column `name`: a value for each group. If a group has only nulls, its value is null, or 0 for `count`.
/// Throws IoError if the column has no numbers and the function needs them, or if a sum is too large.
void add_aggregate(const io::AttributeTable& table, std::size_t column, Aggregation function, const std::string& name,
                   const Groups& groups, ResultColumns& columns);

}  // namespace oblast::app
