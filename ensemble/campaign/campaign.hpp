#pragma once
// A campaign: cases times arrangements. Each pair is a member; its result is a pure function of (campaign, number).

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/design.hpp"
#include "campaign/run_rules.hpp"
#include "campaign/stop_rule.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// One (E, Σ) pair, or any other set of scenario overrides, already applied.
struct Case {
    std::string name;
    Scenario scenario;
    /// The case states an elastic modulus and no Σ: joint.cfm has no meaning until a Σ is found that shows the modulus.
    bool calibrate = false;
    std::string base = {};  ///< the [[case]] that a point of the design was added to; empty where there is none
    int point = -1;         ///< of the campaign's design; -1 without a design
};

struct Campaign {
    std::string name;         ///< the config file's stem
    std::uint64_t seed = 1;   ///< of all randomness
    int arrangements = 1;     ///< per case; the most where a stop rule may end the campaign sooner
    std::vector<Case> cases;  ///< at least one, names unique
    StopRule stop = {};       ///< when fewer arrangements are enough
    RunRules run = {};
    Design design = {};  ///< how the cases came about; each of them has its values already
    /// Cases of one field geometry begin from the same floes (common random numbers); otherwise each case draws its
    /// own.
    bool common_arrangements = true;
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

/// Seed of the random streams that the case's arrangements are drawn from: the campaign's where arrangements are
/// common, otherwise one that the case's name gives.
std::uint64_t arrangement_seed(const Campaign& campaign, int case_index);

/// A number for each case, equal for two cases exactly when each arrangement of one has the same floes as that of the
/// other: common arrangements and the same field geometry. From 0, in order of the first case of each.
std::vector<int> sharing_groups(const Campaign& campaign);

/// The case's value of a key that takes numbers, in the key's unit.
double numeric_value(const Case& one, const std::string& path);

/// Steps x elements of the member: what its run time is expected to be proportional to.
double expected_cost(const Campaign& campaign, int number);

/// Where a campaign is read from.
struct CampaignSource {
    std::string text;                    ///< TOML
    std::string file;                    ///< names the text in messages; its stem is the campaign's name
    std::vector<std::string> overrides;  ///< "key=value" pairs (--set), applied last; of two for one key the later one
    bool from_user = false;              ///< not by write_campaign(): given poses are looked at floe by floe
};

/// Gives the text of the file at `path`; throws InputError when it cannot be read.
using LoadFile = std::string (*)(const std::string& path);

/// Reads and checks a campaign. Throws InputError, one sentence: file, line, key, value, what is allowed, and the
/// nearest known key; for contradictions the keys involved. Overrides "case.NAME.key=value" are for one case; an
/// override of a key that cases set themselves is refused. `load_file` reads the pose files that arrangement.file names
/// (its path is relative to `file`), since nothing below the command line opens files; it may be null where there are
/// none. A design's points become cases: "E60+p003" is the case E60 at point 3. Cases that have a design.point already
/// (as write_campaign() gives them) are those points.
Campaign read_campaign(const CampaignSource& source, LoadFile load_file);

/// The complete resolved configuration as TOML: reading it gives an equal campaign (file poses inline). Keys in which
/// the cases differ stand in each case, all others in the tables; the points of a design are written out; a case to be
/// calibrated has no joint.cfm anywhere.
std::string write_campaign(const Campaign& campaign);

/// 32 hex digits: equal exactly when every member of the two campaigns is the same and they have the same members.
std::string fingerprint(const Campaign& campaign);

/// 32 hex digits of one case's physics (scenario and seed, not its name or the number of arrangements): what a stored
/// member of it is valid for.
std::string case_fingerprint(const Campaign& campaign, int case_index);

/// One line a differing key: "general.iterations: 50 there, 20 here". Empty when equal.
std::vector<std::string> differences(const Campaign& there, const Campaign& here);

}  // namespace floes
