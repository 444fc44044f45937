#include "solver/lane_width.hpp"

#include <fmt/ranges.h>

#include "core/error.hpp"

namespace floes {

extern const LaneKernels kernels_scalar;
#if defined(__x86_64__)
extern const LaneKernels kernels_sse2;
extern const LaneKernels kernels_avx2;
extern const LaneKernels kernels_avx512;
#endif

std::vector<int> lane_widths() {
    std::vector<int> widths{1};
#if defined(__x86_64__)
    widths.push_back(2);
    if (__builtin_cpu_supports("avx2")) widths.push_back(4);
    if (__builtin_cpu_supports("avx512f")) widths.push_back(8);
#endif
    return widths;
}

const LaneKernels& lane_kernels(int width) {
    for (const int available : lane_widths()) {
        if (available != width) continue;
#if defined(__x86_64__)
        if (width == 2) return kernels_sse2;
        if (width == 4) return kernels_avx2;
        if (width == 8) return kernels_avx512;
#endif
        return kernels_scalar;
    }
    throw RunError(fmt::format("{} lanes are not available on this processor; take one of {}.", width,
                               fmt::join(lane_widths(), ", ")));
}

}  // namespace floes
