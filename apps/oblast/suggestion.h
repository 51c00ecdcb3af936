// What a mistyped word may have meant.
#pragma once

#include <string>

#include "oblast/cli.h"

namespace oblast::app {

/// What to type in place of a command that there is not: "oblast union" for "unoin" (one or two slips), "oblast overlay
/// intersection" for "intersect" (what others call it). Empty if nothing is near.
std::string suggested_command(const CLI::App& program, const std::string& word);

/// The option of a command that is nearest to a word such as "--overwite". Empty if none is near.
std::string suggested_option(const CLI::App& command, const std::string& word);

}  // namespace oblast::app
