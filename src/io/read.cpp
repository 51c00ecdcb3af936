// Reads any number of files as one operand, without attributes.
#include "io/read.h"

#include "io/read_parts.h"

namespace oblast::io {

Layer read(std::span<const std::string> paths, const ReadOptions& options) {
  Parts parts = read_parts(paths, options, Attributes::pass_over);
  return join_layers(parts);
}

}  // namespace oblast::io
