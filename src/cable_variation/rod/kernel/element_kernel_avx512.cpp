#define CABLE_VARIATION_KERNEL kAvx512Kernel
#define CABLE_VARIATION_WIDTH 8
#define CABLE_VARIATION_INSTRUCTION_SET "AVX-512"
#include <cable_variation/rod/kernel/element_kernel.inl>
