// The panel in a real RViz with real nodes: worked with mouse and keys, checked by what the solver's topics
// tell. Run by review_panel.test, which starts the nodes, on a display of Xvfb.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPixmap>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <QtTest/QTest>

#include <cable_variation/CableShapes.h>
#include <cable_variation/DesignState.h>
#include <cable_variation/Legend.h>
#include <cable_variation/LoadScene.h>

#include <rviz_plugins/panel/message_line.h>
#include <rviz_plugins/panel/variable_table_model.h>

#include "eventually.h"

namespace cable_variation_rviz {
namespace {

class ReviewPanelTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    frame_ = std::make_unique<rviz::VisualizationFrame>();
    frame_->setApp(qApp);
    frame_->setSplashPath("");
    frame_->initialize(QString::fromStdString(config()));
    frame_->resize(1600, 900);
    frame_->show();
  }
  static void TearDownTestSuite() { frame_.reset(); }

  void SetUp() override {
    design_ = node_.subscribe<cable_variation::DesignState>(
        "/cable_solver/design", 1, [this](const cable_variation::DesignStateConstPtr& m) { state_ = m; });
    shapes_ = node_.subscribe<cable_variation::CableShapes>(
        "/cable_solver/shapes", 1, [this](const cable_variation::CableShapesConstPtr& m) { shape_ = m; });
    legend_ = node_.subscribe<cable_variation::Legend>(
        "/cable_solver/legend", 1, [this](const cable_variation::LegendConstPtr& m) { colours_ = m; });
    ASSERT_TRUE(eventually([&] { return variables() != nullptr && variables()->model()->rowCount() > 0; }));
    ASSERT_TRUE(eventually([&] { return state_ && shape_; }));
  }

  static std::string config() { return std::string(CABLE_VARIATION_SOURCE_DIR) + "/rviz/harness.rviz"; }
  template <typename Widget>
  static Widget* find(const char* name) {
    return frame_->findChild<Widget*>(name);
  }
  static QTableView* variables() { return find<QTableView>("variables"); }
  static QString message() { return find<MessageLine>("message")->text(); }
  static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  /// What is seen, for a person who wants to look: into the folder $REVIEW_PICTURES.
  static void picture(const char* name) {
    const char* folder = std::getenv("REVIEW_PICTURES");
    if (folder == nullptr) return;
    QTest::qWait(1500);
    const QString path = QString("%1/%2.png").arg(folder, name);
    if (std::system(("import -window root " + path.toStdString()).c_str()) != 0) {
      frame_->grab().save(path);
    }
  }
  double inForce(const std::string& name) const {
    for (std::size_t i = 0; i < state_->variables.size(); ++i) {
      if (state_->variables[i] == name) return state_->nominal[i];
    }
    return std::nan("");
  }
  static int rowOf(const QString& name) {
    for (int row = 0; row < variables()->model()->rowCount(); ++row) {
      if (variables()->model()->index(row, 0).data().toString() == name) return row;
    }
    return -1;
  }
  /// QTest::mouseMove() moves the mouse with no button pressed.
  static void drag(QWidget* widget, const QPointF& to) {
    QMouseEvent event(QEvent::MouseMove, to, widget->mapToGlobal(to.toPoint()), Qt::NoButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(widget, &event);
  }
  static void type(const QString& name, const char* text) {
    const QModelIndex cell = variables()->model()->index(rowOf(name), VariableTableModel::kValue);
    variables()->scrollTo(cell);
    QTest::mouseClick(variables()->viewport(), Qt::LeftButton, {}, variables()->visualRect(cell).center());
    variables()->edit(cell);
    QLineEdit* editor = nullptr;
    ASSERT_TRUE(eventually([&] {
      for (auto* each : variables()->viewport()->findChildren<QLineEdit*>()) {
        if (each->isVisible()) editor = each;
      }
      return editor != nullptr;
    }));
    QTest::keySequence(editor, QKeySequence::SelectAll);
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
  }
  static void showTab(const char* name) {
    auto* tabs = find<QTabWidget>("tabs");
    for (int i = 0; i < tabs->count(); ++i) {
      if (tabs->tabText(i) == name) tabs->setCurrentIndex(i);
    }
  }

  ros::NodeHandle node_;
  ros::Subscriber design_, shapes_, legend_;
  cable_variation::DesignStateConstPtr state_;
  cable_variation::CableShapesConstPtr shape_;
  cable_variation::LegendConstPtr colours_;
  static std::unique_ptr<rviz::VisualizationFrame> frame_;
};
std::unique_ptr<rviz::VisualizationFrame> ReviewPanelTest::frame_;

TEST_F(ReviewPanelTest, TheCableFollowsTheSlider) {
  picture("design");
  const int row = rowOf("wh_start_rz");
  ASSERT_GE(row, 0);
  auto* slider = qobject_cast<QSlider*>(
      variables()->indexWidget(variables()->model()->index(row, VariableTableModel::kSlider)));
  ASSERT_NE(slider, nullptr);
  const auto before = shape_;
  const QPoint middle = slider->rect().center();
  QTest::mousePress(slider, Qt::LeftButton, {}, middle);
  for (int step = 1; step <= 20; ++step) {
    drag(slider, middle + QPoint(step * slider->width() / 60, 0));
    QTest::qWait(10);
  }
  QTest::mouseRelease(slider, Qt::LeftButton, {}, middle + QPoint(slider->width() / 3, 0));
  ASSERT_GT(slider->value(), slider->maximum() / 2);
  const double tolerance = 5.0 * M_PI / 180.0;
  const double wanted = tolerance * (2.0 * slider->value() / slider->maximum() - 1.0);
  EXPECT_TRUE(eventually([&] { return std::abs(inForce("wh_start_rz") - wanted) < 1e-12; }))
      << inForce("wh_start_rz") << ", expected " << wanted;
  EXPECT_TRUE(state_->edited);
  EXPECT_TRUE(eventually([&] { return shape_ != before && !shape_->cables.empty(); }));
  picture("dragged");
}

TEST_F(ReviewPanelTest, ValuesAreTypedAndErrorsAreToldThere) {
  type("main_length", "31.3 cm");
  EXPECT_TRUE(eventually([&] { return std::abs(inForce("main_length") - 0.313) < 1e-12; }));
  EXPECT_TRUE(eventually([&] { return std::abs(shape_->cables[0].length - 0.313) < 1e-12; }));
  QTest::qWait(1000);  // until all answers of that edit are there, each of which would end a message
  type("main_length", "3 kg");
  EXPECT_TRUE(eventually([&] { return message().contains("main_length") && message().contains("kg"); }, 3000))
      << message().toStdString();
  EXPECT_TRUE(find<MessageLine>("message")->isError());
  type("main_length", "10 mm");  // nothing that could reach: the solver refuses it
  EXPECT_TRUE(eventually([&] { return !message().isEmpty() && !message().contains("kg"); }));
  picture("refused");
  EXPECT_TRUE(eventually([&] {  // the value in force is back in the table
    return variables()->model()->index(rowOf("main_length"), VariableTableModel::kValue).data().toString() ==
           "313 mm";
  }));
  EXPECT_NEAR(inForce("main_length"), 0.313, 1e-12);
  click(find<QPushButton>("reset_all"));
  EXPECT_TRUE(eventually([&] { return !state_->edited; }));
  EXPECT_EQ(inForce("main_length"), 0.312);
  EXPECT_TRUE(eventually([&] { return message().isEmpty(); })) << message().toStdString();
}

TEST_F(ReviewPanelTest, AClickOnANameShowsItsEffect) {
  const QModelIndex cell = variables()->model()->index(rowOf("breakout_at"), VariableTableModel::kName);
  variables()->scrollTo(cell);
  QTest::mouseClick(variables()->viewport(), Qt::LeftButton, {}, variables()->visualRect(cell).center());
  EXPECT_TRUE(eventually([&] { return colours_ && colours_->title == "Sensitivity to breakout_at"; }));
  picture("effect");
}

TEST_F(ReviewPanelTest, MeasuresAreThere) {
  auto* measures = find<QTableView>("measures");
  ASSERT_NE(measures, nullptr);
  EXPECT_TRUE(eventually([&] { return measures->model()->rowCount() == 13; }));
}

TEST_F(ReviewPanelTest, ASimulationIsRunAndCancelledWhileRVizGoesOn) {
  showTab("Analyses");
  auto* choice = find<QComboBox>("analysis");
  choice->setCurrentText("Variation");
  find<QSpinBox>("samples")->setValue(10'000'000);
  qint64 longest = 0;
  QElapsedTimer since;
  QTimer beat;
  QObject::connect(&beat, &QTimer::timeout, [&] { longest = std::max(longest, since.restart()); });
  since.start();
  beat.start(10);
  auto* run = find<QPushButton>("run");
  auto* cancel = find<QPushButton>("cancel");
  auto* bar = find<QProgressBar>("progress");
  click(run);
  EXPECT_TRUE(eventually([&] { return bar->isVisible() && bar->maximum() > 0; }));
  EXPECT_FALSE(run->isEnabled());
  picture("running");
  click(cancel);
  EXPECT_TRUE(eventually([&] { return run->isEnabled(); }));
  beat.stop();
  EXPECT_LT(longest, 2000) << "[ms] in which RViz stood still";
  auto* statistics = find<QTableView>("statistics");
  EXPECT_EQ(statistics->model()->rowCount(), 13);  // of what was done
  EXPECT_TRUE(find<MessageLine>("message")->isError());
  find<QSpinBox>("samples")->setValue(500);
  click(run);
  EXPECT_TRUE(eventually([&] { return run->isEnabled(); }));
  EXPECT_TRUE(message().isEmpty()) << message().toStdString();
  picture("variation");
}

TEST_F(ReviewPanelTest, StabilityIsAHeatMap) {
  showTab("Analyses");
  find<QComboBox>("analysis")->setCurrentText("Stability");
  auto* run = find<QPushButton>("run");
  click(run);
  auto* map = find<QTableView>("heat_map");
  EXPECT_TRUE(eventually([&] { return run->isEnabled() && map->model()->rowCount() == 10; }));
  EXPECT_EQ(map->model()->columnCount(), 13);
  picture("stability");
}

TEST_F(ReviewPanelTest, AnotherSceneIsFollowedWithItsMotion) {
  showTab("Design");
  cable_variation::LoadScene load;
  load.request.scene = "package://cable_variation/config/hose.yaml";
  ASSERT_TRUE(ros::service::call("/cable_solver/load_scene", load));
  ASSERT_EQ(load.response.status.message, "");
  EXPECT_TRUE(eventually([&] { return rowOf("cooler_x") >= 0; }));
  auto* time = find<QSlider>("motion_time");
  EXPECT_TRUE(eventually([&] { return time->isVisible() && time->value() > 0; }));  // it plays
  picture("hose");
  click(find<QToolButton>("play"));
  EXPECT_TRUE(eventually([&] {
    const int at = time->value();
    QTest::qWait(500);
    return time->value() == at;
  }));
}

TEST_F(ReviewPanelTest, TheCameraGoesToAnotherSceneUnlessItIsMovedMeanwhile) {
  rviz::Property& view = *frame_->getManager()->getViewManager()->getCurrent();
  rviz::Property& x = *view.subProp("Focal Point")->childAt(0);
  const auto load = [&](const char* scene) {
    cable_variation::LoadScene call;
    call.request.scene = scene;
    ASSERT_TRUE(ros::service::call("/cable_solver/load_scene", call));
    ASSERT_EQ(call.response.status.message, "");
  };
  x.setValue(50.0);
  load("package://cable_variation/config/harness.yaml");
  EXPECT_TRUE(eventually([&] { return rowOf("wh_start_ry") >= 0; }));
  EXPECT_TRUE(eventually([&] { return std::abs(x.getValue().toDouble()) < 2.0; }));
  x.setValue(50.0);
  load("package://cable_variation/config/hose.yaml");
  EXPECT_TRUE(eventually([&] { return rowOf("cooler_x") >= 0; }));
  x.setValue(60.0);  // as a person who looks at something
  EXPECT_FALSE(eventually([&] { return x.getValue().toDouble() != 60.0; }, 4000));
}

}  // namespace
}  // namespace cable_variation_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "review_panel_test", ros::init_options::AnonymousName);
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
