#include <cable_variation/rod/kernel/chain_kernel.h>

namespace cable_variation::element {

const ChainKernel& chainKernel() {
#ifdef CABLE_VARIATION_X86_KERNELS
  if (&kernel() == &kAvx512Kernel) return kAvx512ChainKernel;
  if (&kernel() == &kAvx2Kernel) return kAvx2ChainKernel;
#endif
  return kBaselineChainKernel;
}

}  // namespace cable_variation::element
