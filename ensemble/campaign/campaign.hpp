#pragma once
// A campaign: cases times arrangements. Each pair is a member; its result is a pure function of (campaign, number).

#include <cstdint>
#include <string>
#include <vector>

#include "scenario/scenario.hpp"

namespace floes {

/// One (E, Σ) pair, or any other set of scenario overrides, already applied.
struct Case {
    std::string name;
    Scenario scenario;
};

struct Campaign {
    std::string name;               ///< the config file's stem
    std::uint64_t seed = 1;         ///< of all randomness
    int arrangements = 1;           ///< per case
    std::vector<Case> cases;        ///< at least one, names unique
};

/// Which simulation a member is: arrangement-major, so that more arrangements only add members at the end.
struct MemberKey {
    int case_index = 0;
    int arrangement = 0;
    friend bool operator==(const MemberKey&, const MemberKey&) = default;
};

int member_count(const Campaign& campaign);
/// number in [0, member_count): arrangement * cases + case.
MemberKey member_key(const Campaign& campaign, int number);

/// Steps x elements of the member: what its run time is expected to be proportional to.
double expected_cost(const Campaign& campaign, int number);

/// Reads a campaign from TOML text. `file` names it in messages. Overrides are "key=value" pairs (--set), applied last.
/// Throws InputError with file, line, key, value, what is allowed, and the nearest known key.
/// `poses_text` of "file" arrangements is loaded by the caller through `load_file` (path relative to the config) since
/// nothing below the command line opens files.
struct CampaignSource {
    std::string text;
    std::string file;
    std::vector<std::string> overrides;
};

Campaign read_campaign(const CampaignSource& source, std::string (*load_file)(const std::string& path));

/// The complete resolved configuration as TOML: reading it gives the same campaign (file poses inline).
std::string write_campaign(const Campaign& campaign);

/// 32 hex digits: equal exactly when every member of the two campaigns is the same and they have the same members.
std::string fingerprint(const Campaign& campaign);

/// 32 hex digits of one case's physics (scenario and seed, not its name or the number of arrangements): what a stored
/// member of it is valid for.
std::string case_fingerprint(const Campaign& campaign, int case_index);

/// One line a differing key: "general.iterations: 50 there, 20 here". Empty when equal.
std::vector<std::string> differences(const Campaign& there, const Campaign& here);

}  // namespace floes
