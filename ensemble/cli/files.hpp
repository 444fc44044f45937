#pragma once
// What kind of file a user has given, so that a wrong one is answered with what to give instead.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floes {

class Parts;

enum class GivenFile { nothing, folder, unreadable, hdf5, journal, text, other };

/// Judged by the first bytes.
GivenFile given_file(const std::filesystem::path& path);

/// Throws InputError, with what to do, unless there is an HDF5 file at `path`, where a verb reads a campaign file. A
/// journal beside a missing campaign file has its results.
void expect_campaign_file(const std::filesystem::path& path);

/// What a verb reads that was given one campaign file, or several parts of a campaign. Parts are merged into a file
/// that is kept as long as this, and what is told apart or missing is told on standard error.
class GivenCampaign {
  public:
    /// Throws InputError, as expect_campaign_file() of one and as Parts of several.
    explicit GivenCampaign(const std::vector<std::string>& files);
    ~GivenCampaign();
    GivenCampaign(const GivenCampaign&) = delete;
    GivenCampaign& operator=(const GivenCampaign&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// As it was given, for commands that people copy.
    const std::string& words() const { return words_; }

  private:
    std::filesystem::path path_;
    std::string words_;
    bool merged_ = false;
};

/// Throws InputError, with what to do, where a campaign file would replace something else.
void expect_no_other_file(const std::filesystem::path& path);

/// Tells on standard error what of the parts is told apart, and what is missing.
void tell_parts(const Parts& parts);

/// A file of ensemble/cli/starters or arrays by its name, as it was when the program was built.
std::optional<std::string_view> starter(std::string_view name);

/// Makes a file of that text; one that exists is never touched. Throws InputError.
void write_new(const std::filesystem::path& path, const std::string& text);

/// Throws InputError, with what to do, unless a file can be written at `path`: its folder is there and permits it. For
/// verbs that work for long before they write.
void expect_place(const std::filesystem::path& path);

// Writes a page that a browser may be reading at the same time.

/// Writes a temporary file and renames it, so that a reader finds either the old page or the new one. A path that ends
/// with .pdf gets the page as a browser of this machine prints it (FLOES_BROWSER names one). Throws RunError if the
/// file cannot be written, InputError where there is no browser.
void write_page(const std::filesystem::path& path, const std::string& page);

// Commands that people copy into a shell.

/// What people type to start the program: the script that started it, otherwise `program`.
std::string typed_program(const std::string& program);

}  // namespace floes
