// Kernels of 2 lanes.
#define FLOES_LANES 2
#define FLOES_KERNELS kernels_sse2
#include "solver/kernels.inl"
