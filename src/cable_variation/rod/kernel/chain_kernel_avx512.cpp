#define CABLE_VARIATION_CHAIN_KERNEL kAvx512ChainKernel
#define CABLE_VARIATION_WIDTH 8
#include <cable_variation/rod/kernel/chain_kernel.inl>
