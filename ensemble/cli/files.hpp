#pragma once
// What kind of file a user has given, so that a wrong one is answered with what to give instead.

#include <filesystem>
#include <string>

namespace floes {

enum class GivenFile { nothing, folder, unreadable, hdf5, journal, text, other };

/// Judged by the first bytes.
GivenFile given_file(const std::filesystem::path& path);

/// Throws InputError, with what to do, unless there is an HDF5 file at `path`, where a verb reads a campaign file. A
/// journal beside a missing campaign file has its results.
void expect_campaign_file(const std::filesystem::path& path);

/// Throws InputError, with what to do, where a campaign file would replace something else.
void expect_no_other_file(const std::filesystem::path& path);

// Writes a page that a browser may be reading at the same time.

/// Writes a temporary file and renames it, so that a reader finds either the old page or the new one. A path that ends
/// with .pdf gets the page as a browser of this machine prints it (FLOES_BROWSER names one). Throws RunError if the
/// file cannot be written, InputError where there is no browser.
void write_page(const std::filesystem::path& path, const std::string& page);

// Commands that people copy into a shell.

/// What people type to start the program: the script that started it, otherwise `program`.
std::string typed_program(const std::string& program);

}  // namespace floes
