// Included once per instruction set, with CABLE_VARIATION_KERNEL naming the
// table to define and CABLE_VARIATION_WIDTH the doubles of a vector register.
// Everything else is in an unnamed namespace, so that no function compiled for
// one processor can be linked in place of another's.

#include <cable_variation/rod/kernel/element_kernel.h>
#include <cable_variation/rod/kernel/elimination.inl>

namespace cable_variation::element {
namespace {

struct Vec {
  Pack x, y, z;
};
struct Mat {
  Vec r0, r1, r2;  // rows
};
struct Quat {
  Pack w;
  Vec v;
};

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Pack s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec scale(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Vec divide(Vec a, Vec b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
inline Pack dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec operator*(const Mat& m, Vec v) { return {dot(m.r0, v), dot(m.r1, v), dot(m.r2, v)}; }
inline Vec transposeTimes(const Mat& m, Vec v) { return v.x * m.r0 + v.y * m.r1 + v.z * m.r2; }
inline Vec rowTimes(Vec v, const Mat& m) { return transposeTimes(m, v); }
inline Mat operator*(const Mat& a, const Mat& b) {
  return {rowTimes(a.r0, b), rowTimes(a.r1, b), rowTimes(a.r2, b)};
}
inline Mat operator+(const Mat& a, const Mat& b) { return {a.r0 + b.r0, a.r1 + b.r1, a.r2 + b.r2}; }
inline Mat transposeProduct(const Mat& a, const Mat& b) {  // aᵀ b
  return {a.r0.x * b.r0 + a.r1.x * b.r1 + a.r2.x * b.r2, a.r0.y * b.r0 + a.r1.y * b.r1 + a.r2.y * b.r2,
          a.r0.z * b.r0 + a.r1.z * b.r1 + a.r2.z * b.r2};
}
inline Mat skew(Vec v) {
  const Pack zero = {};
  return {{zero, -v.z, v.y}, {v.z, zero, -v.x}, {-v.y, v.x, zero}};
}
inline Mat outer(Vec a, Vec b) { return {a.x * b, a.y * b, a.z * b}; }
inline Mat scaleRows(Vec s, const Mat& m) { return {s.x * m.r0, s.y * m.r1, s.z * m.r2}; }
inline Mat operator*(double s, const Mat& m) { return {s * m.r0, s * m.r1, s * m.r2}; }
inline Mat operator*(Pack s, const Mat& m) { return {s * m.r0, s * m.r1, s * m.r2}; }
inline Quat operator*(double s, Quat a) { return {s * a.w, s * a.v}; }
inline Quat operator*(Pack s, Quat a) { return {s * a.w, s * a.v}; }
inline Quat operator+(Quat a, Quat b) { return {a.w + b.w, a.v + b.v}; }
inline Quat operator-(Quat a, Quat b) { return {a.w - b.w, a.v - b.v}; }
inline Quat operator*(Quat a, Quat b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
inline Quat conjugate(Quat a) { return {a.w, -1.0 * a.v}; }

constexpr double kSqrt5 = 2.23606797749978969640917366873128;
constexpr double kSqrt35 = 0.77459666924148337703585307995648;  // sqrt(3/5)
constexpr double kXi[kNodes] = {0.0, 0.5 - 0.5 / kSqrt5, 0.5 + 0.5 / kSqrt5, 1.0};
constexpr double kGaussXi[kGauss] = {0.5 - 0.5 * kSqrt35, 0.5, 0.5 + 0.5 * kSqrt35};
constexpr double kWeight[kGauss] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

// Lagrange polynomials of the nodes and their derivatives at the Gauss points.
struct Shape {
  double value[kGauss][kNodes];
  double slope[kGauss][kNodes];
};
constexpr Shape makeShape() {
  Shape shape{};
  for (int g = 0; g < kGauss; ++g) {
    for (int a = 0; a < kNodes; ++a) {
      double value = 1.0;
      double slope = 0.0;
      for (int b = 0; b < kNodes; ++b) {
        if (b == a) continue;
        double others = 1.0 / (kXi[a] - kXi[b]);
        for (int c = 0; c < kNodes; ++c) {
          if (c != a && c != b) others *= (kGaussXi[g] - kXi[c]) / (kXi[a] - kXi[c]);
        }
        slope += others;
        value *= (kGaussXi[g] - kXi[b]) / (kXi[a] - kXi[b]);
      }
      shape.value[g][a] = value;
      shape.slope[g][a] = slope;
    }
  }
  return shape;
}
constexpr Shape kShape = makeShape();

inline Vec loadVec(const double (*rows)[kLanes], int lane) {
  return {load(rows[0] + lane), load(rows[1] + lane), load(rows[2] + lane)};
}
inline Quat loadQuat(const double (*rows)[kLanes], int lane) {
  return {load(rows[0] + lane), loadVec(rows + 1, lane)};
}

// Strains and stresses at a Gauss point, and what the chain rule to the nodes
// needs. Variations: the section frame turns by the Gibbs vector b (half the
// rotation vector to first order), its rate along the element is b'.
struct GaussState {
  Mat R;
  Vec gamma, omega;  // Γ, Ω
  Vec n, m;          // K_Γ (Γ - Γ₀), K_Ω (Ω - Ω₀), section frame
  Vec k_gamma, k_omega;
  Quat rate;     // Q⁻¹ dQ/dξ
  Quat inverse;  // Q⁻¹
  Vec gamma_strain, omega_strain;
};

inline GaussState gaussState(const Input& in, int g, int lane, Pack inverse_length) {
  const Pack zero = {};
  Quat Q{zero, {zero, zero, zero}};
  Quat E = Q;
  Vec d{zero, zero, zero};
  for (int a = 0; a < kNodes; ++a) {
    const Quat q = loadQuat(in.quaternion[a], lane);
    Q = Q + kShape.value[g][a] * q;
    E = E + kShape.slope[g][a] * q;
    d = d + kShape.slope[g][a] * loadVec(in.position[a], lane);
  }
  GaussState s;
  const Pack inverse_norm2 = 1.0 / (Q.w * Q.w + dot(Q.v, Q.v));
  s.inverse = inverse_norm2 * conjugate(Q);
  s.rate = s.inverse * E;
  const Pack w = Q.w, x = Q.v.x, y = Q.v.y, z = Q.v.z;
  const Pack two = 2.0 * inverse_norm2;
  s.R = {{1.0 - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)},
         {two * (x * y + w * z), 1.0 - two * (x * x + z * z), two * (y * z - w * x)},
         {two * (x * z - w * y), two * (y * z + w * x), 1.0 - two * (x * x + y * y)}};
  s.gamma = inverse_length * transposeTimes(s.R, d);
  s.omega = (2.0 * inverse_length) * s.rate.v;
  s.k_gamma = loadVec(in.stiffness[g], lane);
  s.k_omega = loadVec(in.stiffness[g] + 3, lane);
  s.gamma_strain = {s.gamma.x - 1.0, s.gamma.y, s.gamma.z};
  s.omega_strain = s.omega - loadVec(in.rest_curvature[g], lane);
  s.n = scale(s.k_gamma, s.gamma_strain);
  s.m = scale(s.k_omega, s.omega_strain);
  return s;
}

// How a node's rotation vector θ moves the Gauss point: b = C θ, b' = D θ, and
// the scale of the interpolated quaternion by r·θ, its rate by r'·θ. C and D
// are scalar plus skew: C θ = c.w θ + c.v × θ.
struct NodeMap {
  Quat c, d;
};
inline NodeMap nodeMap(const Input& in, const GaussState& s, int g, int a, int lane) {
  const Quat c = (0.5 * kShape.value[g][a]) * (s.inverse * loadQuat(in.quaternion[a], lane));
  const Quat slope = (kShape.slope[g][a] / kShape.value[g][a]) * c;
  return {c, slope - s.rate * c};
}
inline Vec mapTransposed(Quat c, Vec g) { return c.w * g + cross(g, c.v); }
inline Mat matrix(Quat c) { return {{c.w, -c.v.z, c.v.y}, {c.v.z, c.w, -c.v.x}, {-c.v.y, c.v.x, c.w}}; }

inline void addVec(double (*rows)[kLanes], int lane, Vec v) {
  add(rows[0] + lane, v.x);
  add(rows[1] + lane, v.y);
  add(rows[2] + lane, v.z);
}

// Adds m to the block whose first row and column are given; on the diagonal
// only its lower triangle is kept.
inline void addBlock(double (*matrix_rows)[kLanes], int row, int column, int lane, const Mat& m) {
  const Vec rows[3] = {m.r0, m.r1, m.r2};
  for (int i = 0; i < 3; ++i) {
    const Pack entries[3] = {rows[i].x, rows[i].y, rows[i].z};
    const int end = row == column ? i + 1 : 3;
    for (int j = 0; j < end; ++j) add(matrix_rows[packed(row + i, column + j)] + lane, entries[j]);
  }
}

inline Mat transpose(const Mat& m) {
  return {{m.r0.x, m.r1.x, m.r2.x}, {m.r0.y, m.r1.y, m.r2.y}, {m.r0.z, m.r1.z, m.r2.z}};
}

template <bool kWithHessian>
inline void evaluate(const Input& in, Energy& out, Factor* factor, bool given_stress, int lane) {
  const Pack length = load(in.length + lane);
  const Pack inverse_length = 1.0 / length;
  const Pack zero = {};
  Pack elastic = zero;
  Pack potential = zero;
  for (int i = 0; i < kDofs; ++i) store(out.gradient[i] + lane, zero);
  if constexpr (kWithHessian) {
    for (int i = 0; i < kDofs * (kDofs + 1) / 2; ++i) store(factor->matrix[i] + lane, zero);
  }
  for (int g = 0; g < kGauss; ++g) {
    const GaussState s = gaussState(in, g, lane, inverse_length);
    const double w = kWeight[g];
    const Pack wh = w * length;
    const Vec f = loadVec(in.load[g], lane);
    elastic += 0.5 * wh * (dot(s.n, s.gamma_strain) + dot(s.m, s.omega_strain));
    const Vec g_position = w * (s.R * s.n);
    const Vec g_b = (2.0 * wh) * (cross(s.n, s.gamma) + cross(s.m, s.omega));
    const Vec g_rate = (2.0 * w) * s.m;

    NodeMap maps[kNodes];
    for (int a = 0; a < kNodes; ++a) {
      maps[a] = nodeMap(in, s, g, a, lane);
      const Vec x = loadVec(in.position[a], lane);
      const Vec fa = (kShape.value[g][a] * wh) * f;
      potential -= dot(fa, x);
      const int row = kFirstDof[a];
      addVec(out.gradient + row, lane, kShape.slope[g][a] * g_position - fa);
      addVec(out.gradient + row + 3, lane, mapTransposed(maps[a].c, g_b) + mapTransposed(maps[a].d, g_rate));
    }
    if constexpr (kWithHessian) {
      const Mat skew_gamma = skew(s.gamma);
      const Mat skew_omega = skew(s.omega);
      const Mat stiff = (w * inverse_length) * (s.R * scaleRows(s.k_gamma, transpose(s.R)));
      const Vec n = given_stress ? loadVec(in.stress[g], lane) : s.n;
      const Vec m = given_stress ? loadVec(in.stress[g] + 3, lane) : s.m;
      const Vec h_b_gradient = (2.0 * wh) * (cross(n, s.gamma) + cross(m, s.omega));
      const Vec h_rate_gradient = (2.0 * w) * m;
      Vec h_theta[kNodes], t[kNodes];
      for (int a = 0; a < kNodes; ++a) {
        t[a] = mapTransposed(maps[a].c, h_rate_gradient);
        h_theta[a] = mapTransposed(maps[a].c, h_b_gradient) + mapTransposed(maps[a].d, h_rate_gradient);
      }
      const Mat k_skew_gamma = scaleRows(s.k_gamma, skew_gamma);
      const Mat mixed = s.R * ((2.0 * w) * (k_skew_gamma + (-1.0) * skew(n)));
      const Mat k_skew_omega = scaleRows(s.k_omega, skew_omega);
      Mat h_bb =
          4.0 * (transposeProduct(skew_gamma, k_skew_gamma) + transposeProduct(skew_omega, k_skew_omega)) +
          2.0 * (outer(s.gamma, n) + outer(n, s.gamma) + outer(s.omega, m) + outer(m, s.omega));
      const Pack diagonal = 4.0 * (dot(n, s.gamma) + dot(m, s.omega));
      h_bb.r0.x -= diagonal;
      h_bb.r1.y -= diagonal;
      h_bb.r2.z -= diagonal;
      h_bb = wh * h_bb;
      // ∂²/∂b∂b', b in rows: 2w (2 [Ω]×ᵀ K_Ω + [m]×)
      const Mat h_b_rate = (2.0 * w) * (2.0 * transpose(k_skew_omega) + skew(m));
      const Vec h_rate = (4.0 * w * inverse_length) * s.k_omega;

      for (int c = 0; c < kNodes; ++c) {
        const Mat C = matrix(maps[c].c);
        const Mat D = matrix(maps[c].d);
        // the scale of an interpolated quaternion changes b at second order: here by that of c, below of a
        const Mat of_b =
            h_bb * C + h_b_rate * D + outer(h_b_gradient, maps[c].c.v) + outer(h_rate_gradient, maps[c].d.v);
        const Mat of_rate =
            transposeProduct(h_b_rate, C) + scaleRows(h_rate, D) + outer(h_rate_gradient, maps[c].c.v);
        const Mat position_rotation = mixed * C;
        const int column = kFirstDof[c];
        // with the nodes known, so are places in the matrix and the weights
#pragma GCC unroll 4
        for (int a = 0; a < kNodes; ++a) {
          const int row = kFirstDof[a];
          const double slope_a = kShape.slope[g][a];
          if (row >= column) {
            addBlock(factor->matrix, row, column, lane, (slope_a * kShape.slope[g][c]) * stiff);
            Mat block = transposeProduct(matrix(maps[a].c), of_b) +
                        transposeProduct(matrix(maps[a].d), of_rate) + outer(maps[a].c.v, h_theta[c]) +
                        outer(maps[a].d.v, t[c]);
            if (a == c) {
              // exp(θ/2) = 1 + θ/2 - |θ|²/8
              const Pack bend = 0.5 * (dot(h_b_gradient, maps[a].c.v) + dot(h_rate_gradient, maps[a].d.v));
              block.r0.x -= bend;
              block.r1.y -= bend;
              block.r2.z -= bend;
            }
            addBlock(factor->matrix, row + 3, column + 3, lane, block);
          }
          // position of a, rotation of c
          const Mat coupling = slope_a * position_rotation;
          if (row > column) {
            addBlock(factor->matrix, row, column + 3, lane, coupling);
          } else {
            addBlock(factor->matrix, column + 3, row, lane, transpose(coupling));
          }
        }
      }
    }
  }
  store(out.elastic + lane, elastic);
  store(out.load + lane, potential);
}

void energy(const Input& in, Energy& out) {
  for (int lane = 0; lane < kLanes; lane += kWidth) evaluate<false>(in, out, nullptr, false, lane);
}

void hessian(const Input& in, Energy& out, Factor& factor, bool given_stress) {
  for (int lane = 0; lane < kLanes; lane += kWidth) evaluate<true>(in, out, &factor, given_stress, lane);
}

void predict(const Input& in, const double (*motion)[kLanes], double (*stress)[6][kLanes]) {
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    const Pack inverse_length = 1.0 / load(in.length + lane);
    const Pack zero = {};
    for (int g = 0; g < kGauss; ++g) {
      const GaussState s = gaussState(in, g, lane, inverse_length);
      Vec shift{zero, zero, zero};  // of dφ/dξ, world
      Vec b = shift, rate = shift;
      for (int a = 0; a < kNodes; ++a) {
        const NodeMap map = nodeMap(in, s, g, a, lane);
        const int row = kFirstDof[a];
        const Vec theta = loadVec(motion + row + 3, lane);
        shift = shift + kShape.slope[g][a] * loadVec(motion + row, lane);
        b = b + map.c.w * theta + cross(map.c.v, theta);
        rate = rate + map.d.w * theta + cross(map.d.v, theta);
      }
      const Vec gamma = inverse_length * transposeTimes(s.R, shift) + 2.0 * cross(s.gamma, b);
      const Vec omega = 2.0 * (inverse_length * rate + cross(s.omega, b));
      const Vec n = s.n + scale(s.k_gamma, gamma);
      const Vec m = s.m + scale(s.k_omega, omega);
      const Pack values[6] = {n.x, n.y, n.z, m.x, m.y, m.z};
      for (int k = 0; k < 6; ++k) store(stress[g][k] + lane, values[k]);
    }
  }
}

void factorise(Factor& factor, const double (*shift)[kLanes], int* negative_pivots) {
  for (int lane = 0; lane < kLanes; ++lane) negative_pivots[lane] = 0;
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    for (int i = 0; i < kDofs; ++i) add(factor.matrix[packed(i, i)] + lane, load(shift[i] + lane));
    static_assert(kInner == 2 * kPanel, "a panel per inner node");
    eliminatePanel<kDofs, 0>(factor.matrix, factor.inverse_pivot, lane);
    eliminatePanel<kDofs, kPanel>(factor.matrix, factor.inverse_pivot, lane);
  }
  for (int k = 0; k < kInner; ++k) {
    for (int lane = 0; lane < kLanes; ++lane)
      negative_pivots[lane] += factor.inverse_pivot[k][lane] > 0.0 ? 0 : 1;
  }
}

void condense(const Factor& factor, double (*rhs)[kLanes]) {
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    Pack value[kInner];
    for (int k = 0; k < kInner; ++k) {
      Pack of = load(rhs[k] + lane);
      for (int j = 0; j < k; ++j) of -= load(factor.matrix[packed(k, j)] + lane) * value[j];
      value[k] = of;
      store(rhs[k] + lane, of);
    }
    for (int i = kInner; i < kDofs; ++i) {
      Pack of = load(rhs[i] + lane);
      for (int k = 0; k < kInner; ++k) of -= load(factor.matrix[packed(i, k)] + lane) * value[k];
      store(rhs[i] + lane, of);
    }
  }
}

void expand(const Factor& factor, double (*x)[kLanes]) {
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    Pack value[kInner];
    for (int k = 0; k < kInner; ++k) value[k] = load(x[k] + lane) * load(factor.inverse_pivot[k] + lane);
    for (int i = kDofs - 1; i >= kInner; --i) {
      const Pack known = load(x[i] + lane);
      for (int k = 0; k < kInner; ++k) value[k] -= load(factor.matrix[packed(i, k)] + lane) * known;
    }
    for (int i = kInner - 1; i >= 0; --i) {
      store(x[i] + lane, value[i]);
      for (int k = 0; k < i; ++k) value[k] -= load(factor.matrix[packed(i, k)] + lane) * value[i];
    }
  }
}

// With the nodes' poses held, the element's ends move along the rod: its length
// changes by dh and its Gauss points look at another place of the rod, ds on.
//
// The gradient holds half of stress times strain. With given stresses these are taken for it: the square of
// the stretch that a finite rotation feigns is in a slender rod a force as large as the true ones, and
// Newton's step, which takes the stretch away, knows nothing of it.
void arcLength(const Input& in, const InputSlope& slope, ArcLength& out, bool given_stress) {
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    const Pack length = load(in.length + lane);
    const Pack inverse_length = 1.0 / length;
    const Pack zero = {};
    for (int end = 0; end < 2; ++end) {
      store(out.gradient[end] + lane, zero);
      for (int i = 0; i < kDofs; ++i) store(out.mixed[end][i] + lane, zero);
    }
    for (int i = 0; i < 3; ++i) store(out.second[i] + lane, zero);
    for (int g = 0; g < kGauss; ++g) {
      const GaussState s = gaussState(in, g, lane, inverse_length);
      const double w = kWeight[g];
      const Vec f = loadVec(in.load[g], lane);
      const Vec f_s = loadVec(slope.load[g], lane);
      const Vec rest_s = loadVec(slope.rest_curvature[g], lane);
      const Vec rest_ss = loadVec(slope.rest_curvature_second[g], lane);
      const Vec k_omega_s = loadVec(slope.stiffness[g] + 3, lane);
      Vec x{zero, zero, zero};
      for (int a = 0; a < kNodes; ++a) x = x + kShape.value[g][a] * loadVec(in.position[a], lane);

      const Vec n_s = scale(loadVec(slope.stiffness[g], lane), s.gamma_strain);
      const Vec softening = scale(k_omega_s, s.omega_strain);
      const Vec m_s = softening - scale(s.k_omega, rest_s);
      const Vec n_h = (-1.0 * inverse_length) * scale(s.k_gamma, s.gamma);
      const Vec m_h = (-1.0 * inverse_length) * scale(s.k_omega, s.omega);
      Pack stored = 0.5 * (dot(s.n, s.gamma_strain) + dot(s.m, s.omega_strain));
      Pack stored_s = 0.5 * (dot(n_s, s.gamma_strain) + dot(softening, s.omega_strain)) - dot(s.m, rest_s);
      if (given_stress) {
        const Vec n = loadVec(in.stress[g], lane), m = loadVec(in.stress[g] + 3, lane);
        const Vec gamma = divide(n, s.k_gamma), omega = divide(m, s.k_omega);
        stored = 0.5 * (dot(n, gamma) + dot(m, omega));
        stored_s = 0.5 * (dot(scale(loadVec(slope.stiffness[g], lane), gamma), gamma) +
                          dot(scale(k_omega_s, omega), omega)) -
                   dot(s.m, rest_s);
      }
      const Pack e = stored - dot(s.n, s.gamma) - dot(s.m, s.omega) - dot(f, x);
      const Pack a = stored_s - dot(f_s, x);
      const Pack e_h = -1.0 * (dot(n_h, s.gamma) + dot(m_h, s.omega));
      const Pack e_s = a - dot(n_s, s.gamma) - dot(m_s, s.omega);
      const Pack a_s = -1.0 * (dot(softening, rest_s) + dot(m_s, rest_s) + dot(s.m, rest_ss));

      const double dh[2] = {-1.0, 1.0};
      const double ds[2] = {1.0 - kGaussXi[g], kGaussXi[g]};
      for (int end = 0; end < 2; ++end) {
        add(out.gradient[end] + lane, w * (dh[end] * e + ds[end] * (length * a)));
        const Vec n = dh[end] * n_h + ds[end] * n_s;
        const Vec m = dh[end] * m_h + ds[end] * m_s;
        const Vec g_position = w * (s.R * n);
        const Vec g_b = (2.0 * w * length) * (cross(n, s.gamma) + cross(m, s.omega));
        const Vec g_rate = (2.0 * w) * m;
        const Vec force = w * (dh[end] * f + ds[end] * (length * f_s));
        for (int node = 0; node < kNodes; ++node) {
          const NodeMap map = nodeMap(in, s, g, node, lane);
          const int row = kFirstDof[node];
          addVec(out.mixed[end] + row, lane,
                 kShape.slope[g][node] * g_position - kShape.value[g][node] * force);
          addVec(out.mixed[end] + row + 3, lane, mapTransposed(map.c, g_b) + mapTransposed(map.d, g_rate));
        }
        for (int other = 0; other <= end; ++other) {
          add(out.second[end + other] + lane,
              w * (dh[end] * dh[other] * e_h + (dh[end] * ds[other] + ds[end] * dh[other]) * e_s +
                   (ds[end] * ds[other]) * (length * a_s)));
        }
      }
    }
  }
}

}  // namespace

extern const Kernel CABLE_VARIATION_KERNEL = {
    CABLE_VARIATION_INSTRUCTION_SET, energy, hessian, predict, arcLength, factorise, condense, expand};

}  // namespace cable_variation::element
