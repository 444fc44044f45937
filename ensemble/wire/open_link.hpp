#pragma once
// The link that fits how this process was started.

#include <memory>

#include "wire/link.hpp"

namespace floes {

/// True when mpirun or srun started this process as one of its ranks. Looks at the environment only.
bool started_by_mpi();

/// MPI under mpirun or srun, else local without touching MPI.
std::unique_ptr<Link> open_link();

}  // namespace floes
