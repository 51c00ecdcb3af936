// The options of every command that computes: threads and memory.
#pragma once

#include <oblast/options.h>

#include <cstddef>
#include <string>

#include "oblast/cli.h"

namespace oblast::app {

/// The number of bytes in a word such as "4GiB", "500 MB", "1.5GiB" or "1000", rounded down. Units are powers of 1024
/// (KiB, MiB, GiB, TiB) or of 1000 (KB, MB, GB, TB). Throws CLI::ValidationError for anything else, and for less than a
/// byte.
std::size_t parse_bytes(const std::string& word);

/// Adds --threads and --memory.
void add_call_options(CLI::App& command, CallOptions& options);

}  // namespace oblast::app
