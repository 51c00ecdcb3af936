// What every command that computes may be told of the call: threads and memory.
#pragma once

#include <oblast/options.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>

namespace oblast::app {

/// "4GiB", "500 MB", "1.5GiB", "1000": bytes, by powers of 1024 (KiB, MiB, GiB, TiB) or of 1000 (KB, MB, GB, TB),
/// rounded down. Throws CLI::ValidationError for anything else, and for less than a byte.
std::size_t parse_bytes(const std::string& word);

/// --threads and --memory.
void add_call_options(CLI::App& command, CallOptions& options);

}  // namespace oblast::app
