#define CABLE_VARIATION_CHAIN_KERNEL kAvx2ChainKernel
#define CABLE_VARIATION_WIDTH 4
#include <cable_variation/rod/kernel/chain_kernel.inl>
