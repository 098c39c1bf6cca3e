// Results as tables: sorted by value, copied as text that a spreadsheet reads; the heat map readable.
#include <rviz_plugins/panel/heat_map_model.h>
#include <rviz_plugins/panel/measure_table_model.h>
#include <rviz_plugins/panel/result_model.h>

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>

namespace cable_variation_rviz {
namespace {

class ResultTablesTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int count = 1;
    static char name[] = "result_tables_test";
    static char* arguments[] = {name, nullptr};
    if (qApp == nullptr) application_ = std::make_unique<QApplication>(count, arguments);
  }
  static void TearDownTestSuite() { application_.reset(); }

  static std::unique_ptr<QApplication> application_;
};
std::unique_ptr<QApplication> ResultTablesTest::application_;

void fill(ResultModel& model) {
  model.setTable({"Cable", headerWithUnit("Length", "m")},
                 {{textCell("ten"), numberCell(0.010, "m")},
                  {textCell("nine"), numberCell(0.009, "m")},
                  {textCell("two\tlines\nof text"), numberCell(0.1, "m")}});
}

QString copied(CopyableTable& table) {
  QApplication::clipboard()->clear();
  QKeyEvent copy(QEvent::KeyPress, Qt::Key_C, Qt::ControlModifier);
  QApplication::sendEvent(&table, &copy);
  return QApplication::clipboard()->text();
}

TEST_F(ResultTablesTest, CtrlCCopiesTabSeparatedText) {
  ResultModel model;
  fill(model);
  CopyableTable table;
  table.show(&model);
  EXPECT_EQ(copied(table), "Cable\tLength [mm]\nten\t10\nnine\t9\ntwo lines of text\t100\n");
  table.selectRow(1);
  EXPECT_EQ(copied(table), "Cable\tLength [mm]\nnine\t9\n");
}

TEST_F(ResultTablesTest, AClickOnAHeaderSortsByTheNumber) {
  ResultModel model;
  fill(model);
  CopyableTable table;
  table.show(&model);
  const auto click = [&] { Q_EMIT table.horizontalHeader()->sectionClicked(1); };
  const auto first = [&] { return table.model()->index(0, 1).data().toString(); };
  EXPECT_EQ(first(), "10");
  click();
  EXPECT_EQ(first(), "9");  // as texts, 10 would be first
  EXPECT_EQ(table.sourceRow(table.model()->index(0, 0)), 1);
  click();
  EXPECT_EQ(first(), "100");
  click();
  EXPECT_EQ(first(), "10");  // as it came
}

TEST_F(ResultTablesTest, MeasuresHaveAVerdictAsSignAndColour) {
  cable_variation::MeasureResult kept, broken, unlimited;
  kept.name = "kept";
  kept.unit = broken.unit = unlimited.unit = "m";
  kept.value = 0.006;
  kept.has_lower = kept.within = true;
  kept.lower = 0.005;
  broken = kept;
  broken.name = "broken";
  broken.value = 0.004;
  broken.within = false;
  unlimited.name = "unlimited";
  unlimited.value = std::numeric_limits<double>::infinity();
  MeasureTableModel model;
  model.setMeasures({kept, broken, unlimited});
  const auto text = [&](int row, int column) { return model.index(row, column).data().toString(); };
  EXPECT_EQ(text(0, MeasureTableModel::kName), QString::fromUtf8("\u2714 kept"));
  EXPECT_EQ(text(1, MeasureTableModel::kName), QString::fromUtf8("\u2718 broken"));
  EXPECT_EQ(text(0, MeasureTableModel::kValue), "6");
  EXPECT_EQ(text(0, MeasureTableModel::kUnit), "mm");
  EXPECT_EQ(text(0, MeasureTableModel::kLimits), QString::fromUtf8("\u2265 5"));
  EXPECT_EQ(text(2, MeasureTableModel::kValue), "infinite");
  EXPECT_EQ(text(2, MeasureTableModel::kLimits), "");
  const auto colour = [&](int row) {
    return model.index(row, 0).data(Qt::ForegroundRole).value<QBrush>().color();
  };
  EXPECT_GT(colour(0).green(), colour(0).red());
  EXPECT_GT(colour(1).red(), colour(1).green());
  model.setOutdated(true);
  EXPECT_FALSE(text(1, MeasureTableModel::kName).contains(QString::fromUtf8("\u2718")));
}

/// Contrast of two colours (WCAG 2): 1 to 21.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& colour) {
    const auto linear = [](double c) {
      return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
  };
  const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

TEST_F(ResultTablesTest, NumbersOnTheHeatMapAreReadable) {
  constexpr double kReadable = 4.5;  // WCAG 2, level AA
  for (double share = 0.0; share <= 1.0; share += 0.01) {
    EXPECT_GT(contrast(heatColour(share), lettersOn(heatColour(share))), kReadable) << share;
  }
  EXPECT_GT(contrast(heatColour(std::nan("")), lettersOn(heatColour(std::nan("")))), kReadable);
}

TEST_F(ResultTablesTest, TheHeatMapHasAVariableARow) {
  HeatMapModel model;
  model.setMatrix({{"v1", "v2", "v3"}, {"m1", "m2"}, {0.1, 0.2, 0.7, 1.0, 0.001, 0.0}, {}});
  EXPECT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.columnCount(), 2);
  EXPECT_EQ(model.index(2, 0).data().toString(), "70");
  EXPECT_EQ(model.index(0, 1).data().toString(), "100");
  EXPECT_EQ(model.index(1, 1).data().toString(), "<1");
  EXPECT_EQ(model.index(2, 1).data().toString(), "0");
  EXPECT_EQ(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), "m2");
  HeatMap map;
  map.setMatrix({{"v1", "v2"}, {"m1"}, {0.25, 0.75}, {}});
  EXPECT_EQ(copied(map), "\tm1\nv1\t25\nv2\t75\n");
}

}  // namespace
}  // namespace cable_variation_rviz
