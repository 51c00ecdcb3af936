// Two columns, wrapped; see help_format.h.
#include "oblast/help_format.h"

#include <CLI/CLI.hpp>

namespace oblast::app {

namespace {

constexpr std::size_t first_column = 26, line_width = 90;

// "  name     text, which goes on in the second column". A long name has a line of its own.
std::string row(const std::string& name, const std::string& text) {
  std::string out = "  " + name;
  std::size_t column = out.size();
  const auto next_line = [&] {
    out += "\n" + std::string(first_column, ' ');
    column = first_column;
  };
  if (column + 2 > first_column) {
    next_line();
  } else {
    out.append(first_column - column, ' ');
    column = first_column;
  }
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (column > first_column && column + 1 + end - at > line_width) next_line();
    if (column > first_column) out += ' ', ++column;
    out.append(text, at, end - at);
    column += end - at;
    at = end + 1;
  }
  return out + "\n";
}

}  // namespace

HelpFormatter::HelpFormatter() { label("Positionals", "Arguments"); }

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  std::string usage = "Usage: " + name;
  for (const CLI::Option* option : app->get_options())
    if (option->get_positional()) usage += " " + make_option_usage(option);
  if (!app->get_subcommands({}).empty()) usage += " COMMAND";
  for (const CLI::Option* option : app->get_options()) {
    if (!option->nonpositional() || !option->get_required()) continue;
    const bool has_short = !option->get_snames().empty();
    const std::string word = has_short ? "-" + option->get_snames().front() : "--" + option->get_lnames().front();
    usage += " " + word + make_option_opts(option);
  }
  return usage + " [OPTIONS]\n";
}

// CLI11 would add that exactly one command is required.
std::string HelpFormatter::make_description(const CLI::App* app) const { return app->get_description() + "\n"; }

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  const std::string name = make_option_name(option, is_positional) + (is_positional ? "" : make_option_opts(option));
  return row(name, make_option_desc(option));
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0) return {};
  // What a check adds to the type is for its error messages: "N:INT in [0 - 1024]".
  std::string type = option->get_type_name();
  if (const std::size_t range = type.find(" in ["); range != std::string::npos) type.resize(type.rfind(':', range));
  return type.empty() ? "" : " " + type;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return row(command->get_name(), command->get_description());
}

// Raw strings begin with a line break.
std::string HelpFormatter::make_footer(const CLI::App* app) const {
  const std::string footer = app->get_footer();
  return footer.empty() ? "" : footer.substr(footer.front() == '\n' ? 1 : 0) + "\n";
}

}  // namespace oblast::app
