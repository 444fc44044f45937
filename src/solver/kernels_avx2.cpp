// Kernels of 4 lanes.
#define FLOES_LANES 4
#define FLOES_KERNELS kernels_avx2
#include "solver/kernels.inl"
