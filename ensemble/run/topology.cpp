#include "run/topology.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>

#include <fmt/format.h>

#include "core/text.hpp"

namespace floes {

namespace {

int cores_on_line() {
    return std::max(1, static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)));
}

}  // namespace

int count_cores(const CoreMask& mask) {
    int count = 0;
    for (const std::uint64_t word : mask) count += std::popcount(word);
    return count;
}

CoreMask affinity_of_this_process() {
    CoreMask mask{};
    cpu_set_t set;
    CPU_ZERO(&set);
    if (::sched_getaffinity(0, sizeof set, &set) == 0) {
        static_assert(sizeof set == sizeof mask);
        std::memcpy(mask.data(), &set, sizeof mask);
        return mask;
    }
    const int cores = std::min<int>(cores_on_line(), 64 * static_cast<int>(mask.size()));
    for (int core = 0; core < cores; ++core)
        mask[static_cast<std::size_t>(core / 64)] |= std::uint64_t{1} << (core % 64);
    return mask;
}

int share_of_cores(std::span<const CoreMask> masks, std::size_t mine) {
    const int cores = count_cores(masks[mine]);
    const auto before = masks.first(mine);
    const int sharers = static_cast<int>(std::count(masks.begin(), masks.end(), masks[mine]));
    const int place = static_cast<int>(std::count(before.begin(), before.end(), masks[mine]));
    return std::max(1, cores / sharers + (place < cores % sharers ? 1 : 0));
}

Topology make_topology(std::span<const CoreMask> masks, std::size_t mine) {
    const int bound = count_cores(masks[mine]);
    CoreMask together{};
    for (const CoreMask& mask : masks) std::ranges::transform(together, mask, together.begin(), std::bit_or{});
    return {share_of_cores(masks, mine), bound, std::max(bound, cores_on_line()), static_cast<int>(masks.size()),
            count_cores(together)};
}

std::string binding_remark(const Topology& topology) {
    if (topology.node_ranks > topology.rank_cores)
        return fmt::format(
            "{} ranks on this node have {} between them, and each computes a member at a time; start no more ranks "
            "than "
            "cores, or, if mpirun bound them, --bind-to none lets them use all",
            topology.node_ranks, counted(topology.rank_cores, "core"));
    if (topology.node_ranks > 1 || topology.bound_cores >= topology.node_cores) return {};
    return fmt::format(
        "the only rank on this node is bound to {} of its {} cores; mpirun --bind-to none lets it use all",
        topology.bound_cores, topology.node_cores);
}

}  // namespace floes
