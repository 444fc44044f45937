// The water on 4 elements at a time.
#define FLOES_LANES 4
#define FLOES_WATER_KERNEL water_avx2
#include "water/water_kernels.inl"
