#include <rviz_plugins/displays/label_layout.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace cable_variation_rviz {

namespace {

constexpr double kGap = 3.0;  // between labels [px]
constexpr std::size_t kRings = 14;
// Where a label lies seen from its anchor, of the most readable ones first: x to the right, y down.
constexpr std::array<std::array<int, 2>, 8> kDirections = {
    {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}}};
constexpr std::size_t kPlaces = kRings * kDirections.size();

std::size_t ringOf(std::size_t place) { return place / kDirections.size(); }

QRectF boxAt(const LabelWish& wish, std::size_t place, double step) {
  const auto& [x, y] = kDirections[place % kDirections.size()];
  const double away = step * (0.8 + static_cast<double>(ringOf(place)));
  const QPointF centre = wish.anchor + QPointF(x * (away + 0.5 * wish.size.width() * (y == 0 ? 1.0 : 0.8)),
                                               y * (away + 0.5 * wish.size.height()));
  return {centre - QPointF(0.5 * wish.size.width(), 0.5 * wish.size.height()), wish.size};
}

bool isFree(const QRectF& box, const QRectF& view, const std::vector<QRectF>& taken) {
  if (!view.contains(box)) return false;
  const QRectF wide = box.adjusted(-kGap, -kGap, kGap, kGap);
  return std::none_of(taken.begin(), taken.end(),
                      [&](const QRectF& other) { return wide.intersects(other); });
}

/// How many of the anchors a box would cover.
long coveredBy(const QRectF& box, const std::vector<LabelWish>& wishes) {
  return std::count_if(wishes.begin(), wishes.end(),
                       [&](const LabelWish& wish) { return box.contains(wish.anchor); });
}

}  // namespace

std::vector<std::optional<QRectF>> LabelLayout::place(const std::vector<LabelWish>& wishes, QSizeF view,
                                                      double step, const std::vector<QRectF>& covered) {
  const QRectF inside(QPointF(0.0, 0.0), view);
  sides_.resize(wishes.size());
  std::vector<std::size_t> order(wishes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wishes[a].rank < wishes[b].rank; });
  std::vector<std::optional<QRectF>> boxes(wishes.size());
  std::vector<QRectF> taken = covered;
  for (const std::size_t i : order) {
    const LabelWish& wish = wishes[i];
    std::optional<std::size_t>& side = sides_[i];
    if (!inside.contains(wish.anchor)) {
      side.reset();
      continue;
    }
    // The nearest place with room; one that covers an anchor counts as two rings further off.
    std::optional<std::size_t> best;
    double least = 0.0;
    for (std::size_t place = 0; place < kPlaces; ++place) {
      const auto ring = static_cast<double>(ringOf(place));
      if (best && ring >= least) break;
      const QRectF box = boxAt(wish, place, step);
      if (!isFree(box, inside, taken)) continue;
      const double cost = ring + 2.0 * static_cast<double>(coveredBy(box, wishes));
      if (!best || cost < least) {
        best = place;
        least = cost;
      }
    }
    // The place it had, if it is hardly worse.
    if (best && side && isFree(boxAt(wish, *side, step), inside, taken) &&
        ringOf(*side) <= ringOf(*best) + 1) {
      best = side;
    }
    side = best;
    if (!best) continue;
    boxes[i] = boxAt(wish, *best, step);
    taken.push_back(*boxes[i]);
  }
  return boxes;
}

}  // namespace cable_variation_rviz
