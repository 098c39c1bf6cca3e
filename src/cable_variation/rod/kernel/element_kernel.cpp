#include <cable_variation/rod/kernel/element_kernel.h>

#include <cmath>

namespace cable_variation::element {

const double kNodeAt[kNodes] = {0.0, 0.5 - 0.5 / std::sqrt(5.0), 0.5 + 0.5 / std::sqrt(5.0), 1.0};
const double kGaussAt[kGauss] = {0.5 - 0.5 * std::sqrt(0.6), 0.5, 0.5 + 0.5 * std::sqrt(0.6)};
const double kGaussWeight[kGauss] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
const double kNodeShare[kNodes] = {1.0 / 12.0, 5.0 / 12.0, 5.0 / 12.0, 1.0 / 12.0};

const Kernel& kernel() {
  static const Kernel& best = []() -> const Kernel& {
#ifdef CABLE_VARIATION_X86_KERNELS
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) return kAvx512Kernel;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return kAvx2Kernel;
#endif
    return kBaselineKernel;
  }();
  return best;
}

}  // namespace cable_variation::element
