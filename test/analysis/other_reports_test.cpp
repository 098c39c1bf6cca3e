// Reports of several kinds under one name: the newest has the name, and none is lost.
#include <cable_variation/analysis/other_reports.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cable_variation/analysis/answer_files.h>
#include <cable_variation/report/page.h>
#include <cable_variation/util/error.h>

namespace cable_variation {
namespace {

namespace fs = std::filesystem;

class OtherReports : public testing::Test {
 protected:
  OtherReports() { fs::create_directories(folder_); }
  ~OtherReports() override { fs::remove_all(folder_); }

  void put(const std::string& file, const std::string& text) const { std::ofstream(folder_ / file) << text; }
  std::string textOf(const std::string& file) const {
    std::ifstream stream(folder_ / file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static std::string page(const std::string& kind, const std::string& title) {
    return reportPage(title, {}, {}, {}, kind);
  }
  std::string write(const std::string& extension, const std::string& text) {
    return writeBeside(output_, "run", extension, text, error_);
  }

  fs::path folder_ = fs::temp_directory_path() / (std::to_string(getpid()) + "_reports");
  OutputDirectory output_{folder_.string()};
  std::string error_;
};

TEST_F(OtherReports, OfAnotherKindAreKeptWithTheirTables) {
  write(".html", page("Stability analysis", "first"));
  write(".csv", "first table");
  write(".html", page("Equilibrium", "second"));
  EXPECT_EQ(error_, "");
  EXPECT_EQ(textOf("run.html"), page("Equilibrium", "second"));
  EXPECT_EQ(textOf("run_stability_analysis.html"), page("Stability analysis", "first"));
  EXPECT_EQ(textOf("run_stability_analysis.csv"), "first table");
  EXPECT_FALSE(fs::exists(folder_ / "run.csv"));
}

TEST_F(OtherReports, OfTheSameKindAreReplaced) {
  write(".html", page("Equilibrium", "first"));
  write(".html", page("Equilibrium", "second"));
  EXPECT_EQ(textOf("run.html"), page("Equilibrium", "second"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(OtherReports, WhateverTheOrderTheNewestOfEachKindIsThere) {
  const std::vector<std::string> kinds{"Equilibrium", "Stability analysis", "Tolerance envelope",
                                       "Path check"};
  std::mt19937 random(3);
  std::map<std::string, std::string> newest;
  for (int i = 0; i < 100; ++i) {
    const std::string& kind = kinds[random() % kinds.size()];
    newest[kind] = page(kind, "run " + std::to_string(i));
    ASSERT_NE(write(".html", newest[kind]), "");
    ASSERT_EQ(textOf("run.html"), newest[kind]);
    for (const auto& [other, wanted] : newest) {
      std::size_t found = 0;
      for (const auto& file : fs::directory_iterator(folder_))
        found += textOf(file.path().filename()) == wanted ? 1 : 0;
      ASSERT_EQ(found, 1U) << other << " after " << i;
    }
  }
}

TEST_F(OtherReports, WhatIsNoReportIsLeftToBeReplaced) {
  const std::string elsewhere = (folder_ / "elsewhere").string();
  put("run.html", "<html>something</html>");
  put("elsewhere", page("Equilibrium", "elsewhere"));
  keepOtherReport(output_, "run", "Path check");
  EXPECT_EQ(textOf("run.html"), "<html>something</html>");
  fs::create_symlink(elsewhere, folder_ / "linked.html");
  keepOtherReport(output_, "linked", "Path check");
  EXPECT_TRUE(fs::is_symlink(folder_ / "linked.html"));
  fs::create_directory(folder_ / "folder.html");
  keepOtherReport(output_, "folder", "Path check");
  keepOtherReport(output_, "nothing", "Path check");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 4);
}

TEST_F(OtherReports, OneThatCannotBeKeptIsNotReplaced) {
  const std::string first = page("Equilibrium", "first");
  write(".html", first);
  fs::create_directories(folder_ / "run_equilibrium.html" / "in the way");
  EXPECT_EQ(write(".html", page("Path check", "second")), "");
  EXPECT_NE(error_.find("run_equilibrium.html"), std::string::npos) << error_;
  EXPECT_EQ(textOf("run.html"), first);
}

TEST(ReportKind, IsReadBackFromItsFirstBytes) {
  const std::string long_title(10000, 'x');
  EXPECT_EQ(reportKind(reportPage(long_title, {}, {}, {}, "Path check").substr(0, 1000)), "Path check");
  EXPECT_EQ(reportKind(reportPage("x", {}, {}, {})), "");
  EXPECT_EQ(reportKind(""), "");
}

}  // namespace
}  // namespace cable_variation
