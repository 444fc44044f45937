#include "store/build_info.hpp"

#include <H5public.h>

#include <fmt/format.h>

#include "store/build_facts.hpp"
#include "store/git_revision.hpp"

namespace floes {
namespace {

std::string hdf5_version() {
    unsigned major = 0;
    unsigned minor = 0;
    unsigned release = 0;
    if (H5get_libversion(&major, &minor, &release) < 0) return "unknown";
    return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace

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
            {"hdf5", hdf5_version()},         {"tbb", FLOES_TBB_VERSION},
            {"boost", FLOES_BOOST_VERSION}};
}

}  // namespace floes
