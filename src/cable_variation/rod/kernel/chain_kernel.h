#pragma once

#include <cable_variation/rod/kernel/element_kernel.h>

/// Elements whose inner nodes are eliminated (element::Kernel), linked to a chain: a block tridiagonal
/// system. Its nodes are eliminated from the near end to the far one, and all of it is moved by the solution.
/// Either of kLanes rods side by side that differ in numbers only, the lane is the rod; or of one rod alone,
/// whose elements lie in the lanes. A template's kCount is how many rods there are: kLanes or 1.
///
/// What an elimination cannot get rid of is carried along at the border: the near end when it may move, and
/// the two slid arc lengths of a chain when there are any.
///
/// No lane feels another one: a rod's numbers are the same bit for bit whatever is in the lanes beside it.
/// Plain arrays only, as in element_kernel.h.
namespace cable_variation::element {

constexpr int kNodeDofs = 6;
constexpr int kSlides = 2;
constexpr int kLargestBorder = kNodeDofs + kSlides;
constexpr int kFarRow = kNodeDofs;         ///< first row of the next node towards the far end in a front
constexpr int kBorderRow = 2 * kNodeDofs;  ///< and of the border; the first are the node's own
constexpr int kLargestFront = kBorderRow + kLargestBorder;

/// The frontal matrix of an elimination (Irons 1970): over a node, the next one and the border. After the
/// node is eliminated the Schur complement is in the rows of the next one and the border, from where the
/// elimination goes on. The lower triangle, row by row: packed, or, alone, in rows of kRow, for registers to
/// take neighbours.
template <int kCount>
struct alignas(64) Front {
  static constexpr int kRow = 24;  ///< kLargestFront and room for a register that begins in its last column
  static constexpr int kEntries =
      kCount == 1 ? kLargestFront * kRow : kLargestFront * (kLargestFront + 1) / 2;
  double matrix[kEntries][kCount];

  static constexpr int at(int row, int column) {
    return kCount == 1 ? kRow * row + column : row * (row + 1) / 2 + column;
  }
};

/// An eliminated node: its columns of L in A = L D Lᵀ, rows as in the front.
template <int kCount>
struct alignas(64) Link {
  static constexpr int kOwn =
      kNodeDofs * (kNodeDofs + 1) / 2;  ///< entries of the node's own rows, D in the diagonal
  double lower[kOwn + kNodeDofs * (kLargestFront - kNodeDofs)][kCount];
  double inverse_pivot[kNodeDofs][kCount];

  static constexpr int at(int row, int column) {
    return row < kNodeDofs ? row * (row + 1) / 2 + column : kOwn + kNodeDofs * (row - kNodeDofs) + column;
  }
};

/// How an element sits in its chain.
struct ChainRole {
  bool reversed = false;   ///< its right end is the near one
  bool near_held = false;  ///< the chain's near end does not move
  bool slides = false;     ///< the chain's arc lengths are unknowns
  int border() const { return (near_held ? 0 : kNodeDofs) + (slides ? kSlides : 0); }
};

/// `lane`: the element's, of one rod alone. `slide`: coupling of the element's rows to both arc lengths,
/// [kSlides][kDofs][kLanes]; not read without slides.
template <int kCount>
struct Elimination {
  /// A chain's first element into the rows of the front that an elimination would leave.
  void (*start)(const Factor&, int lane, const double (*slide)[kDofs][kLanes], const ChainRole&,
                Front<kCount>&);
  /// Puts the next element behind the node that the last elimination left, and eliminates the node. Adds the
  /// number of pivots that are not positive, per rod.
  void (*eliminate)(const Factor&, int lane, const double (*slide)[kDofs][kLanes], const ChainRole&,
                    Front<kCount>&, Link<kCount>&, int* negative_pivots);
  /// Eliminates the node from a right-hand side. `far` [kNodeDofs][kCount]: of the next node; `border`: rows
  /// as in the front.
  void (*condense)(const Link<kCount>&, int border_rows, double (*node)[kCount], double (*far)[kCount],
                   double (*border)[kCount]);
  /// The node's rows of the solution from those of the next node and the border, and `node` as left by
  /// condense().
  void (*expand)(const Link<kCount>&, int border_rows, double (*node)[kCount], const double (*far)[kCount],
                 const double (*border)[kCount]);
};

struct ChainKernel {
  Elimination<kLanes> lanes;
  Elimination<1> alone;
  /// An element's force against its gradient: into the inner rows of `rhs` [kDofs][kLanes], the outer ones
  /// cleared, and added to its end nodes.
  void (*force)(const Energy&, double (*rhs)[kLanes], double (*left)[kLanes], double (*right)[kLanes]);
  /// Raises `largest` per lane to the largest component in `count` nodes' rows, moments over a length [m].
  void (*largest)(const double (*rows)[kLanes], int count, const double* gyration, double* largest);
  /// Moves the nodes of an element by `motion` [kDofs][kLanes] where `active` is not 0. Raises, per lane, the
  /// squares of the largest displacement and rotation met.
  void (*advance)(Input&, const double (*motion)[kLanes], const double* active, double* squared_displacement,
                  double* squared_rotation);
};

/// The fastest kernel this processor can run; of the same instruction set as kernel().
const ChainKernel& chainKernel();

extern const ChainKernel kBaselineChainKernel;
#ifdef CABLE_VARIATION_X86_KERNELS
extern const ChainKernel kAvx2ChainKernel;
extern const ChainKernel kAvx512ChainKernel;
#endif

}  // namespace cable_variation::element
