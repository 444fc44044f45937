#pragma once
// Which cores are whose: the threads of a rank from its own affinity mask and those of the other ranks of its node.

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace floes {

/// The cores that a process may run on, one bit each, as the system numbers them.
using CoreMask = std::array<std::uint64_t, 16>;

int count_cores(const CoreMask& mask);

/// The mask of the calling process: every core that is on line when the system has more cores than fit.
CoreMask affinity_of_this_process();

/// Cores of the rank masks[mine]: those in its mask, divided evenly among the ranks of the node with that same mask
/// (the first ones get what is left over), at least 1.
int share_of_cores(std::span<const CoreMask> masks, std::size_t mine);

/// Where a rank stands.
struct Topology {
    int cores = 1;        ///< that this rank is to use
    int bound_cores = 1;  ///< in its affinity mask
    int node_cores = 1;   ///< on line on its node
    int node_ranks = 1;   ///< ranks on its node
};

/// `masks`: of all ranks of the node, this rank's at [mine].
Topology make_topology(std::span<const CoreMask> masks, std::size_t mine);

/// A sentence for the user when a rank that has its node to itself is bound to a part of it; else empty.
std::string binding_remark(const Topology& topology);

}  // namespace floes
