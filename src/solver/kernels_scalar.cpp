// Kernels of 1 lane.
#define FLOES_LANES 1
#define FLOES_KERNELS kernels_scalar
#include "solver/kernels.inl"
