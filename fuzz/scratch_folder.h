// A folder for the files of one fuzzer.
#pragma once

#include <filesystem>

namespace oblast::fuzz {

/// Made at the first call and empty then, one a process, since fuzzers run side by side; removed when the process ends
/// without a finding.
const std::filesystem::path& scratch_folder();

/// Removes what is in the folder.
void empty_scratch_folder();

}  // namespace oblast::fuzz
