// Elimination in lower triangles, row by row: packed, a matrix in each lane, or of one matrix alone. Included
// by the kernels, as pack.inl.

#include <cable_variation/rod/kernel/pack.inl>

namespace cable_variation::element {
namespace {

// Pivots taken at a time: a node's degrees of freedom.
constexpr int kPanel = 6;

// Eliminates rows kFirst to kFirst + kPanel - 1 of a matrix of kRows rows: A = L D Lᵀ in them, the Schur
// complement below. The panel's columns first, row by row, then all that is right of them in tiles of two
// rows, so that an entry is read and written once for the panel.
template <int kRows, int kFirst>
inline void eliminatePanel(double (*matrix)[kLanes], double (*inverse_pivot)[kLanes], int lane) {
  constexpr int kEnd = kFirst + kPanel;
  Pack unit[kPanel][kPanel];  // L of the panel's own rows
  Pack inverse[kPanel];
  Pack scaled[kRows][kPanel];  // L D of the rows below
  for (int i = 0; i < kPanel; ++i) {
    double(*row)[kLanes] = matrix + packed(kFirst + i, kFirst);
    Pack value[kPanel];
    for (int j = 0; j <= i; ++j) {
      value[j] = load(row[j] + lane);
      for (int k = 0; k < j; ++k) value[j] -= value[k] * unit[j][k];
      if (j < i) {
        unit[i][j] = value[j] * inverse[j];
        store(row[j] + lane, unit[i][j]);
      }
    }
    // the pivot: value[i] used L D of its own row, above
    inverse[i] = 1.0 / value[i];
    store(row[i] + lane, value[i]);
    store(inverse_pivot[kFirst + i] + lane, inverse[i]);
  }
  for (int i = kEnd; i < kRows; ++i) {
    double(*row)[kLanes] = matrix + packed(i, kFirst);
    for (int j = 0; j < kPanel; ++j) {
      Pack value = load(row[j] + lane);
      for (int k = 0; k < j; ++k) value -= scaled[i][k] * unit[j][k];
      scaled[i][j] = value;
    }
    for (int j = 0; j < kPanel; ++j) store(row[j] + lane, scaled[i][j] * inverse[j]);
  }
  for (int i = kEnd; i < kRows; i += 2) {
    double(*first)[kLanes] = matrix + packed(i, 0);
    double(*second)[kLanes] = matrix + packed(i + 1, 0);
    Pack a[kPanel], b[kPanel];
    for (int k = 0; k < kPanel; ++k) {
      a[k] = load(first[kFirst + k] + lane);
      b[k] = load(second[kFirst + k] + lane);
    }
    for (int j = kEnd; j <= i; ++j) {
      Pack x = load(first[j] + lane), y = load(second[j] + lane);
      for (int k = 0; k < kPanel; ++k) {
        x -= a[k] * scaled[j][k];
        y -= b[k] * scaled[j][k];
      }
      store(first[j] + lane, x);
      store(second[j] + lane, y);
    }
    Pack y = load(second[i + 1] + lane);
    for (int k = 0; k < kPanel; ++k) y -= b[k] * scaled[i + 1][k];
    store(second[i + 1] + lane, y);
  }
}

// The same of the first rows of a single matrix, in rows of kRow. Registers hold neighbouring columns: tiles
// are one row by a register, and reach beyond the diagonal, into what nobody reads.
template <int kRows, int kRow>
inline void eliminateFirstPanel(double (*matrix)[1], double (*inverse_pivot)[1]) {
  constexpr int kReach = kRows + kWidth;
  double unit[kPanel][kPanel];    // L of the panel's own rows
  double scaled[kPanel][kReach];  // L D of the rows below
  for (int i = 0; i < kPanel; ++i) {
    double(*row)[1] = matrix + kRow * i;
    double value[kPanel];
    for (int j = 0; j <= i; ++j) {
      value[j] = row[j][0];
      for (int k = 0; k < j; ++k) value[j] -= value[k] * unit[j][k];
      if (j < i) row[j][0] = unit[i][j] = value[j] * inverse_pivot[j][0];
    }
    row[i][0] = value[i];
    inverse_pivot[i][0] = 1.0 / value[i];
  }
  for (int j = 0; j < kPanel; ++j) {
    for (int i = kPanel; i < kRows; ++i) scaled[j][i] = matrix[kRow * i + j][0];
    for (int i = kRows; i < kReach; ++i) scaled[j][i] = 0.0;
    for (int k = 0; k < j; ++k) {
      for (int i = kPanel; i < kRows; ++i) scaled[j][i] -= scaled[k][i] * unit[j][k];
    }
  }
  for (int i = kPanel; i < kRows; ++i) {
    double(*row)[1] = matrix + kRow * i;
    double of_row[kPanel];
    for (int k = 0; k < kPanel; ++k) row[k][0] = of_row[k] = scaled[k][i] * inverse_pivot[k][0];
    for (int j = kPanel; j <= i; j += kWidth) {
      double tile[kWidth];
      for (int c = 0; c < kWidth; ++c) tile[c] = row[j + c][0];
      for (int k = 0; k < kPanel; ++k) {
        for (int c = 0; c < kWidth; ++c) tile[c] -= of_row[k] * scaled[k][j + c];
      }
      for (int c = 0; c < kWidth; ++c) row[j + c][0] = tile[c];
    }
  }
}

}  // namespace
}  // namespace cable_variation::element
