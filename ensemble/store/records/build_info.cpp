#include "records/build_info.hpp"

#include "records/build_facts.hpp"
#include "records/git_revision.hpp"

namespace floes {

std::string floes_version() {
    return FLOES_VERSION;
}

std::string git_revision() {
    return FLOES_GIT_REVISION;
}

std::vector<Software> built_with() {
    return {{"floes", floes_version()},       {"git_revision", git_revision()},
            {"compiler", FLOES_COMPILER},     {"compiler_flags", FLOES_COMPILER_FLAGS},
            {"bullet", FLOES_BULLET_VERSION}, {"eigen", FLOES_EIGEN_VERSION},
            {"hdf5", FLOES_HDF5_VERSION},     {"tbb", FLOES_TBB_VERSION},
            {"boost", FLOES_BOOST_VERSION}};
}

}  // namespace floes
