// Tables of reports as text.
#include <command/text_table.h>

#include <gtest/gtest.h>

#include <command/status_line.h>

namespace cable_variation_command {
namespace {

using cable_variation::plain;

TEST(TextTable, ColumnsAreAsWideAsTheyNeedToBe) {
  const cable_variation::ReportTable table{
      "", {"cable", "length\n[mm]"}, {{plain("main"), plain("312")}, {plain("ä"), plain("−1.5")}}};
  EXPECT_EQ(tableText(table),
            "  cable  length\n"
            "           [mm]\n"
            "  main      312\n"
            "  ä        −1.5\n");
}

TEST(TextTable, SentencesAreFlushLeft) {
  const cable_variation::ReportTable table{
      "", {"figure", "what"}, {{plain("a"), plain("within the mesh")}, {plain("b"), plain("at s")}}};
  EXPECT_EQ(tableText(table),
            "  figure  what\n"
            "  a       within the mesh\n"
            "  b       at s\n");
}

TEST(TextTable, LongTextsAreBrokenAtBlanks) {
  const std::string word(60, 'x');
  EXPECT_EQ(wrapped(word + " " + word), word + "\n  " + word + "\n");
}

TEST(StatusLineText, TellsHowFarItIs) {
  cable_variation::Progress progress{"samples", 0.25, 1200};
  progress.wanted = 4800;
  progress.snapped = 2;
  EXPECT_EQ(progressText(progress, 10.0),
            "  samples     [######..................]  25 %  1200 of 4800  2 snapped  about 30 s left");
  EXPECT_EQ(progressText({"reading"}, 1.0), "  reading    ");
}

}  // namespace
}  // namespace cable_variation_command
