// The element's derivatives against central differences of its energy, and its
// invariance under rigid motions, for every instruction set this processor has.

#include <cable_variation/rod/kernel/element_kernel.h>

#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace cable_variation::element {
namespace {

int packed(int row, int column) { return row >= column ? row * (row + 1) / 2 + column : packed(column, row); }

Eigen::Quaterniond exponential(const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  return angle == 0.0 ? Eigen::Quaterniond::Identity()
                      : Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation / angle));
}

Eigen::Quaterniond quaternion(const Input& in, int node, int lane) {
  const auto& q = in.quaternion[node];
  return {q[0][lane], q[1][lane], q[2][lane], q[3][lane]};
}

void setQuaternion(Input& in, int node, int lane, const Eigen::Quaterniond& q) {
  in.quaternion[node][0][lane] = q.w();
  in.quaternion[node][1][lane] = q.x();
  in.quaternion[node][2][lane] = q.y();
  in.quaternion[node][3][lane] = q.z();
}

/// A strained element whose data vary along it: section linear, rest curvature
/// quadratic in arc length, so that its slopes are exact.
struct Rod {
  double stiffness0[6] = {40.0, 15.0, 11.0, 0.02, 0.03, 0.05};
  double stiffness1[6] = {70.0, -20.0, 9.0, 0.03, -0.02, 0.04};
  Eigen::Vector3d curvature0{0.8, -1.0, 0.5}, curvature1{3.0, 2.0, -4.0}, curvature2{20.0, -10.0, 30.0};
  Eigen::Vector3d load0{0.1, -0.2, -2.0}, load1{0.3, 0.4, -1.0};

  void fill(Input& in, InputSlope& slope, int lane, double left, double right) const {
    in.length[lane] = right - left;
    for (int g = 0; g < kGauss; ++g) {
      const double s = left + kGaussAt[g] * (right - left);
      for (int i = 0; i < 6; ++i) {
        in.stiffness[g][i][lane] = stiffness0[i] + s * stiffness1[i];
        slope.stiffness[g][i][lane] = stiffness1[i];
      }
      for (int i = 0; i < 3; ++i) {
        in.rest_curvature[g][i][lane] = curvature0[i] + s * curvature1[i] + s * s * curvature2[i];
        slope.rest_curvature[g][i][lane] = curvature1[i] + 2.0 * s * curvature2[i];
        slope.rest_curvature_second[g][i][lane] = 2.0 * curvature2[i];
        in.load[g][i][lane] = load0[i] + s * load1[i];
        slope.load[g][i][lane] = load1[i];
      }
    }
  }
};

constexpr double kLeft = 0.07;
constexpr double kRight = 0.19;

class ElementKernelTest : public testing::TestWithParam<const Kernel*> {
 protected:
  void SetUp() override {
    std::mt19937 generator(7);
    std::normal_distribution<double> normal;
    for (int lane = 0; lane < kLanes; ++lane) {
      rod_.fill(input_, slope_, lane, kLeft, kRight);
      for (int a = 0; a < kNodes; ++a) {
        Eigen::Vector3d turn(normal(generator), normal(generator), normal(generator));
        setQuaternion(input_, a, lane,
                      exponential(0.2 * turn + kNodeAt[a] * Eigen::Vector3d(0.3, 1.0, -0.5)));
        for (int i = 0; i < 3; ++i) {
          input_.position[a][i][lane] = (i == 0 ? 0.12 * kNodeAt[a] : 0.0) + 0.01 * normal(generator);
        }
      }
    }
  }

  double total(const Input& in, int lane) const {
    Energy out;
    GetParam()->energy(in, out);
    return out.elastic[lane] + out.load[lane];
  }

  Input moved(int dof, int lane, double step) const {
    Input in = input_;
    for (int a = 0; a < kNodes; ++a) {
      const int i = dof - kFirstDof[a];
      if (i < 0 || i >= 6) continue;
      if (i < 3) {
        in.position[a][i][lane] += step;
      } else {
        setQuaternion(in, a, lane,
                      quaternion(in, a, lane) * exponential(step * Eigen::Vector3d::Unit(i - 3)));
      }
    }
    return in;
  }

  Rod rod_;
  Input input_{};
  InputSlope slope_{};
};

TEST_P(ElementKernelTest, GradientIsTheDerivativeOfTheEnergy) {
  Energy out;
  GetParam()->energy(input_, out);
  for (int lane = 0; lane < kLanes; ++lane) {
    for (int i = 0; i < kDofs; ++i) {
      const double h = 1e-6;
      const double difference = (total(moved(i, lane, h), lane) - total(moved(i, lane, -h), lane)) / (2 * h);
      EXPECT_NEAR(out.gradient[i][lane], difference, 1e-8) << "degree of freedom " << i;
    }
  }
}

TEST_P(ElementKernelTest, HessianIsTheSecondDerivativeOfTheEnergy) {
  Energy out;
  Factor factor;
  GetParam()->hessian(input_, out, factor, false);
  // along a geodesic through two degrees of freedom at once: the exponential's
  // second derivative is vᵀHv, so polarise
  const double h = 3e-4;
  const auto second = [&](int i, int j, int lane) {
    const auto along = [&](double step) {
      Input in = input_;
      for (int a = 0; a < kNodes; ++a) {
        Eigen::Vector3d shift = Eigen::Vector3d::Zero(), turn = shift;
        for (int dof : {i, j}) {
          const int k = dof - kFirstDof[a];
          if (k >= 0 && k < 3) shift[k] += step;
          if (k >= 3 && k < 6) turn[k - 3] += step;
          if (i == j) break;
        }
        for (int k = 0; k < 3; ++k) in.position[a][k][lane] += shift[k];
        setQuaternion(in, a, lane, quaternion(in, a, lane) * exponential(turn));
      }
      return total(in, lane);
    };
    // fourth-order central second difference
    return (-along(2 * h) + 16 * along(h) - 30 * along(0) + 16 * along(-h) - along(-2 * h)) / (12 * h * h);
  };
  const int lane = 3;
  for (int i = 0; i < kDofs; ++i) {
    for (int j = 0; j <= i; ++j) {
      const double expected =
          i == j ? second(i, i, lane) : 0.5 * (second(i, j, lane) - second(i, i, lane) - second(j, j, lane));
      EXPECT_NEAR(factor.matrix[packed(i, j)][lane], expected, 2e-6 * (1.0 + std::abs(expected)))
          << "degrees of freedom " << i << " " << j;
    }
  }
}

TEST_P(ElementKernelTest, ArcLengthDerivativesAreThoseOfTheEnergy) {
  ArcLength out;
  GetParam()->arcLength(input_, slope_, out, false);
  const auto at = [&](double left, double right) {
    Input in = input_;
    InputSlope unused;
    for (int lane = 0; lane < kLanes; ++lane) rod_.fill(in, unused, lane, kLeft + left, kRight + right);
    return in;
  };
  const double h = 1e-5;
  for (int lane = 0; lane < kLanes; ++lane) {
    for (int end = 0; end < 2; ++end) {
      const Input ahead = end == 0 ? at(h, 0) : at(0, h);
      const Input behind = end == 0 ? at(-h, 0) : at(0, -h);
      Energy plus, minus;
      GetParam()->energy(ahead, plus);
      GetParam()->energy(behind, minus);
      const double difference = (total(ahead, lane) - total(behind, lane)) / (2 * h);
      EXPECT_NEAR(out.gradient[end][lane], difference, 1e-6 * (1.0 + std::abs(difference)));
      for (int i = 0; i < kDofs; ++i) {
        const double mixed = (plus.gradient[i][lane] - minus.gradient[i][lane]) / (2 * h);
        EXPECT_NEAR(out.mixed[end][i][lane], mixed, 1e-6 * (1.0 + std::abs(mixed)));
      }
    }
    const double step = 1e-4;
    const double both = (total(at(step, step), lane) - total(at(step, -step), lane) -
                         total(at(-step, step), lane) + total(at(-step, -step), lane)) /
                        (4 * step * step);
    EXPECT_NEAR(out.second[1][lane], both, 1e-3 * (1.0 + std::abs(both)));
    const double left =
        (total(at(step, 0), lane) - 2 * total(at(0, 0), lane) + total(at(-step, 0), lane)) / (step * step);
    EXPECT_NEAR(out.second[0][lane], left, 1e-3 * (1.0 + std::abs(left)));
    const double right =
        (total(at(0, step), lane) - 2 * total(at(0, 0), lane) + total(at(0, -step), lane)) / (step * step);
    EXPECT_NEAR(out.second[2][lane], right, 1e-3 * (1.0 + std::abs(right)));
  }
}

TEST_P(ElementKernelTest, ElasticEnergyIsInvariantUnderRigidMotions) {
  const Eigen::Quaterniond turn = exponential({0.7, -1.9, 0.4});
  Input in = input_;
  for (int a = 0; a < kNodes; ++a) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const Eigen::Vector3d p(in.position[a][0][lane], in.position[a][1][lane], in.position[a][2][lane]);
      const Eigen::Vector3d moved_p = turn * p + Eigen::Vector3d(3.0, -2.0, 5.0);
      for (int i = 0; i < 3; ++i) in.position[a][i][lane] = moved_p[i];
      setQuaternion(in, a, lane, turn * quaternion(in, a, lane));
    }
  }
  Energy before, after;
  GetParam()->energy(input_, before);
  GetParam()->energy(in, after);
  for (int lane = 0; lane < kLanes; ++lane) {
    EXPECT_NEAR(after.elastic[lane], before.elastic[lane], 1e-10 * before.elastic[lane]);
  }
}

TEST_P(ElementKernelTest, EliminationSolvesTheFullSystem) {
  Energy out;
  Factor factor;
  GetParam()->hessian(input_, out, factor, false);
  double shift[kDofs][kLanes];
  for (auto& row : shift) std::fill(row, row + kLanes, 25.0);
  Eigen::MatrixXd full(kDofs, kDofs);
  const int lane = 5;
  for (int i = 0; i < kDofs; ++i) {
    for (int j = 0; j < kDofs; ++j) full(i, j) = factor.matrix[packed(i, j)][lane] + (i == j ? 25.0 : 0.0);
  }
  int negative[kLanes];
  GetParam()->factorise(factor, shift, negative);
  const Eigen::VectorXd inner_eigenvalues =
      full.topLeftCorner(kInner, kInner).selfadjointView<Eigen::Lower>().eigenvalues();
  EXPECT_EQ(negative[lane], (inner_eigenvalues.array() < 0).count());

  alignas(64) double rhs[kDofs][kLanes];
  Eigen::VectorXd b(kDofs);
  for (int i = 0; i < kDofs; ++i) {
    for (int l = 0; l < kLanes; ++l) rhs[i][l] = std::sin(1.0 + i + l);
    b[i] = rhs[i][lane];
  }
  GetParam()->condense(factor, rhs);
  Eigen::MatrixXd schur(kOuter, kOuter);
  Eigen::VectorXd condensed(kOuter);
  for (int i = 0; i < kOuter; ++i) {
    condensed[i] = rhs[kInner + i][lane];
    for (int j = 0; j < kOuter; ++j) schur(i, j) = factor.matrix[packed(kInner + i, kInner + j)][lane];
  }
  const Eigen::VectorXd outer = schur.partialPivLu().solve(condensed);
  for (int i = 0; i < kOuter; ++i) rhs[kInner + i][lane] = outer[i];
  GetParam()->expand(factor, rhs);
  const Eigen::VectorXd expected = full.partialPivLu().solve(b);
  for (int i = 0; i < kDofs; ++i) EXPECT_NEAR(rhs[i][lane], expected[i], 1e-9 * expected.norm());
}

std::vector<const Kernel*> runnableKernels() {
  std::vector<const Kernel*> kernels{&kBaselineKernel};
#ifdef CABLE_VARIATION_X86_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) kernels.push_back(&kAvx2Kernel);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    kernels.push_back(&kAvx512Kernel);
#endif
  return kernels;
}

std::string kernelName(const testing::TestParamInfo<const Kernel*>& info) {
  std::string name;
  for (const char* c = info.param->instruction_set; *c != '\0'; ++c) {
    if (std::isalnum(static_cast<unsigned char>(*c)) != 0) name += *c;
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, ElementKernelTest, testing::ValuesIn(runnableKernels()),
                         kernelName);

}  // namespace
}  // namespace cable_variation::element
