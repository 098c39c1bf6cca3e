#define CABLE_VARIATION_KERNEL kBaselineKernel
#define CABLE_VARIATION_WIDTH 2
#define CABLE_VARIATION_INSTRUCTION_SET "baseline"
#include <cable_variation/rod/kernel/element_kernel.inl>
