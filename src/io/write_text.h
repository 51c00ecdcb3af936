// Writes text to a file and reports every error.
#pragma once

#include <string>

namespace oblast::io {

/// Creates or replaces `path`; `name` stands for it in messages. Throws IoError.
void write_text(const std::string& path, const std::string& text, const std::string& name);

/// Throws IoError, also if the reader of a pipe has ended and SIGPIPE is ignored.
void write_text_to_standard_output(const std::string& text);

}  // namespace oblast::io
