#pragma once
// Version, sources and tools of this build.

#include <string>
#include <vector>

namespace floes {

/// A piece of software and its version, e.g. {"Bullet", "3.24"}.
struct Software {
    std::string name;
    std::string version;
    friend bool operator==(const Software&, const Software&) = default;
};

/// Version of floes, e.g. "1.0.0".
std::string floes_version();

/// Revision of the source tree, with "-dirty" appended if files differed from it; "unknown" outside a git checkout.
std::string git_revision();

/// floes, its revision, compiler, flags, and the libraries.
std::vector<Software> built_with();

}  // namespace floes
