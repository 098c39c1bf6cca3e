// The nodes between a span's ends, eliminated and found again.
#include <algorithm>

#include <cable_variation/equilibrium/discretisation/rod_system_impl.h>

namespace cable_variation {

using element::kInner;

// What the elimination of all nodes between leaves of the span, in terms of its ends and arc lengths.
void RodSystem::reduceSpan(std::size_t index, int& negative) {
  SpanData& data = spans_[index];
  const element::Elimination<1>& elimination = element::chainKernel().alone;
  Eigen::Matrix2d slide_slide = data.slide_second;
  data.links.resize(data.elements - 1);
  for (std::size_t j = 0; j < data.elements; ++j) {
    const Element at = elementOf(index, data.element(j));
    const Batch& batch = batches_[at.batch];
    if (j == 0) {
      elimination.start(batch.factor, at.lane, batch.slide, data.role, data.front);
    } else {
      elimination.eliminate(batch.factor, at.lane, batch.slide, data.role, data.front, data.links[j - 1],
                            &negative);
    }
    for (int k = 0; data.role.slides && k < kInner; ++k) {
      const Eigen::Vector2d row(batch.slide[0][k][at.lane], batch.slide[1][k][at.lane]);
      slide_slide -= batch.factor.inverse_pivot[k][at.lane] * row * row.transpose();
    }
  }
  const int far = data.role.reversed ? 0 : 6, near = 6 - far;
  const int slides = element::kBorderRow + (data.role.near_held ? 0 : 6);
  const auto take = [&](int rows, int columns, int row, int column, int row_count, int column_count) {
    for (int r = 0; r < row_count; ++r) {
      for (int c = 0; c < column_count; ++c) {
        const int i = std::max(row + r, column + c), j = std::min(row + r, column + c);
        data.reduced(rows + r, columns + c) = data.reduced(columns + c, rows + r) =
            data.front.matrix[data.front.at(i, j)][0];
      }
    }
  };
  data.reduced.setZero();
  take(far, far, element::kFarRow, element::kFarRow, 6, 6);
  if (!data.role.near_held) {
    take(near, near, element::kBorderRow, element::kBorderRow, 6, 6);
    take(near, far, element::kBorderRow, element::kFarRow, 6, 6);
  }
  if (!data.role.slides) return;
  take(12, far, slides, element::kFarRow, 2, 6);
  if (!data.role.near_held) {
    take(12, near, slides, element::kBorderRow, 2, 6);
  } else {  // the elimination knows nothing of a held end; its motion pulls on the first element's arc length
    const Element at = elementOf(index, data.element(0));
    for (int side = 0; side < 2; ++side) {
      for (int r = 0; r < 6; ++r) {
        data.reduced(12 + side, near + r) = data.reduced(near + r, 12 + side) =
            batches_[at.batch].slide[side][kInner + near + r][at.lane];
      }
    }
  }
  take(12, 12, slides, slides, 2, 2);
  data.reduced.block<2, 2>(12, 12) += slide_slide;
}

// Eliminates the nodes between the ends from the right-hand side in `nodes`; `slide` is added to.
void RodSystem::SpanData::condense(Eigen::Vector2d& slide) {
  double border[element::kLargestBorder][1];
  const int near_rows = role.near_held ? 0 : 6;
  for (int k = 0; k < near_rows; ++k) border[k][0] = nodes(k, 0);
  for (int k = 0; role.slides && k < 2; ++k) border[near_rows + k][0] = slide[k];
  for (std::size_t i = 0; i < links.size(); ++i) {
    element::chainKernel().alone.condense(links[i], role.border(), nodeRows(i + 1), nodeRows(i + 2), border);
  }
  for (int k = 0; k < near_rows; ++k) nodes(k, 0) = border[k][0];
  for (int k = 0; role.slides && k < 2; ++k) slide[k] = border[near_rows + k][0];
}

// From the solution at the ends and what condense() left between to the solution there.
void RodSystem::SpanData::expand(const Eigen::Vector2d& slide) {
  double border[element::kLargestBorder][1];
  const int near_rows = role.near_held ? 0 : 6;
  for (int k = 0; k < near_rows; ++k) border[k][0] = nodes(k, 0);
  for (int k = 0; role.slides && k < 2; ++k) border[near_rows + k][0] = slide[k];
  for (std::size_t i = links.size(); i-- > 0;) {
    element::chainKernel().alone.expand(links[i], role.border(), nodeRows(i + 1), nodeRows(i + 2), border);
  }
}

}  // namespace cable_variation
