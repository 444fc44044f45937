#pragma once
// What kind of file a user has given, so that a wrong one is answered with what to give instead.

#include <filesystem>

namespace floes {

enum class GivenFile { nothing, folder, hdf5, journal, text, other };

/// Judged by the first bytes.
GivenFile given_file(const std::filesystem::path& path);

/// Throws InputError, with what to do, unless there is an HDF5 file at `path`, where a verb reads a campaign file. A
/// journal beside a missing campaign file has its results.
void expect_campaign_file(const std::filesystem::path& path);

}  // namespace floes
