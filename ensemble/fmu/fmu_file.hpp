#pragma once
// An FMU as a file: a zip archive of its description, its library, what the library reads, and documentation.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmu/description.hpp"

namespace floes {

/// What an FMU's library finds in `resources`: the configuration, resolved, and lines: who moves the hull, which
/// token is expected, which case and arrangement it starts with.
inline constexpr std::string_view fmu_configuration = "configuration.toml";
inline constexpr std::string_view fmu_start = "fmu.txt";

/// A file by its path in the archive, and its bytes.
using ArchivedFile = std::pair<std::string, std::string>;

/// A zip archive of version 2.0, every file deflated; the same bytes for the same files. Throws RunError where a file
/// is too large for one.
std::string zip_archive(const std::vector<ArchivedFile>& files);

struct FmuParts {
    FmuDescription description;
    std::string configuration;            ///< text
    std::string library;                  ///< bytes of the shared library
    std::vector<ArchivedFile> libraries;  ///< that it needs beside it: name and bytes
    std::vector<ArchivedFile> licences;   ///< name and text
};

/// The archive. The description's token is made here of all that the FMU computes with.
std::string fmu_file(FmuParts parts, FmiVersion version);

}  // namespace floes
