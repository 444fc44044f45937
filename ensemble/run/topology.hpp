#pragma once
// The cores of a rank, from its affinity mask and those of the other ranks on its node.

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace floes {

/// The cores that a process may run on, one bit each, in the system's numbering.
using CoreMask = std::array<std::uint64_t, 16>;

int count_cores(const CoreMask& mask);

/// The mask of the calling process; all online cores if the system has more cores than fit.
CoreMask affinity_of_this_process();

/// Cores of the rank masks[mine]: those in its mask, divided evenly among the ranks of the node with the same mask (the
/// first ones get the remainder), at least 1.
int share_of_cores(std::span<const CoreMask> masks, std::size_t mine);

/// Cores and neighbours of a rank.
struct Topology {
    int cores = 1;        ///< to be used by this rank
    int bound_cores = 1;  ///< in its affinity mask
    int node_cores = 1;   ///< online on its node
    int node_ranks = 1;   ///< ranks on its node
    int rank_cores = 1;   ///< in the masks of these ranks together
};

/// `masks`: those of all ranks on the node; masks[mine] is this rank's.
Topology make_topology(std::span<const CoreMask> masks, std::size_t mine);

/// A sentence for the user if the only rank of a node is bound to some of its cores, or if more ranks than cores share
/// them; otherwise empty.
std::string binding_remark(const Topology& topology);

}  // namespace floes
