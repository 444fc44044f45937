// The water on 8 elements at a time.
#define FLOES_LANES 8
#define FLOES_WATER_KERNEL water_avx512
#include "water/water_kernels.inl"
