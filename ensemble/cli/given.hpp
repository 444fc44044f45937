#pragma once
// What verbs are given: campaign files and parts of campaigns, so that a wrong file is answered with what to give
// instead; configurations, and the files of other programs, which are opened here alone; and options of several verbs.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "cli/command_line.hpp"
#include "findings/moored.hpp"

namespace floes {

class Parts;

enum class GivenFile { nothing, folder, unreadable, hdf5, journal, text, other };

/// The beginning of a file; nothing of one that cannot be read.
std::string first_bytes(const std::filesystem::path& path, std::size_t most = 512);

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
    std::filesystem::path folder_;  ///< of the merged parts; empty: none
};

/// Throws InputError, with what to do, where a campaign file would replace something else.
void expect_no_other_file(const std::filesystem::path& path);

/// Tells on standard error what of the parts is told apart, and what is missing.
void tell_parts(const Parts& parts);

// Configurations.

/// The whole of a file, of at most 64 MiB. Throws InputError when it cannot be read.
std::string read_bytes(const std::string& path);

/// The text of a file. Throws InputError when it cannot be read or has other things in it.
std::string read_text(const std::string& path);

/// Where a configuration lies: `name` itself, or, if there is no such file and `name` is a word such as "smoke", the
/// installed configuration of that name, if there is one.
std::string find_config(const std::string& name);

/// Reads and checks the campaign of the configuration find_config(`name`), with "key=value" overrides (--set). Throws
/// InputError.
Campaign load_campaign(const std::string& name, const std::vector<std::string>& overrides);

// Options that several verbs have.

/// The option --set of a verb that reads a configuration: key=value, repeatable, into `overrides`.
Option add_overrides(OptionList& verb, std::vector<std::string>& overrides);

/// The option --format of a verb whose answer is a table: "table", "json" or "csv", as written() takes it.
void add_format(OptionList& verb, std::string& format);

/// The option --window of a verb that measures loads: "given" or "auto".
void add_window(OptionList& verb, std::string& window);

/// The options of a verb that extrapolates to an exposure: its length, h, and the probabilities of not being exceeded.
Option add_exposure(OptionList& verb, double& hours);
Option add_quantiles(OptionList& verb, std::vector<double>& quantiles);
/// And the time, s, that its loads are averaged over.
Option add_averaging(OptionList& verb, double& seconds);

/// The options of a moored hull, of verbs that measure loads.
struct MooringOptions {
    std::optional<double> stiffness_kn_m;
    std::optional<double> mass_t;
    std::optional<double> damping_percent;

    /// The hull at full scale; none where it is not asked for. Throws InputError as check_hull() does.
    std::optional<Oscillator> hull() const;

    /// As they were given, each after a space.
    std::string text() const;
};

/// Adds them, each of which needs the others; returns the first.
Option add_mooring(OptionList& verb, MooringOptions& options);

}  // namespace floes
