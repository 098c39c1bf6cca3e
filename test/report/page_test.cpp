// Reports: well-formed whatever the names, self-contained, complete on disk or absent.
#include <cable_variation/report/page.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include <cable_variation/report/chart.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/util/output_file.h>
#include <cable_variation/util/display_unit.h>
#include <report/well_formed.h>

namespace cable_variation {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Every character that markup gives a meaning, and what XML cannot hold: control characters, bytes that are
/// no UTF-8, half of a pair of UTF-16, U+FFFF.
const std::string kNasty = "<b>\"R&D\" & 'x' ]]> --\x01\xff\xed\xa0\x80\xef\xbf\xbf ü";

ReportSection nastySection() {
  ReportSection section(kNasty);
  section.heading(kNasty);
  section.paragraph(kNasty);
  section.warning(kNasty);
  section.banner(Tone::bad, kNasty, kNasty);
  section.table({kNasty, {kNasty, "two\nlines"}, {{{kNasty, 0.0, false}, {kNasty, 0.7, true}}}});
  section.chart(barChart({{kNasty, 2.0, kNasty}, {"none", 0.0, "0"}}), kNasty);
  section.chart(lowHighChart(1.0, {{kNasty, 0.5, 2.0}, {"gone", kNan, kNan}}, 0.4, 5.0), kNasty);
  return section;
}

TEST(ReportPage, IsWellFormedWhateverTheNames) {
  const std::string page =
      reportPage(kNasty, {{kNasty, kNasty}, {"", ""}}, {kNasty}, {nastySection(), nastySection()});
  EXPECT_EQ(faultOfXml(page), "");
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;&quot;R&amp;D&quot; &amp; &#39;x&#39;"), std::string::npos);
}

TEST(ReportPage, OfNothingIsWellFormed) {
  EXPECT_EQ(faultOfXml(reportPage("empty", {}, {}, {})), "");
  ReportSection section("charts of nothing");
  section.chart(barChart({}), "");
  section.chart(lowHighChart(3.0, {}, std::nullopt, std::nullopt), "");
  EXPECT_EQ(faultOfXml(reportPage("empty", {}, {}, {section})), "");
}

TEST(ReportPage, LoadsNothing) {
  const std::string page = reportPage("page", {}, {}, {nastySection()});
  // Namespaces are names; everything else with an address would be a resource.
  for (const char* attribute : {"src=", "url(", "@import", "<script", "<link", "href=\"http"}) {
    EXPECT_EQ(page.find(attribute), std::string::npos) << attribute;
  }
}

TEST(ReportPage, KeepsItsSectionsInOrder) {
  const std::string page = reportPage("page", {}, {}, {ReportSection("first"), ReportSection("second")});
  EXPECT_LT(page.find("<h2>first</h2>"), page.find("<h2>second</h2>"));
  EXPECT_NE(page.find("href=\"#section-2\""), std::string::npos);
}

TEST(ReportPage, TellsItsWarningsBeforeAnyFigure) {
  const std::string page =
      reportPage("page", {{"Scene", "about"}}, {"a < b", "mm?"}, {ReportSection("first")});
  EXPECT_NE(page.find("a &lt; b</p>"), std::string::npos);
  EXPECT_LT(page.find("about"), page.find("a &lt; b</p>"));
  EXPECT_LT(page.find("mm?</p>"), page.find("<section"));
}

TEST(ReportSection, SentencesInTablesWrapAndFiguresDoNot) {
  ReportSection section("tables");
  section.table(
      {"", {"a", "b", "c"}, {{{"row"}, {"1.25 … 3.5"}, {"a note that is longer than figures ever are"}}}});
  EXPECT_NE(section.html().find("<td>1.25"), std::string::npos);
  EXPECT_NE(section.html().find("<td class=\"text\">a note"), std::string::npos);
}

TEST(Figure, IsShortAndTrue) {
  EXPECT_EQ(figure(0.123456), "0.1235");
  EXPECT_EQ(figure(-12.5), "−12.5");
  EXPECT_EQ(figure(-0.0), "0");
  EXPECT_EQ(figure(-1e-61), "0");  // rounding
  EXPECT_EQ(figure(2e-14), "2e-14");
  EXPECT_EQ(figure(kNan), "–");
  EXPECT_EQ(displayUnit("m").factor * 0.25, 250.0);
  EXPECT_DOUBLE_EQ(displayUnit("rad").factor * M_PI, 180.0);
  EXPECT_EQ(displayUnit("rad").symbol, "deg");  // as the console has them: scripts/solver_client.py
  EXPECT_EQ(displayUnit("Pa").symbol, "MPa");
  EXPECT_DOUBLE_EQ(displayUnit("Pa").factor * 2e7, 20.0);
  EXPECT_EQ(displayUnit("1").symbol, "%");
  EXPECT_DOUBLE_EQ(displayUnit("1").factor * 0.15, 15.0);
  EXPECT_EQ(displayUnit("N m").symbol, "N m");
}

TEST(BarChart, IsToScale) {
  const std::string chart = barChart({{"a", 0.75, "75 %"}, {"b", 0.25, "25 %"}});
  std::vector<double> widths;
  for (std::size_t at = chart.find("<rect"); at != std::string::npos; at = chart.find("<rect", at + 1)) {
    const std::size_t value = chart.find("width=\"", at) + 7;
    widths.push_back(std::stod(chart.substr(value)));
  }
  ASSERT_EQ(widths.size(), 2u);
  EXPECT_NEAR(widths[0] / widths[1], 3.0, 0.01);
}

class WrittenFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "report_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  std::filesystem::path folder_;
};

TEST_F(WrittenFile, IsCompleteAndAlone) {
  const std::filesystem::path path = folder_ / "a b.html";
  writeFile(path.string(), "old and longer than what follows");
  writeFile(path.string(), std::string("new\0\n", 5));
  std::ifstream file(path, std::ios::binary);
  std::stringstream contents;
  contents << file.rdbuf();
  EXPECT_EQ(contents.str(), std::string("new\0\n", 5));
  EXPECT_EQ(files(), 1u);
}

TEST_F(WrittenFile, ThatCannotBeIsNamedAndLeavesNothing) {
  const std::filesystem::path folder = folder_ / "taken";
  std::filesystem::create_directory(folder);
  // A folder stands where the file should be; another is not there at all.
  for (const std::filesystem::path& path : {folder, folder_ / "missing" / "report.html"}) {
    try {
      writeFile(path.string(), "x");
      ADD_FAILURE() << path << " was written";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace cable_variation
