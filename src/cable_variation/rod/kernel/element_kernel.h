#pragma once

#include <cstddef>

/// Energy, gradient and Hessian of rod elements, several elements side by side.
///
/// The element interpolates positions and (unnormalised) quaternions of four
/// nodes by cubic polynomials and integrates the energy with three Gauss
/// points. Normalised quaternion polynomials are invariant under rotations from
/// either side, so the strains are objective; with as many Gauss points as the
/// degree the element does not lock and its end nodes converge with order six
/// (the Galerkin counterpart of Gauss collocation). The two inner nodes are
/// eliminated inside the element.
///
/// Plain arrays only: this header is compiled once per instruction set, so
/// nothing with inline functions of its own (Eigen, the standard library) may
/// be included here.
namespace cable_variation::element {

constexpr int kDegree = 3;
constexpr int kNodes = kDegree + 1;
constexpr int kGauss = kDegree;
constexpr int kInner = 6 * (kNodes - 2);  ///< degrees of freedom eliminated
constexpr int kOuter = 12;                ///< those of the two end nodes
constexpr int kDofs = kInner + kOuter;    ///< inner nodes first, then the left and the right end
constexpr int kLanes = 8;                 ///< elements per batch
/// Row of each node's first degree of freedom.
constexpr int kFirstDof[kNodes] = {kInner, 0, 6, kInner + 6};

/// Position of the nodes and the Gauss points in the element, 0 to 1.
extern const double kNodeAt[kNodes];
extern const double kGaussAt[kGauss];
extern const double kGaussWeight[kGauss];
/// Share of the element's length that belongs to each node (Lobatto weights).
extern const double kNodeShare[kNodes];

/// kLanes elements: index last is the lane. Unused lanes hold any regular element.
struct alignas(64) Input {
  double position[kNodes][3][kLanes];        ///< [m], world
  double quaternion[kNodes][4][kLanes];      ///< w x y z, unit, consecutive ones in one hemisphere
  double length[kLanes];                     ///< undeformed [m]
  double stiffness[kGauss][6][kLanes];       ///< EA GA_y GA_z [N], GJ EI_y EI_z [N m²]
  double rest_curvature[kGauss][3][kLanes];  ///< Ω₀ [1/m]
  double load[kGauss][3][kLanes];            ///< dead force per undeformed length [N/m], world
  /// Section force and moment [N], [N m], section frame, for the Hessian's geometric part: those predicted to
  /// first order before the last step (Kernel::predict). They are free of the stretch that a finite rotation
  /// feigns, which keeps Newton's method fast for stiff rods (Magisano, Leonetti and Garcea 2017).
  double stress[kGauss][6][kLanes];
};

/// What an arc-length derivative needs beside Input: how stiffness, rest
/// curvature and load change along the rod, per metre of undeformed length.
struct alignas(64) InputSlope {
  double stiffness[kGauss][6][kLanes];
  double rest_curvature[kGauss][3][kLanes];
  double rest_curvature_second[kGauss][3][kLanes];
  double load[kGauss][3][kLanes];
};

/// Gradient and, below, Hessian in the unknowns of Input: per node a
/// displacement in the world and a rotation vector in the section frame.
struct alignas(64) Energy {
  double elastic[kLanes];  ///< [J]
  double load[kLanes];     ///< potential of the load [J]
  double gradient[kDofs][kLanes];
};

/// Element stiffness with its inner nodes eliminated: A = L D Lᵀ over the first
/// kInner rows, the Schur complement in the rest. Row-major lower triangle.
struct alignas(64) Factor {
  double matrix[kDofs * (kDofs + 1) / 2][kLanes];
  double inverse_pivot[kInner][kLanes];
};

/// Derivatives with respect to the arc length of the element's two ends, the
/// nodes' poses held: gradient, mixed Hessian rows, and second derivatives.
struct alignas(64) ArcLength {
  double gradient[2][kLanes];  ///< [N]
  double mixed[2][kDofs][kLanes];
  double second[3][kLanes];  ///< (0,0) (1,0) (1,1)
};

/// The operations, compiled for one instruction set.
struct Kernel {
  const char* instruction_set;
  /// Energy and gradient.
  void (*energy)(const Input&, Energy&);
  /// Energy, gradient and Hessian, the latter not yet factorised; its geometric part from the section forces
  /// and moments there are, or from Input::stress.
  void (*hessian)(const Input&, Energy&, Factor&, bool given_stress);
  /// Section force and moment after `motion` [kDofs][kLanes], to first order, into `stress` as in Input.
  void (*predict)(const Input&, const double (*motion)[kLanes], double (*stress)[6][kLanes]);
  /// Derivatives with respect to arc length; the gradient with the section forces and moments there are, or
  /// linearised about Input::stress, which is the same at rest.
  void (*arcLength)(const Input&, const InputSlope&, ArcLength&, bool given_stress);
  /// Adds shift to the Hessian's diagonal, then eliminates the inner nodes.
  /// `shift` [kDofs][kLanes]. negative_pivots per lane.
  void (*factorise)(Factor&, const double (*shift)[kLanes], int* negative_pivots);
  /// Right-hand sides: eliminates the inner rows of `rhs` [kDofs][kLanes]; the
  /// outer rows become the condensed right-hand side.
  void (*condense)(const Factor&, double (*rhs)[kLanes]);
  /// Given the outer rows of the solution in `x`, and the inner rows as left by
  /// condense(), computes the inner rows of the solution.
  void (*expand)(const Factor&, double (*x)[kLanes]);
};

/// The fastest kernel this processor can run.
const Kernel& kernel();

extern const Kernel kBaselineKernel;
#ifdef CABLE_VARIATION_X86_KERNELS
extern const Kernel kAvx2Kernel;
extern const Kernel kAvx512Kernel;
#endif

}  // namespace cable_variation::element
