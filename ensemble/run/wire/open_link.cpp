#include "wire/open_link.hpp"

#include <cstdlib>

#include "wire/local_link.hpp"
#include "wire/mpi_link.hpp"

namespace floes {

bool started_by_mpi() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"}) {
        if (std::getenv(name) != nullptr) return true;
    }
    return false;
}

std::unique_ptr<Link> open_link(unsigned longest_start) {
    if (started_by_mpi()) return std::make_unique<MpiLink>(longest_start);
    return std::make_unique<LocalLink>();
}

}  // namespace floes
