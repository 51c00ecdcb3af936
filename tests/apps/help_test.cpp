// `oblast help`, and what a mistyped word is answered with.
#include <gtest/gtest.h>

#include <sstream>

#include "apps/program_run.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;

// The names of the commands, from the help of the program.
Words commands() {
  const std::string help = oblast_program({"--help"}).out;
  std::istringstream lines(help.substr(help.find("\nCommands:\n")));
  Words names;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ") && line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

TEST(Help, IsThatOfTheOption) {
  EXPECT_EQ(oblast_program({"help"}).out, oblast_program({"--help"}).out);
  EXPECT_GT(commands().size(), 12u);
  for (const std::string& command : commands()) {
    const ProgramRun run = oblast_program({"help", command});
    EXPECT_EQ(run.code, 0) << command;
    EXPECT_EQ(run.out, oblast_program({command, "--help"}).out);
  }
  EXPECT_EQ(oblast_program({"help", "generate", "star"}).out, oblast_program({"generate", "star", "--help"}).out);
}

// Lines fit a terminal of a hundred characters.
TEST(Help, LinesAreShort) {
  Words texts{oblast_program({"help"}).out, oblast_program({"help", "recipes"}).out,
              oblast_program({"help", "generate", "star"}).out, oblast_program({"help", "generate", "fires"}).out};
  for (const std::string& command : commands()) texts.push_back(oblast_program({"help", command}).out);
  for (const std::string& text : texts) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  }
}

TEST(Help, AMistypedCommandIsAnsweredWithTheOneThatWasMeant) {
  const std::pair<const char*, const char*> words[] = {
      {"unoin", "`oblast union`"},     {"disolve", "`oblast dissolve`"},
      {"clpi", "`oblast clip`"},       {"intersection", "`oblast overlay intersection`"},
      {"merge", "`oblast union`"},     {"validate", "`oblast check`"},
      {"Overlay", "`oblast overlay`"}, {"recipes", "`oblast help recipes`"},
  };
  for (const auto& [word, meant] : words) {
    const ProgramRun run = oblast_program({word, "a.gpkg", "-o", "b.gpkg"});
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, std::string("there is no command '") + word + "'")) << run.err;
    EXPECT_TRUE(contains(run.err, std::string("Did you mean ") + meant + "?")) << run.err;
  }
  const ProgramRun far = oblast_program({"frobnicate"});
  EXPECT_EQ(far.code, 2);
  EXPECT_FALSE(contains(far.err, "Did you mean")) << far.err;
  const ProgramRun help = oblast_program({"help", "unoin"});
  EXPECT_EQ(help.code, 2);
  EXPECT_TRUE(contains(help.err, "did you mean `oblast union`?")) << help.err;
}

TEST(Help, AMistypedOptionIsAnsweredWithTheOneThatWasMeant) {
  const ProgramRun run = oblast_program({"union", "a.gpkg", "-o", "b.gpkg", "--overwite"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--overwite")) << run.err;
  EXPECT_TRUE(contains(run.err, "Did you mean --overwrite?")) << run.err;
}

}  // namespace
}  // namespace oblast::test
