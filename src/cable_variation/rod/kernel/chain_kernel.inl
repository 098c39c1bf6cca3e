// Included once per instruction set, as element_kernel.inl, with CABLE_VARIATION_CHAIN_KERNEL naming the
// table to define.

#include <cable_variation/rod/kernel/chain_kernel.h>
#include <cable_variation/rod/kernel/elimination.inl>

namespace cable_variation::element {
namespace {

// First row of the element's near and far node.
inline int nearRow(const ChainRole& role) { return role.reversed ? kInner + kNodeDofs : kInner; }
inline int farRow(const ChainRole& role) { return role.reversed ? kInner : kInner + kNodeDofs; }

template <class Of>
void start(const Factor& element, int of_alone, const double (*slide)[kDofs][kLanes], const ChainRole& role,
           Front<Of::kCount>& front) {
  const int near = nearRow(role), far = farRow(role);
  const int slides = kBorderRow + (role.near_held ? 0 : kNodeDofs);
  for (int lane = 0; lane < Of::kCount; lane += Of::kStep) {
    const int from = Of::kCount == 1 ? of_alone : lane;
    const auto entry = [&](int row, int column) {
      return get<Of>(element.matrix[row >= column ? packed(row, column) : packed(column, row)] + from);
    };
    const auto set = [&](int row, int column, typename Of::Value value) {
      put<Of>(front.matrix[front.at(row, column)] + lane, value);
    };
    for (int r = 0; r < kNodeDofs; ++r) {
      for (int c = 0; c <= r; ++c) set(kFarRow + r, kFarRow + c, entry(far + r, far + c));
    }
    for (int r = 0; !role.near_held && r < kNodeDofs; ++r) {
      for (int c = 0; c < kNodeDofs; ++c) set(kBorderRow + r, kFarRow + c, entry(near + r, far + c));
      for (int c = 0; c <= r; ++c) set(kBorderRow + r, kBorderRow + c, entry(near + r, near + c));
    }
    for (int s = 0; role.slides && s < kSlides; ++s) {
      for (int c = 0; c < kNodeDofs; ++c) set(slides + s, kFarRow + c, get<Of>(slide[s][far + c] + from));
      for (int c = 0; !role.near_held && c < kNodeDofs; ++c) {
        set(slides + s, kBorderRow + c, get<Of>(slide[s][near + c] + from));
      }
      for (int c = 0; c <= s; ++c) set(slides + s, slides + c, typename Of::Value{});
    }
  }
}

template <class Of, int kRows>
inline void eliminateNode(Front<Of::kCount>& front, Link<Of::kCount>& link, int lane) {
  if constexpr (Of::kCount == 1) {
    eliminateFirstPanel<kRows, Front<1>::kRow>(front.matrix, link.inverse_pivot);
  } else {
    eliminatePanel<kRows, 0>(front.matrix, link.inverse_pivot, lane);
  }
  for (int row = 0; row < kRows; ++row) {
    for (int k = 0; k < kNodeDofs && k <= row; ++k) {
      put<Of>(link.lower[link.at(row, k)] + lane, get<Of>(front.matrix[front.at(row, k)] + lane));
    }
  }
}

template <class Of>
void eliminate(const Factor& element, int of_alone, const double (*slide)[kDofs][kLanes],
               const ChainRole& role, Front<Of::kCount>& front, Link<Of::kCount>& link,
               int* negative_pivots) {
  const int near = nearRow(role), far = farRow(role);
  const int near_rows = role.near_held ? 0 : kNodeDofs;
  const int border = role.border();
  for (int lane = 0; lane < Of::kCount; lane += Of::kStep) {
    const int from = Of::kCount == 1 ? of_alone : lane;
    const auto entry = [&](int row, int column) {
      return get<Of>(element.matrix[row >= column ? packed(row, column) : packed(column, row)] + from);
    };
    const auto left = [&](int row, int column) {
      return get<Of>(front.matrix[front.at(row, column)] + lane);
    };
    const auto set = [&](int row, int column, typename Of::Value value) {
      put<Of>(front.matrix[front.at(row, column)] + lane, value);
    };
    for (int r = 0; r < kNodeDofs; ++r) {
      for (int c = 0; c <= r; ++c) {
        set(r, c, left(kFarRow + r, kFarRow + c) + entry(near + r, near + c));
        set(kFarRow + r, kFarRow + c, entry(far + r, far + c));
      }
      for (int c = 0; c < kNodeDofs; ++c) set(kFarRow + r, c, entry(far + r, near + c));
    }
    for (int b = 0; b < border; ++b) {
      const int row = kBorderRow + b;
      for (int c = 0; c < kNodeDofs; ++c) {
        const bool slid = b >= near_rows;
        set(row, c,
            slid ? left(row, kFarRow + c) + get<Of>(slide[b - near_rows][near + c] + from)
                 : left(row, kFarRow + c));
        set(row, kFarRow + c, slid ? get<Of>(slide[b - near_rows][far + c] + from) : typename Of::Value{});
      }
    }
    switch (border) {
      case 0:
        eliminateNode<Of, kBorderRow>(front, link, lane);
        break;
      case kSlides:
        eliminateNode<Of, kBorderRow + kSlides>(front, link, lane);
        break;
      case kNodeDofs:
        eliminateNode<Of, kBorderRow + kNodeDofs>(front, link, lane);
        break;
      default:
        eliminateNode<Of, kLargestFront>(front, link, lane);
    }
  }
  for (int k = 0; k < kNodeDofs; ++k) {
    for (int lane = 0; lane < Of::kCount; ++lane)
      negative_pivots[lane] += link.lower[link.at(k, k)][lane] > 0.0 ? 0 : 1;
  }
}

template <class Of>
void condense(const Link<Of::kCount>& link, int border_rows, double (*node)[Of::kCount],
              double (*far)[Of::kCount], double (*border)[Of::kCount]) {
  for (int lane = 0; lane < Of::kCount; lane += Of::kStep) {
    typename Of::Value value[kNodeDofs];
    for (int k = 0; k < kNodeDofs; ++k) value[k] = get<Of>(node[k] + lane);
    const auto reduced = [&](int row, int columns, typename Of::Value of) {
      for (int k = 0; k < columns; ++k) of -= get<Of>(link.lower[link.at(row, k)] + lane) * value[k];
      return of;
    };
    for (int k = 1; k < kNodeDofs; ++k) value[k] = reduced(k, k, value[k]);
    for (int k = 1; k < kNodeDofs; ++k) put<Of>(node[k] + lane, value[k]);
    for (int r = 0; r < kNodeDofs; ++r)
      put<Of>(far[r] + lane, reduced(kFarRow + r, kNodeDofs, get<Of>(far[r] + lane)));
    for (int r = 0; r < border_rows; ++r) {
      put<Of>(border[r] + lane, reduced(kBorderRow + r, kNodeDofs, get<Of>(border[r] + lane)));
    }
  }
}

template <class Of>
void expand(const Link<Of::kCount>& link, int border_rows, double (*node)[Of::kCount],
            const double (*far)[Of::kCount], const double (*border)[Of::kCount]) {
  for (int lane = 0; lane < Of::kCount; lane += Of::kStep) {
    typename Of::Value value[kNodeDofs];
    for (int k = 0; k < kNodeDofs; ++k)
      value[k] = get<Of>(node[k] + lane) * get<Of>(link.inverse_pivot[k] + lane);
    const auto subtract = [&](int row, int columns, typename Of::Value x) {
      for (int k = 0; k < columns; ++k) value[k] -= get<Of>(link.lower[link.at(row, k)] + lane) * x;
    };
    for (int r = 0; r < border_rows; ++r) subtract(kBorderRow + r, kNodeDofs, get<Of>(border[r] + lane));
    for (int r = 0; r < kNodeDofs; ++r) subtract(kFarRow + r, kNodeDofs, get<Of>(far[r] + lane));
    for (int k = kNodeDofs - 1; k > 0; --k) subtract(k, k, value[k]);
    for (int k = 0; k < kNodeDofs; ++k) put<Of>(node[k] + lane, value[k]);
  }
}

template <class Of>
constexpr Elimination<Of::kCount> kElimination = {start<Of>, eliminate<Of>, condense<Of>, expand<Of>};

void force(const Energy& energy, double (*rhs)[kLanes], double (*left)[kLanes], double (*right)[kLanes]) {
  const Pack zero = {};
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    for (int k = 0; k < kInner; ++k) store(rhs[k] + lane, -load(energy.gradient[k] + lane));
    for (int k = kInner; k < kDofs; ++k) store(rhs[k] + lane, zero);
    for (int k = 0; k < kNodeDofs; ++k) {
      add(left[k] + lane, -load(energy.gradient[kInner + k] + lane));
      add(right[k] + lane, -load(energy.gradient[kInner + kNodeDofs + k] + lane));
    }
  }
}

inline Pack larger(Pack a, Pack b) { return a > b ? a : b; }
// 0, or not a number where `a` is none or infinite: comparisons lose it.
inline Pack poison(Pack a) { return 0.0 * a; }

void largest(const double (*rows)[kLanes], int count, const double* gyration, double* largest_yet) {
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    Pack all = load(largest_yet + lane);
    Pack poisoned = {};
    const Pack scale = 1.0 / load(gyration + lane);
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < kNodeDofs; ++k) {
        Pack value = load(rows[kNodeDofs * i + k] + lane);
        if (k >= 3) value *= scale;
        all = larger(all, larger(value, -value));
        poisoned += poison(value);
      }
    }
    store(largest_yet + lane, all + poisoned);
  }
}

void advance(Input& in, const double (*motion)[kLanes], const double* active, double* squared_displacement,
             double* squared_rotation) {
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    const Pack share = load(active + lane);
    Pack largest_displacement = load(squared_displacement + lane),
         largest_rotation = load(squared_rotation + lane);
    for (int a = 0; a < kNodes; ++a) {
      const double(*of)[kLanes] = motion + kFirstDof[a];
      Pack squared_length = {};
      for (int k = 0; k < 3; ++k) {
        const Pack d = load(of[k] + lane);
        double* position = in.position[a][k] + lane;
        const Pack before = load(position);
        store(position, share != 0.0 ? before + d : before);
        squared_length += d * d;
      }
      const Pack x = load(of[3] + lane), y = load(of[4] + lane), z = load(of[5] + lane);
      const Pack squared_angle = x * x + y * y + z * z;
      // cos and sin(h)/h of half the angle by their series, to rounding up to an angle of 1 rad; larger steps
      // are refused
      const Pack h = 0.25 * squared_angle;
      const Pack c =
          1.0 - h * (1.0 / 2.0) *
                    (1.0 - h * (1.0 / 12.0) *
                               (1.0 - h * (1.0 / 30.0) *
                                          (1.0 - h * (1.0 / 56.0) *
                                                     (1.0 - h * (1.0 / 90.0) * (1.0 - h * (1.0 / 132.0))))));
      const Pack s =
          0.5 - h * (1.0 / 12.0) *
                    (1.0 - h * (1.0 / 20.0) *
                               (1.0 - h * (1.0 / 42.0) *
                                          (1.0 - h * (1.0 / 72.0) *
                                                     (1.0 - h * (1.0 / 110.0) * (1.0 - h * (1.0 / 156.0))))));
      const Pack bx = s * x, by = s * y, bz = s * z;
      double(*q)[kLanes] = in.quaternion[a];
      const Pack w0 = load(q[0] + lane), x0 = load(q[1] + lane), y0 = load(q[2] + lane),
                 z0 = load(q[3] + lane);
      const Pack w1 = w0 * c - x0 * bx - y0 * by - z0 * bz;
      const Pack x1 = w0 * bx + x0 * c + y0 * bz - z0 * by;
      const Pack y1 = w0 * by + y0 * c + z0 * bx - x0 * bz;
      const Pack z1 = w0 * bz + z0 * c + x0 * by - y0 * bx;
      // one step of Newton's method from 1 for the inverse norm, which is 1 but for rounding
      const Pack norm = 1.5 - 0.5 * (w1 * w1 + x1 * x1 + y1 * y1 + z1 * z1);
      store(q[0] + lane, share != 0.0 ? norm * w1 : w0);
      store(q[1] + lane, share != 0.0 ? norm * x1 : x0);
      store(q[2] + lane, share != 0.0 ? norm * y1 : y0);
      store(q[3] + lane, share != 0.0 ? norm * z1 : z0);
      largest_displacement = larger(largest_displacement, squared_length) + poison(squared_length);
      largest_rotation = larger(largest_rotation, squared_angle) + poison(squared_angle);
    }
    store(squared_displacement + lane, largest_displacement);
    store(squared_rotation + lane, largest_rotation);
  }
}

}  // namespace

extern const ChainKernel CABLE_VARIATION_CHAIN_KERNEL = {kElimination<Lanes>, kElimination<Alone>, force,
                                                         largest, advance};

}  // namespace cable_variation::element
