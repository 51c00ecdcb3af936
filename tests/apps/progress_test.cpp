// The progress bar: one from start to end, in plain words, on a terminal only.
#include <gtest/gtest.h>

#include <regex>

#include "apps/program_run.h"
#include "oblast/console.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;

void expect_one_bar(const Words& call, const Words& words) {
  const ProgramRun run = program_on_terminal(call);
  ASSERT_EQ(run.code, 0) << run.err;
  const std::regex line("\\r\\x1b\\[K\\[([# ]{24})\\] +(\\d+) %  ([^,\\r]*)");
  int before = 0;
  std::size_t next = 0;
  for (std::sregex_iterator it(run.err.begin(), run.err.end(), line), end; it != end; ++it) {
    const int percent = std::stoi((*it)[2]);
    EXPECT_GE(percent, before);
    before = percent;
    EXPECT_NEAR(static_cast<double>(std::count((*it)[1].first, (*it)[1].second, '#')), percent * 0.24, 1);
    if (next < words.size() && (*it)[3] == words[next]) ++next;
  }
  EXPECT_EQ(next, words.size()) << "not shown in this order: " << words[std::min(next, words.size() - 1)] << "\n"
                                << run.err;
  // The bar is gone when the summary comes, which is on standard output after a check.
  EXPECT_TRUE(contains(run.err, "\r\x1b[K" + call[0]) || (call[0] == "check" && run.err.ends_with("\r\x1b[K")))
      << run.err;
}

TEST(Progress, OneBarGoesFromReadingToDrawing) {
  const Folder folder;
  write_file(folder / "a.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  write_file(folder / "b.wkt", "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))");
  const std::string a = folder.path("a.wkt"), b = folder.path("b.wkt");
  expect_one_bar({"union", a, b, "-o", folder.path("u.gpkg"), "--svg", folder.path("u.svg")},
                 {"reading input", "writing", "drawing"});
  expect_one_bar({"overlay", "union", a, b, "-o", folder.path("o.gpkg")}, {"reading A", "reading B", "writing"});
  expect_one_bar({"clip", a, b, "-o", folder.path("c.gpkg")}, {"reading IN", "reading WINDOW", "writing"});
  write_file(folder / "c.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  expect_one_bar({"check", folder.path("c.wkt"), "--coverage", "--faults", folder.path("f.gpkg")},
                 {"reading", "looking at each feature", "looking between the features", "writing"});
}

TEST(Progress, IsQuietWhereThereIsNoTerminalOrNobodyWantsIt) {
  const Folder folder;
  write_file(folder / "a.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  const Words call{"union", folder.path("a.wkt"), "-o", folder.path("u.gpkg"), "--overwrite"};
  EXPECT_FALSE(contains(oblast_program(call).err, " %"));
  Words quiet = call;
  quiet.push_back("-q");
  EXPECT_EQ(program_on_terminal(quiet).err, "");
}

TEST(Progress, TimeLeftIsInWordsForSomebodyWhoWaits) {
  EXPECT_EQ(app::waiting_time(0.2), "1 s");
  EXPECT_EQ(app::waiting_time(12), "12 s");
  EXPECT_EQ(app::waiting_time(200), "3 min 20 s");
  EXPECT_EQ(app::waiting_time(7500), "2 h 5 min");
}

}  // namespace
}  // namespace oblast::test
