// Kernels of 8 lanes.
#define FLOES_LANES 8
#define FLOES_KERNELS kernels_avx512
#include "solver/kernels.inl"
