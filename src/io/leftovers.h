// Stages (staged_output.h) that killed programs left behind.
#pragma once

#include <filesystem>
#include <string>

namespace oblast::io {

/// Characters at the end of the name of a stage.
inline constexpr int stage_suffix_length = 6;

/// Removes the stages of the target `file_name` in the folder `parent` that no living program has locked.
void remove_leftovers(const std::filesystem::path& parent, const std::string& file_name);

/// The random end of the name of a stage.
std::string stage_suffix();
/// Says that a stage is in use, until the number that is returned is closed or the program ends. Negative: it cannot.
int lock_stage(const std::string& folder);

}  // namespace oblast::io
