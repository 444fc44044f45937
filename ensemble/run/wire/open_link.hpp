#pragma once
// The link that matches how this process was started.

#include <memory>

#include "wire/link.hpp"

namespace floes {

/// True if mpirun or srun started this process as one of its ranks. Reads only the environment.
bool started_by_mpi();

/// MPI under mpirun or srun, otherwise local without starting MPI. `longest_start`, s: MpiLink.
std::unique_ptr<Link> open_link(unsigned longest_start = 600);

}  // namespace floes
