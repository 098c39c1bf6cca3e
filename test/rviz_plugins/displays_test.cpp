// The displays in a real RViz with its shipped configuration and real nodes, judged by what is drawn. Run by
// displays.test, which starts the nodes, on a display of Xvfb.
#include "rviz_view.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/properties/status_list.h>

#include <cable_variation/CableTubes.h>
#include <cable_variation/EnvelopeMesh.h>
#include <cable_variation/Labels.h>
#include <cable_variation/SetDesign.h>
#include <cable_variation/SimulateVariation.h>

#include <ros_interface/markers/colour_map.h>
#include <rviz_plugins/displays/labels_display.h>

namespace cable_variation_rviz {
namespace {

using cable_variation::CableTube;
using cable_variation::CableTubes;
using Eigen::Vector3d;

const Vector3d kBackground(52, 58, 66);  // as the configuration has it

class DisplaysTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    view_ = std::make_unique<RvizView>(std::string(CABLE_VARIATION_SOURCE_DIR) + "/rviz/harness.rviz");
  }
  static void TearDownTestSuite() { view_.reset(); }

  void SetUp() override {
    tubes_ = node_.subscribe<CableTubes>(
        "/cable_solver/tubes", 1, [this](const cable_variation::CableTubesConstPtr& m) { heard_ = m; });
    ASSERT_TRUE(eventually([&] { return heard_ && !heard_->cables.empty(); }));
  }

  /// The display of a class alone, hearing of a topic; it has drawn what is published there.
  rviz::Display* only(const char* class_name, const QString& topic) {
    rviz::Display* display = view_->display(class_name);
    if (display == nullptr) return nullptr;
    display->setEnabled(false);
    display->subProp("Topic")->setValue(topic);
    view_->showOnly(display);
    QApplication::processEvents();  // what it tells of its topic comes then
    eventually([&] { return hasHeard(*display); }, 10000);
    return display;
  }
  template <typename Message>
  rviz::Display* onlyWith(const char* class_name, const Message& message) {
    static int number = 0;  // a topic of its own for each test
    const std::string topic = "/displays_test/topic_" + std::to_string(number++);
    sender_ = node_.advertise<Message>(topic, 1, true);
    sender_.publish(message);
    rviz::Display* display = only(class_name, QString::fromStdString(topic));
    return display;
  }
  static QString statusOf(rviz::Display& display) {
    for (int i = 0; i < display.numChildren(); ++i) {
      rviz::Property& child = *display.childAt(i);  // its name tells the level too
      if (child.getName().startsWith("Status")) return child.subProp("Topic")->getValue().toString();
    }
    return "";
  }
  static bool hasHeard(rviz::Display& display) {
    const QString status = statusOf(display);
    return !status.isEmpty() && !status.startsWith("no message");
  }
  /// For a person who wants to look: into the folder $REVIEW_PICTURES.
  static Picture shot(const char* name) {
    const Picture picture = view_->shot();
    if (const char* folder = std::getenv("REVIEW_PICTURES"))
      picture.image().save(QString("%1/%2.png").arg(folder, name));
    return picture;
  }

  ros::NodeHandle node_;
  ros::Subscriber tubes_;
  ros::Publisher sender_;
  cable_variation::CableTubesConstPtr heard_;
  static std::unique_ptr<RvizView> view_;
};
std::unique_ptr<RvizView> DisplaysTest::view_;

/// A straight cable along x through the origin, with a quantity that goes from 0 to 1.
CableTubes straight() {
  CableTubes tubes;
  tubes.header.frame_id = "world";
  CableTube tube;
  tube.cable = "straight";
  cable_variation::CableQuantity rise;
  rise.name = "variation";
  rise.unit = "mm";
  rise.maximum = 1.0F;
  for (int i = 0; i <= 40; ++i) {
    tube.position.insert(tube.position.end(), {0.005F * static_cast<float>(i - 20), 0.0F, 0.0F});
    tube.radius.push_back(0.01F);
    rise.values.push_back(static_cast<float>(i) / 40.0F);
  }
  tube.quantities.push_back(rise);
  tubes.cables.push_back(tube);
  return tubes;
}

/// The cube of 0.2 m around the origin.
cable_variation::EnvelopeMesh cube() {
  cable_variation::EnvelopeMesh envelope;
  envelope.header.frame_id = "world";
  envelope.cables = {"straight"};
  for (int i = 0; i < 8; ++i) {
    geometry_msgs::Point corner;
    corner.x = (i & 1) != 0 ? 0.1 : -0.1;
    corner.y = (i & 2) != 0 ? 0.1 : -0.1;
    corner.z = (i & 4) != 0 ? 0.1 : -0.1;
    envelope.mesh.vertices.push_back(corner);
  }
  const unsigned faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const auto& face : faces) {
    shape_msgs::MeshTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle.vertex_indices[k] = face[k];
    envelope.mesh.triangles.push_back(triangle);
  }
  return envelope;
}

TEST_F(DisplaysTest, CablesHaveTheColoursOfTheLegendWhereTheyFaceTheCamera) {
  rviz::Display* cables = only("cable_variation/Cables", "/cable_solver/tubes");
  ASSERT_NE(cables, nullptr);
  cables->subProp("Quantity")->setValue("curvature");
  view_->look({0.405, 0.33, 0.415}, 0.8, 0.62, 0.22);
  const Picture picture = shot("curvature");
  int right = 0, all = 0;
  for (const CableTube& tube : heard_->cables) {
    const auto& quantity = tube.quantities.front();
    ASSERT_EQ(quantity.name, "curvature");
    const cable_variation_ros::ColourScale scale(quantity.minimum, quantity.maximum);
    const Vector3d origin(heard_->origin.x, heard_->origin.y, heard_->origin.z);
    const auto centre = [&](std::size_t i) {
      return Vector3d(origin +
                      Vector3d(tube.position[3 * i], tube.position[3 * i + 1], tube.position[3 * i + 2]));
    };
    for (std::size_t i = 5; i + 5 < tube.radius.size(); ++i) {
      const Vector3d to_eye = (picture.eye() - centre(i)).normalized();
      const Vector3d along = (centre(i + 1) - centre(i - 1)).normalized();
      const double facing = along.cross(to_eye).norm();  // of the surface in front of the centre
      const Vector3d expected = 255.0 * (0.4 + 0.6 * facing) * scale(quantity.values[i]);
      const Vector3d seen = picture.colourAt(centre(i) + tube.radius[i] * to_eye);
      right += (seen - expected).cwiseAbs().maxCoeff() <= 16.0 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(all, 100);
  EXPECT_GT(right, 9 * all / 10) << "of " << all;  // one cable may hide another
}

TEST_F(DisplaysTest, TubesAreLit) {
  rviz::Display* cables = onlyWith("cable_variation/Cables", straight());
  ASSERT_NE(cables, nullptr);
  cables->subProp("Quantity")->setValue("variation");
  view_->look(Vector3d::Zero(), 0.4, 0.0, -M_PI / 2);  // from the side, -y
  const Picture picture = shot("straight");
  for (const double x : {-0.05, 0.0, 0.05}) {
    const Vector3d full = 255.0 * cable_variation_ros::viridis(0.5 + 5.0 * x);
    const Vector3d middle = picture.colourAt({x, -0.01, 0.0});
    EXPECT_LT((middle - full).cwiseAbs().maxCoeff(), 8.0)
        << middle.transpose() << " for " << full.transpose();
    double before = middle.sum();
    for (const double share : {0.5, 0.75, 0.92}) {
      const Vector3d aside(x, -0.01 * std::sqrt(1.0 - share * share), 0.01 * share);
      const double here = picture.colourAt(aside).sum();
      EXPECT_LT(here, before - 5.0) << share << " of the radius aside of the middle, at " << x;
      before = here;
    }
  }
  EXPECT_EQ(picture.colourAt({0.0, 0.0, 0.015}), kBackground);
}

TEST_F(DisplaysTest, OutdatedCablesAreGreyAndOthersHaveTheirOwnColour) {
  CableTubes tubes = straight();
  tubes.outdated = true;
  rviz::Display* cables = onlyWith("cable_variation/Cables", tubes);
  ASSERT_NE(cables, nullptr);
  cables->subProp("Quantity")->setValue("variation");
  view_->look(Vector3d::Zero(), 0.4, 0.0, -M_PI / 2);
  const Vector3d grey = shot("outdated").colourAt({0.06, -0.01, 0.0});
  EXPECT_LT(grey.maxCoeff() - grey.minCoeff(), 12.0) << grey.transpose();
  EXPECT_GT((grey - kBackground).norm(), 30.0) << grey.transpose();
  tubes.outdated = false;
  tubes.cables[0].quantities.clear();
  sender_.publish(tubes);
  QTest::qWait(500);
  const Vector3d own = shot("own").colourAt({0.06, -0.01, 0.0});
  EXPECT_GT(own.x() - own.z(), 150.0) << own.transpose();  // orange
}

TEST_F(DisplaysTest, WhatCannotBeDrawnIsToldAndNotDrawn) {
  CableTubes tubes = straight();
  tubes.cables[0].position[30] = std::numeric_limits<float>::quiet_NaN();
  rviz::Display* cables = onlyWith("cable_variation/Cables", tubes);
  ASSERT_NE(cables, nullptr);
  view_->look(Vector3d::Zero(), 0.4, 0.0, -M_PI / 2);
  EXPECT_TRUE(eventually([&] { return statusOf(*cables).contains("not finite"); }, 10000));
  EXPECT_EQ(shot("fault").colourAt({0.06, -0.01, 0.0}), kBackground);
  tubes = straight();
  tubes.cables[0].quantities[0].values[20] = std::numeric_limits<float>::infinity();
  tubes.cables[0].quantities[0].values[30] = std::numeric_limits<float>::quiet_NaN();
  sender_.publish(tubes);  // drawn, what is no number in grey
  EXPECT_TRUE(eventually([&] { return statusOf(*cables).contains("1 cables"); }, 10000));
  const Vector3d grey = shot("no_number").colourAt({0.05, -0.01, 0.0});
  EXPECT_LT(grey.maxCoeff() - grey.minCoeff(), 25.0) << grey.transpose();
}

TEST_F(DisplaysTest, AFixedRangeIsKept) {
  rviz::Display* cables = onlyWith("cable_variation/Cables", straight());
  ASSERT_NE(cables, nullptr);
  cables->subProp("Quantity")->setValue("variation");
  rviz::Property* automatic = cables->subProp("Automatic Range");
  view_->look(Vector3d::Zero(), 0.4, 0.0, -M_PI / 2);
  shot("automatic");
  automatic->setValue(false);
  automatic->subProp("Maximum")->setValue(0.5);
  const Vector3d seen = shot("fixed_range").colourAt({0.05, -0.01, 0.0});
  EXPECT_LT((seen - 255.0 * cable_variation_ros::viridis(1.0)).cwiseAbs().maxCoeff(), 8.0)
      << seen.transpose();
  automatic->setValue(true);
  const Vector3d again = shot("automatic_again").colourAt({0.05, -0.01, 0.0});
  EXPECT_LT((again - 255.0 * cable_variation_ros::viridis(0.75)).cwiseAbs().maxCoeff(), 8.0);
}

TEST_F(DisplaysTest, LabelsDoNotCoverEachOtherAndAreReadable) {
  cable_variation::Labels labels;
  labels.header.frame_id = "world";
  for (int i = 0; i < 24; ++i) {
    cable_variation::Label label;
    label.kind = static_cast<std::uint8_t>(i % 3);
    label.text = "D_" + std::to_string(i) + " 4." + std::to_string(i) + " mm";
    label.at.x = 0.002 * i;
    labels.labels.push_back(label);
  }
  rviz::Display* display = onlyWith("cable_variation/Labels", labels);
  ASSERT_NE(display, nullptr);
  display->subProp("Leave Out")->setValue("");
  const auto* shown = dynamic_cast<LabelsDisplay*>(display);
  ASSERT_NE(shown, nullptr);
  for (const double distance : {0.3, 3.0}) {  // from near and far: of the same size
    view_->look(Vector3d::Zero(), distance, 0.5, -1.2);
    const Picture picture = shot(distance < 1.0 ? "labels" : "labels_far");
    ASSERT_EQ(shown->boxes().size(), 24U);
    for (std::size_t i = 0; i < 24; ++i) {
      const std::optional<QRectF>& box = shown->boxes()[i];
      ASSERT_TRUE(box) << i;
      EXPECT_TRUE(QRectF(picture.image().rect()).contains(*box)) << i;
      EXPECT_GT(box->height(), 18.0);
      EXPECT_LT(box->height(), 36.0);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(box->intersects(*shown->boxes()[j])) << i << " and " << j;
      // Light letters on a dark plate, a red one for faults.
      int light = 0, ground = 0;
      for (double y = box->top() + 3.0; y < box->bottom() - 3.0; y += 1.0) {
        for (double x = box->left() + 3.0; x < box->right() - 3.0; x += 1.0) {
          const Vector3d color = picture.colourOf({x, y});
          light += color.minCoeff() > 150.0 ? 1 : 0;
          const bool fault = i % 3 == 2;
          ground += (fault ? color.x() > 140.0 && color.y() < 60.0 : color.maxCoeff() < 60.0) ? 1 : 0;
        }
      }
      EXPECT_GT(light, 40) << i;
      EXPECT_GT(ground, 5 * light / 4) << i;
    }
  }
}

TEST_F(DisplaysTest, TheSolversLabelsAreShown) {
  const auto* labels = dynamic_cast<LabelsDisplay*>(only("cable_variation/Labels", "/cable_solver/labels"));
  ASSERT_NE(labels, nullptr);
  view_->look({0.405, 0.33, 0.415}, 0.8, 0.62, 0.22);
  EXPECT_TRUE(eventually([&] {
    return std::count_if(labels->boxes().begin(), labels->boxes().end(),
                         [](const auto& box) { return box.has_value(); }) >= 4;
  }));
  shot("solver_labels");
}

TEST_F(DisplaysTest, OfAnEnvelopeTheNearestWallAloneIsSeenFromEverySide) {
  rviz::Display* envelope = onlyWith("cable_variation/Envelope", cube());
  ASSERT_NE(envelope, nullptr);
  const double alpha = 0.3;
  envelope->subProp("Alpha")->setValue(alpha);
  envelope->subProp("Color")->setValue(QColor(255, 170, 60));
  const Vector3d own(255, 170, 60);
  for (const auto& [pitch, yaw] : {std::pair(0.0, 0.0), std::pair(0.0, 1.5), std::pair(0.0, 3.1),
                                   std::pair(0.0, -1.6), std::pair(1.5, 0.3), std::pair(-1.5, 0.3)}) {
    view_->look(Vector3d::Zero(), 0.6, pitch, yaw);
    const Vector3d seen = shot("envelope").colourAt(Vector3d::Zero());
    // The middle of a wall that faces the camera: 0.6 of its alpha, once.
    const Vector3d once = 0.6 * alpha * own + (1.0 - 0.6 * alpha) * kBackground;
    EXPECT_LT((seen - once).cwiseAbs().maxCoeff(), 10.0)
        << "pitch " << pitch << ", yaw " << yaw << ": " << seen.transpose() << " for " << once.transpose();
  }
  view_->look(Vector3d::Zero(), 0.05, 0.0, 0.0);  // from inside
  const Vector3d seen = shot("envelope_inside").colourAt(Vector3d::Zero());
  EXPECT_GT((seen - kBackground).x(), 15.0) << seen.transpose();
  sender_.publish(cable_variation::EnvelopeMesh());
  EXPECT_TRUE(eventually([&] { return statusOf(*envelope).contains("no envelope"); }, 10000));
  EXPECT_EQ(shot("no_envelope").colourAt(Vector3d::Zero()), kBackground);
}

bool hasVariation(const CableTubes& tubes) {
  for (const CableTube& tube : tubes.cables) {
    for (const auto& quantity : tube.quantities) {
      if (quantity.name == "variation") return true;
    }
  }
  return false;
}

TEST_F(DisplaysTest, ColoursOfOldResultsGoWhenTheCableHasMoved) {
  cable_variation::SimulateVariation simulate;
  simulate.request.samples = 100;
  simulate.request.variables = {"*"};
  ASSERT_TRUE(ros::service::call("/cable_solver/simulate_variation", simulate));
  ASSERT_EQ(simulate.response.status.message, "");
  EXPECT_TRUE(eventually([&] { return hasVariation(*heard_); }));
  EXPECT_EQ(heard_->cables.size(), 2U);
  for (const CableTube& tube : heard_->cables) EXPECT_FALSE(tube.elsewhere) << tube.cable;
  cable_variation::SetDesign design;
  design.request.variables = {"wh_start_rz"};
  design.request.values = {0.05};
  ASSERT_TRUE(ros::service::call("/cable_solver/set_design", design));
  ASSERT_EQ(design.response.status.message, "");
  EXPECT_TRUE(eventually([&] { return !hasVariation(*heard_); }));
  EXPECT_EQ(heard_->cables.size(), 2U);
}

}  // namespace
}  // namespace cable_variation_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "displays_test", ros::init_options::AnonymousName);
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
