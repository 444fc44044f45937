#include "cli/given.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "campaign_file/kinds.hpp"
#include "campaign_file/publish.hpp"
#include "cli/answer.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "hdf5/read.hpp"
#include "run/parts.hpp"
#include "store/journal.hpp"

namespace floes {

namespace {

namespace fs = std::filesystem;

/// A campaign file that is not there.
std::string missing(const fs::path& path) {
    const fs::path journal = journal_path(path);
    if (given_file(journal) != GivenFile::journal) return fmt::format("there is no file {}.", path.string());
    const std::string so_far = fs::path(path).replace_extension("").string() + "_so_far.h5";
    return fmt::format(
        "there is no file {} yet, but its journal {} has the members that are done: floes run CONFIG.toml -o {} "
        "--resume computes the rest and writes the file; floes merge {} -o {} writes one of what is done.",
        path.string(), journal.string(), shell_word(path.string()), shell_word(path.string()), shell_word(so_far));
}

std::string what_it_is(const fs::path& path, GivenFile kind) {
    const std::string name = path.string();
    const std::string campaign_file = fs::path(path).replace_extension(".h5").string();
    switch (kind) {
        case GivenFile::nothing:
            return missing(path);
        case GivenFile::folder:
            return fmt::format("{} is a folder; give a campaign file in it, the .h5 that floes run wrote.", name);
        case GivenFile::unreadable:
            return fmt::format("{} may not be read by you; its owner has to permit it (chmod).", name);
        case GivenFile::journal:
            return fmt::format("{} is the journal of a campaign; give its campaign file, {}.", name, campaign_file);
        case GivenFile::text:
            if (path.extension() == ".toml")
                return fmt::format("{} is a configuration, not a campaign file; floes run {} -o {} makes {}.", name,
                                   shell_word(name), shell_word(campaign_file), campaign_file);
            return fmt::format("{} is a text, not a campaign file; give the .h5 that floes run wrote.", name);
        case GivenFile::hdf5:
        case GivenFile::other:
            break;
    }
    return fmt::format("{} is no campaign file; give the .h5 that floes run wrote.", name);
}

}  // namespace

std::string first_bytes(const fs::path& path, std::size_t most) {
    std::ifstream in(path, std::ios::binary);
    std::string bytes(most, '\0');
    in.read(bytes.data(), std::ssize(bytes));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

GivenFile given_file(const fs::path& path) {
    constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
    std::error_code unknown;
    if (fs::is_directory(path, unknown)) return GivenFile::folder;
    if (!fs::exists(path, unknown)) return GivenFile::nothing;
    if (::access(path.c_str(), R_OK) != 0) return GivenFile::unreadable;
    const std::string bytes = first_bytes(path);
    if (bytes.starts_with(hdf5_signature)) return GivenFile::hdf5;
    if (bytes.starts_with(journal_format::magic)) return GivenFile::journal;
    const bool control =
        std::ranges::any_of(bytes, [](unsigned char c) { return c < 32 && c != '\n' && c != '\t' && c != '\r'; });
    return control || bytes.empty() ? GivenFile::other : GivenFile::text;
}

void expect_campaign_file(const fs::path& path) {
    const GivenFile kind = given_file(path);
    if (kind != GivenFile::hdf5) throw InputError(what_it_is(path, kind));
}

GivenCampaign::GivenCampaign(const std::vector<std::string>& files) : path_(files.front()) {
    for (const std::string& file : files) words_ += (words_.empty() ? "" : " ") + shell_word(file);
    if (files.size() == 1) {
        expect_campaign_file(path_);
        return;
    }
    const Parts parts(std::vector<fs::path>(files.begin(), files.end()));
    tell_parts(parts);
    std::string folder = (fs::temp_directory_path() / "floes-parts-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr)
        throw RunError(fmt::format("no folder can be made in {} to merge the parts in ({}); TMPDIR names another.",
                                   fs::temp_directory_path().string(), std::strerror(errno)));
    folder_ = folder;
    path_ = folder_ / (in_a_file_name(parts.campaign().name) + ".h5");
    try {
        publish(path_, parts.campaign(), parts.members(), parts.sessions(), parts.calibrations());
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
        throw;
    }
}

GivenCampaign::~GivenCampaign() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

void tell_parts(const Parts& parts) {
    std::vector<std::string> sentences = parts.remarks();
    sentences.push_back(parts.missing_parts());
    sentences.push_back(parts.missing_members());
    for (const std::string& sentence : sentences)
        if (!sentence.empty()) note("{}", sentence);
}

namespace {

/// Nothing known of a file that is not there or cannot be read.
std::optional<bool> is_campaign_file(const fs::path& path) {
    const hdf5::QuietErrors quiet;
    try {
        return hdf5::is_of_kind(hdf5::open_for_reading(path).id(), campaign_kind);
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace

void expect_no_other_file(const fs::path& path) {
    const GivenFile kind = given_file(path);
    std::error_code unknown;
    const bool empty_file = fs::is_regular_file(path, unknown) && fs::is_empty(path, unknown);
    if (empty_file && !fs::exists(journal_path(path), unknown))
        throw InputError(
            fmt::format("{} is an empty file, not a campaign that could be continued; delete it, or -o "
                        "names another file for the campaign.",
                        path.string()));
    for (const char* ending : {".h5", ".hdf5", ".nc"})
        if (const fs::path twin = fs::path(path).replace_extension(ending);
            twin != path && is_campaign_file(twin).value_or(false))
            throw InputError(
                fmt::format("{} would share its journal and pieces with {}, a campaign file that is there: -o needs "
                            "another name, not "
                            "only another ending.",
                            path.string(), twin.string()));
    const bool campaign_or_damaged = kind == GivenFile::hdf5 && is_campaign_file(path).value_or(true);
    if (kind == GivenFile::nothing || campaign_or_damaged || empty_file) return;
    fs::path other = fs::path(path).replace_extension(".h5");
    if (other == path) other.replace_filename(path.stem().string() + "_campaign.h5");
    throw InputError(fmt::format("{} is {} and stays as it is; -o names another file for the campaign, as {}.",
                                 path.string(),
                                 kind == GivenFile::folder    ? "a folder"
                                 : kind == GivenFile::journal ? "a journal"
                                                              : "no campaign file",
                                 other.string()));
}

std::string read_bytes(const std::string& path) {
    if (std::filesystem::is_directory(path)) {
        throw InputError(fmt::format("{}: this is a folder; name a file in it", path));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(fmt::format("{}: this file cannot be read ({})", path, std::strerror(errno)));
    std::string text;
    for (std::vector<char> some(1 << 16); file; text.append(some.data(), static_cast<std::size_t>(file.gcount()))) {
        if (text.size() > longest_configuration)
            throw InputError(fmt::format("{}: this file is longer than {} bytes, the most that are read", path,
                                         longest_configuration));
        file.read(some.data(), std::ssize(some));
    }
    return text;
}

std::string read_text(const std::string& path) {
    if (const GivenFile kind = given_file(path); kind == GivenFile::hdf5 || kind == GivenFile::journal)
        throw InputError(fmt::format("{}: this is {}, not a configuration; give the CONFIG.toml", path,
                                     kind == GivenFile::hdf5 ? "an HDF5 file" : "the journal of a campaign"));
    return read_bytes(path);
}

std::string find_config(const std::string& name) {
    const bool word = !name.empty() && name.find_first_of("/.") == std::string::npos;
    if (!word || std::filesystem::exists(name)) return name;
    std::error_code unknown;
    std::vector<std::filesystem::path> folders;
    if (const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown); !unknown)
        folders.push_back((program.parent_path() / FLOES_SHARE_FROM_PROGRAM).lexically_normal());
    if (const char* launcher = std::getenv("FLOES_LAUNCHER"))  // of a clone
        folders.push_back(std::filesystem::weakly_canonical(launcher, unknown).parent_path());
    for (const std::filesystem::path& folder : folders)
        if (const auto known = folder / "configs" / (name + ".toml"); std::filesystem::exists(known, unknown))
            return known.string();
    return name;
}

namespace {

/// Whether a configuration has nothing but blanks and comments.
bool states_nothing(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::size_t first = text.find_first_not_of(" \t\r");
        if (first < end && text[first] != '#') return false;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return true;
}

}  // namespace

Campaign load_campaign(const std::string& name, const std::vector<std::string>& overrides) {
    const std::string path = find_config(name);
    const std::string text = read_text(path);
    Campaign campaign = read_campaign({text, path, overrides, true}, read_text);
    if (states_nothing(text))
        note("{} states no key, so everything {}has its default; floes config --defaults prints them", path,
             overrides.empty() ? "" : "but --set ");
    return campaign;
}

Option add_overrides(OptionList& verb, std::vector<std::string>& overrides) {
    // One value for each --set: the next word is an argument of the verb.
    return verb.option("--set", overrides, "key=value: override a key of the file; may be repeated").one_each();
}

void add_format(OptionList& verb, std::string& format) {
    verb.option("--format", format, "table, json or csv").one_of({"table", "json", "csv"}).shows_default();
}

void add_window(OptionList& verb, std::string& window) {
    verb.option("--window", window,
                "Analysis window: given (as configured), or auto (the surge load and how a moored structure gives way "
                "from the start of the steady state, found in the histories)")
        .one_of({"given", "auto"})
        .shows_default();
}

Option add_exposure(OptionList& verb, double& hours) {
    return verb.option("--exposure-h", hours, "Exposure, h at full scale").within(1e-3, 1e6).shows_default();
}

Option add_quantiles(OptionList& verb, std::vector<double>& quantiles) {
    return verb
        .option("--quantile", quantiles, "Probabilities that the load is not exceeded in the exposure, comma-separated")
        .comma_separated()
        .within(0.001, 0.99999)
        .shows_default();
}

Option add_averaging(OptionList& verb, double& seconds) {
    return verb
        .option("--averaging-s", seconds,
                "Time that the load is averaged over, s at full scale: one of the campaign's analysis.averaging_s")
        .positive()
        .shows_default();
}

std::optional<Oscillator> MooringOptions::hull() const {
    if (!stiffness_kn_m) return std::nullopt;
    constexpr double thousand = 1e3;
    const Oscillator hull{thousand * stiffness_kn_m.value(), thousand * mass_t.value(),
                          unit::percent * damping_percent.value()};
    check_hull(hull);
    return hull;
}

std::string MooringOptions::text() const {
    if (!stiffness_kn_m) return "";
    return fmt::format(" --mooring-kN-m {:g} --mass-t {:g} --damping-percent {:g}", *stiffness_kn_m, mass_t.value(),
                       damping_percent.value());
}

Option add_mooring(OptionList& verb, MooringOptions& options) {
    Option stiffness = verb.option(
        "--mooring-kN-m", options.stiffness_kn_m,
        "A hull on moorings of this stiffness, kN/m at full scale, moved by the stored loads of the fixed hull");
    Option mass = verb.option("--mass-t", options.mass_t,
                              "Its mass, t at full scale: that of the hull and the added mass of the water, which for "
                              "surge is some half of it more");
    Option damping =
        verb.option("--damping-percent", options.damping_percent,
                    "Its damping by water and mooring lines, percent of the critical; take it from a decay test");
    // A ring, since help would list several needs in an order of their addresses.
    stiffness.needs(damping);
    damping.needs(mass);
    mass.needs(stiffness);
    return stiffness;
}

}  // namespace floes
