// Labels beside their anchors, none on another.
#include <rviz_plugins/displays/label_layout.h>

#include <random>

#include <gtest/gtest.h>

namespace cable_variation_rviz {
namespace {

constexpr double kStep = 20.0;
const QSizeF kView(1000.0, 700.0);

void expectNoneOnAnother(const std::vector<std::optional<QRectF>>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; boxes[i] && j < i; ++j) {
      EXPECT_FALSE(boxes[j] && boxes[i]->intersects(*boxes[j])) << i << " and " << j;
    }
  }
}

TEST(LabelLayout, PutsOneBesideItsAnchor) {
  const auto boxes = LabelLayout().place({{{500.0, 300.0}, {120.0, 24.0}, 0}}, kView, kStep);
  ASSERT_TRUE(boxes[0]);
  EXPECT_EQ(boxes[0]->size(), QSizeF(120.0, 24.0));
  EXPECT_FALSE(boxes[0]->contains(QPointF(500.0, 300.0)));
  EXPECT_LT(std::abs(boxes[0]->bottom() - 300.0), 2.0 * kStep);
}

TEST(LabelLayout, OfManyInOnePlaceNoneCoversAnother) {
  const std::vector<LabelWish> wishes(40, {{500.0, 300.0}, {150.0, 24.0}, 0});
  const auto boxes = LabelLayout().place(wishes, kView, kStep);
  for (const auto& box : boxes) {
    ASSERT_TRUE(box);
    EXPECT_TRUE(QRectF(QPointF(), kView).contains(*box));
  }
  expectNoneOnAnother(boxes);
}

TEST(LabelLayout, OfRandomOnesNoneCoversAnother) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int round = 0; round < 20; ++round) {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < 60; ++i) {
      wishes.push_back({{1000.0 * share(random), 700.0 * share(random)},
                        {40.0 + 160.0 * share(random), 24.0},
                        static_cast<int>(3.0 * share(random))});
    }
    expectNoneOnAnother(LabelLayout().place(wishes, kView, kStep));
  }
}

TEST(LabelLayout, KeepsOffWhatIsCoveredAlready) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const std::vector<QRectF> legends = {{690.0, 400.0, 300.0, 290.0}, {10.0, 10.0, 200.0, 80.0}};
  std::vector<LabelWish> wishes;
  for (int i = 0; i < 40; ++i)
    wishes.push_back({{1000.0 * share(random), 700.0 * share(random)}, {90.0, 24.0}, 0});
  const auto boxes = LabelLayout().place(wishes, kView, kStep, legends);
  expectNoneOnAnother(boxes);
  int placed = 0;
  for (const auto& box : boxes) {
    for (const QRectF& legend : legends) EXPECT_FALSE(box && box->intersects(legend));
    placed += box ? 1 : 0;
  }
  EXPECT_GT(placed, 30);
}

TEST(LabelLayout, LeavesOutWhatIsOutOfView) {
  const auto boxes = LabelLayout().place({{{-5.0, 300.0}, {120.0, 24.0}, 0}}, kView, kStep);
  EXPECT_FALSE(boxes[0]);
}

TEST(LabelLayout, LetsLowerRanksChooseFirst) {
  const QPointF place(500.0, 300.0);
  const QSizeF size(120.0, 24.0);
  const auto alone = LabelLayout().place({{place, size, 0}}, kView, kStep);
  const auto both = LabelLayout().place({{place, size, 2}, {place, size, 0}}, kView, kStep);
  EXPECT_EQ(both[1], alone[0]);
  EXPECT_NE(both[0], alone[0]);
}

TEST(LabelLayout, KeepsALabelWhereItWasWhileTheViewTurns) {
  LabelLayout layout;
  std::vector<LabelWish> wishes = {{{500.0, 300.0}, {120.0, 24.0}, 0}, {{505.0, 300.0}, {120.0, 24.0}, 1}};
  const auto before = layout.place(wishes, kView, kStep);
  wishes[0].anchor.setX(200.0);  // makes room at the better place
  const auto after = layout.place(wishes, kView, kStep);
  EXPECT_EQ(after[1], before[1]);
}

}  // namespace
}  // namespace cable_variation_rviz
