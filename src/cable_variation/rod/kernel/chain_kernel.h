#pragma once

#include <cable_variation/rod/kernel/element_kernel.h>

/// Rows of elements of several rods side by side: kLanes rods that differ in numbers only, the lane is the
/// rod. Elements whose inner nodes are eliminated (element::Kernel) are linked to a chain, its nodes
/// eliminated from the near end to the far one, and all of it moved by the solution.
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
constexpr int kLargestLink = 2 * kNodeDofs + kLargestBorder;

/// A node of a chain: row-major lower triangle over the node itself, the next one towards the far end, and
/// the border; A = L D Lᵀ over the node's rows, the Schur complement in the rest.
struct alignas(64) Link {
  double matrix[kLargestLink * (kLargestLink + 1) / 2][kLanes];
  double inverse_pivot[kNodeDofs][kLanes];
};

/// How an element sits in its chain.
struct ChainRole {
  bool reversed = false;   ///< its right end is the near one
  bool near_held = false;  ///< the chain's near end does not move
  bool slides = false;     ///< the chain's arc lengths are unknowns
  int border() const { return (near_held ? 0 : kNodeDofs) + (slides ? kSlides : 0); }
};

struct ChainKernel {
  /// A chain's first element into the rows of `root` that an elimination would leave. `slide`: coupling of
  /// the element's rows to both arc lengths, [kSlides][kDofs][kLanes]; not read without slides.
  void (*start)(const Factor&, const double (*slide)[kDofs][kLanes], const ChainRole&, Link& root);
  /// Puts the next element behind the node that `before` left, and eliminates the node. Adds the number of
  /// pivots that are not positive, per lane.
  void (*eliminate)(const Factor&, const double (*slide)[kDofs][kLanes], const ChainRole&, const Link& before,
                    Link& link, int* negative_pivots);
  /// Eliminates the node from a right-hand side. `far` [kNodeDofs][kLanes]: of the next node; `border`: rows
  /// as in the link.
  void (*condense)(const Link&, int border_rows, double (*node)[kLanes], double (*far)[kLanes],
                   double (*border)[kLanes]);
  /// The node's rows of the solution from those of the next node and the border, and `node` as left by
  /// condense().
  void (*expand)(const Link&, int border_rows, double (*node)[kLanes], const double (*far)[kLanes],
                 const double (*border)[kLanes]);
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
