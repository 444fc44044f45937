#include "cli/config_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "campaign/name_list.hpp"
#include "campaign/read.hpp"
#include "cli/given_file.hpp"
#include "core/error.hpp"

namespace floes {

std::string read_text(const std::string& path) {
    if (std::filesystem::is_directory(path)) {
        throw InputError(fmt::format("{}: this is a folder; name a file in it", path));
    }
    if (const GivenFile kind = given_file(path); kind == GivenFile::hdf5 || kind == GivenFile::journal)
        throw InputError(fmt::format("{}: this is {}, not a configuration; give the CONFIG.toml", path,
                                     kind == GivenFile::hdf5 ? "an HDF5 file" : "the journal of a campaign"));
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

std::string find_config(const std::string& name) {
    const bool word = !name.empty() && name.find_first_of("/.") == std::string::npos;
    if (!word || std::filesystem::exists(name)) return name;
    std::error_code unknown;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    if (unknown) return name;
    const std::filesystem::path installed =
        (program.parent_path() / FLOES_SHARE_FROM_PROGRAM / "configs" / (name + ".toml")).lexically_normal();
    return std::filesystem::exists(installed) ? installed.string() : name;
}

Campaign load_campaign(const std::string& name, const std::vector<std::string>& overrides) {
    const std::string path = find_config(name);
    return read_campaign({read_text(path), path, overrides, true}, read_text);
}

const Case& chosen_case(const Campaign& campaign, const std::string& name) {
    if (campaign.cases.size() == 1 && name.empty()) return campaign.cases.front();
    const auto found = std::ranges::find(campaign.cases, name, &Case::name);
    if (found != campaign.cases.end()) return *found;
    std::vector<std::string> names;
    for (const Case& one : campaign.cases) names.push_back(one.name);
    throw InputError(
        name.empty()
            ? fmt::format("one case is taken, and this campaign has several; name it with --case: {}", name_list(names))
            : fmt::format("there is no case {}; the cases are {}", name, name_list(names)));
}

}  // namespace floes
