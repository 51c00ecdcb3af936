// The commands of `oblast generate`.
#pragma once

#include "oblast/cli.h"
#include "oblast/command.h"

namespace oblast::app {

void add_generate_fires(CLI::App& generate, Invocation& invocation);
void add_generate_roads(CLI::App& generate, Invocation& invocation);
void add_generate_star(CLI::App& generate, Invocation& invocation);

}  // namespace oblast::app
