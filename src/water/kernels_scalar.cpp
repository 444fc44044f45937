// The water on 1 element at a time.
#define FLOES_LANES 1
#define FLOES_WATER_KERNEL water_scalar
#include "water/water_kernels.inl"
