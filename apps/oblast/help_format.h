// How help looks: descriptions are wrapped, and what must be given is said in words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace oblast::app {

/// In place of CLI11's formatter. Lines have at most 90 characters.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_footer(const CLI::App* app) const override;
};

}  // namespace oblast::app
