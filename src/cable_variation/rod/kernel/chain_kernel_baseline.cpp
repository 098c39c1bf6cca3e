#define CABLE_VARIATION_CHAIN_KERNEL kBaselineChainKernel
#define CABLE_VARIATION_WIDTH 2
#include <cable_variation/rod/kernel/chain_kernel.inl>
