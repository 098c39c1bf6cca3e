// Design variables as a table: shown and typed in the units of people, kept in SI.
#include <rviz_plugins/panel/variable_table_model.h>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation_rviz {
namespace {

using Model = VariableTableModel;

constexpr double kDegree = M_PI / 180.0;

cable_variation::DesignVariableInfo variable(const char* name, const char* kind, const char* target,
                                             const char* member, const char* unit, double nominal,
                                             double tolerance) {
  cable_variation::DesignVariableInfo info;
  info.name = name;
  info.kind = kind;
  info.target = target;
  info.member = member;
  info.unit = unit;
  info.nominal = nominal;
  info.lower = -tolerance;
  info.upper = tolerance;
  info.distribution = "normal";
  return info;
}

class VariableTableTest : public testing::Test {
 protected:
  VariableTableTest() {
    model_.setVariables({variable("turn", "clip_rotation", "A", "z", "rad", 0.0, 5.0 * kDegree),
                         variable("long", "cable_property", "main", "length", "m", 0.312, 0.003)});
    QObject::connect(&model_, &Model::designEdited,
                     [this](int row, double value) { edits_.emplace_back(row, value); });
    QObject::connect(&model_, &Model::refused, [this](const QString& message) { refusal_ = message; });
  }
  bool type(int row, const char* text) {
    return model_.setData(model_.index(row, Model::kValue), QString(text), Qt::EditRole);
  }
  QString shown(int row) const { return model_.index(row, Model::kValue).data().toString(); }

  Model model_;
  std::vector<std::pair<int, double>> edits_;
  QString refusal_;
};

TEST_F(VariableTableTest, SaysWhatAVariableIsInWords) {
  EXPECT_EQ(model_.index(0, 0).data(Model::kDescription).toString(), "rotation of clip A about its z");
  EXPECT_EQ(model_.index(1, 0).data(Model::kDescription).toString(), "length of cable main");
  // Every kind that DesignVariableInfo has is described by more than its own name.
  for (const char* kind :
       {"clip_translation", "clip_rotation", "clip_arc_length", "cable_property", "breakout_arc_length",
        "component_translation", "component_rotation", "locator_deviation"}) {
    const QString text = descriptionOf(variable("v", kind, "thing", "x", "m", 0.0, 1.0));
    EXPECT_TRUE(text.contains("thing")) << kind;
    EXPECT_FALSE(text.startsWith(QString(kind).replace('_', ' '))) << kind;
  }
}

TEST_F(VariableTableTest, ShowsAndReadsTheUnitsOfPeople) {
  EXPECT_EQ(shown(0), "0 deg");
  EXPECT_EQ(shown(1), "312 mm");
  EXPECT_TRUE(type(0, "3"));  // in the unit shown
  EXPECT_TRUE(type(1, "31.4 cm"));
  EXPECT_TRUE(type(0, "0.05 rad"));
  ASSERT_EQ(edits_.size(), 3u);
  EXPECT_NEAR(edits_[0].second, 3.0 * kDegree, 1e-15);
  EXPECT_NEAR(edits_[1].second, 0.314, 1e-15);
  EXPECT_EQ(edits_[2].second, 0.05);
  EXPECT_EQ(shown(1), "314 mm");
}

TEST_F(VariableTableTest, RefusesWhatIsNoValueAndSaysWhy) {
  for (const char* text : {"three", "3 kg", "5 mm", ""}) {
    refusal_.clear();
    EXPECT_FALSE(type(0, text)) << text;
    EXPECT_TRUE(refusal_.startsWith("turn: ")) << text;
    EXPECT_TRUE(refusal_.contains("expected")) << text;
  }
  EXPECT_TRUE(edits_.empty());
  EXPECT_EQ(shown(0), "0 deg");
}

TEST_F(VariableTableTest, TheTextLeftAsItWasChangesNothing) {
  model_.edit(1, 0.31234567891);  // more digits than are shown
  edits_.clear();
  EXPECT_TRUE(type(1, shown(1).toUtf8()));
  EXPECT_TRUE(edits_.empty());
  EXPECT_EQ(model_.value(1), 0.31234567891);
}

TEST_F(VariableTableTest, TheSliderGoesFromLimitToLimit) {
  const QModelIndex slider = model_.index(1, Model::kSlider);
  EXPECT_DOUBLE_EQ(slider.data(Model::kShare).toDouble(), 0.5);
  model_.setData(slider, 0.0, Qt::EditRole);
  model_.setData(slider, 1.0, Qt::EditRole);
  ASSERT_EQ(edits_.size(), 2u);
  EXPECT_NEAR(edits_[0].second, 0.309, 1e-15);
  EXPECT_NEAR(edits_[1].second, 0.315, 1e-15);
  type(1, "400 mm");  // beyond the tolerance: allowed, at the slider's end
  EXPECT_DOUBLE_EQ(slider.data(Model::kShare).toDouble(), 1.0);
}

TEST_F(VariableTableTest, ChangedOnesAreMarkedUntilReset) {
  EXPECT_FALSE(model_.changed(1));
  type(1, "314 mm");
  EXPECT_TRUE(model_.index(1, 0).data(Model::kChanged).toBool());
  EXPECT_FALSE(model_.changed(0));
  model_.reset(1);
  EXPECT_FALSE(model_.changed(1));
  EXPECT_EQ(edits_.back(), std::make_pair(1, 0.312));
}

TEST_F(VariableTableTest, WhatIsInForceIsNotWhatTheSceneHas) {
  cable_variation::DesignState state;
  state.variables = {"long", "unknown"};
  state.nominal = {0.314, 1.0};
  state.loaded = {0.312, 1.0};
  model_.setState(state);
  EXPECT_EQ(shown(1), "314 mm");
  EXPECT_TRUE(model_.changed(1));
  EXPECT_TRUE(edits_.empty());  // heard, not asked for
}

}  // namespace
}  // namespace cable_variation_rviz
