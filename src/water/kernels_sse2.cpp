// The water on 2 elements at a time.
#define FLOES_LANES 2
#define FLOES_WATER_KERNEL water_sse2
#include "water/water_kernels.inl"
