// Text into a file, every error noticed.
#pragma once

#include <string>

namespace oblast::io {

/// Creates or replaces `path`; `name` stands for it in messages. Throws IoError.
void write_text(const std::string& path, const std::string& text, const std::string& name);

/// Throws IoError, also for a reader that went away where the signal for that is ignored.
void write_text_to_standard_output(const std::string& text);

}  // namespace oblast::io
