#define CABLE_VARIATION_KERNEL kAvx2Kernel
#define CABLE_VARIATION_WIDTH 4
#define CABLE_VARIATION_INSTRUCTION_SET "AVX2"
#include <cable_variation/rod/kernel/element_kernel.inl>
