// The page of recipes.
#pragma once

namespace oblast::app {

/// Markdown that also reads well on a terminal. docs/recipes.md is the same text, and a test runs every command in it.
extern const char* const recipes;

}  // namespace oblast::app
