// docs/program-tests.md names tests. A test that is renamed or removed must not stay there.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "apps/program_run.h"

namespace oblast::test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> all_tests() {
  std::set<std::string> names;
  const std::regex declaration(R"(\bTEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(OBLAST_SOURCE_DIR) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = read_file(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), declaration), end; found != end; ++found)
      names.insert((*found)[1].str() + "." + (*found)[2].str());
  }
  return names;
}

TEST(ProgramTests, EveryTestOfTheTableIsThere) {
  const std::set<std::string> tests = all_tests();
  const std::string page = read_file(fs::path(OBLAST_SOURCE_DIR) / "docs" / "program-tests.md");
  const std::regex name(R"(`([A-Z]\w+\.\w+)`)");
  std::size_t named = 0;
  for (std::sregex_iterator found(page.begin(), page.end(), name), end; found != end; ++found, ++named)
    EXPECT_TRUE(tests.contains((*found)[1])) << "no test " << (*found)[1];
  EXPECT_GT(named, 60U);
}

}  // namespace
}  // namespace oblast::test
