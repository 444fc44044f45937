#pragma once
// Libraries that crash over damaged files, tried out in a child process first.

#include <functional>

namespace floes {

/// True if mpirun or srun started this process as one of its ranks. Reads only the environment.
bool started_by_mpi();

/// Does `work` in a child process, whose exceptions and output are lost, and says which signal ended it; 0: none. More
/// than ten seconds of processor time end it too. 0 where there is no child to be had, as under MPI, so that nothing
/// was tried.
int signal_of_trial(const std::function<void()>& work);

}  // namespace floes
