#pragma once
// A campaign: cases times arrangements, how it is run, when it has enough arrangements, and what tells it from others.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/design.hpp"
#include "core/units.hpp"
#include "keys/key.hpp"
#include "scenario/layout.hpp"
#include "scenario/scenario.hpp"

namespace floes {

struct DesignOf;

/// What StopRule::of begins with for the largest value in an exposure, which is no quantity of a member: a word of
/// design_ofs (member/design_of.hpp) follows.
inline constexpr std::string_view design_prefix = "design_";

struct StopRule {
    double half_width = 0;             ///< of the 95 % interval, relative to the mean; 0: all arrangements are run
    std::string of = "mean_load";      ///< key of the quantity that has to be precise
    std::string case_name = "all";     ///< or "none", or the name of one case
    std::string contrast = "none";     ///< or "all", or "B - A" for the paired difference of two cases
    int minimum = 0;                   ///< arrangements before the rule is applied; 0: by half_width, at least 20
    int look_ahead = 5;                ///< further arrangements for which it must stay satisfied
    int batch = 10;                    ///< arrangements handed out before any later one
    double exposure = 3 * unit::hour;  ///< s, of a design value
    double averaging = 1;              ///< s, that the load is averaged over for a design load
    double quantile = 0.9;  ///< probability that a design value is not exceeded in it; 0: the expected largest

    /// What a design value is wanted of; nullptr of a quantity of members.
    const DesignOf* design_of() const;
    bool active() const { return half_width > 0; }
    friend bool operator==(const StopRule&, const StopRule&) = default;
};

/// Where a member is computed: in the process that was given it, or in a process of its own.
enum class Isolation { none, process };

struct RunRules {
    Isolation isolation = Isolation::none;
    double member_deadline = 6 * 3600;            ///< s of wall clock for one attempt; 0: none
    double member_memory = 2048.0 * 1024 * 1024;  ///< bytes, for a member in a process of its own; 0: no limit
    bool nominal_modulus = false;                 ///< E of joints that follow Σ is a name only
    std::string base_case = "";                   ///< whose variations all other cases are; empty: none
    int attempts = 2;                             ///< failed ones after which a member is set aside, >= 1
};

// A campaign: cases times arrangements. Each pair is a member; its result is a pure function of (campaign, number).

/// What is to be done about E and Σ before the first member. Joints that follow Σ show an E that only a plate test
/// tells; beam joints have E alone.
enum class Pairing {
    settled,       ///< nothing
    find_cfm,      ///< E is stated: find the Σ that shows it; joint.cfm has no meaning until then
    find_modulus,  ///< Σ is stated: find the E that it shows; ice.elastic_modulus_MPa has no meaning until then
    check,         ///< both are stated: see whether they agree
};

/// One (E, Σ) pair, or any other set of scenario overrides, already applied.
struct Case {
    std::string name;
    Scenario scenario;
    Pairing pairing = Pairing::settled;
    std::string base = {};    ///< the [[case]] that a point of the design was added to; empty where there is none
    int point = -1;           ///< of the campaign's design; -1 without a design
    LaidReasons laid = {};    ///< values that its text left open, and why they are so; not stored
    bool hull_stated = true;  ///< by its text, or the paper's by what else it says of the paper; not stored
};

/// The fields of [campaign].
struct CampaignHead {
    std::string name;        ///< the config file's stem
    std::uint64_t seed = 1;  ///< of all randomness
    int arrangements = 1;    ///< per case; the most where a stop rule may end the campaign sooner
    /// Cases of one field geometry begin from the same floes (common random numbers); otherwise each case draws its
    /// own.
    bool common_arrangements = true;
};

struct Campaign : CampaignHead {
    std::vector<Case> cases;  ///< at least one, names unique
    StopRule stop = {};       ///< when fewer arrangements are enough
    RunRules run = {};
    Design design = {};  ///< how the cases came about; each of them has its values already
};

/// Which simulation a member is: arrangement-major, so that more arrangements only add members at the end.
struct MemberKey {
    int case_index = 0;
    int arrangement = 0;
    friend bool operator==(const MemberKey&, const MemberKey&) = default;
};

/// The most members of a campaign: the master keeps some hundred bytes for each.
inline constexpr std::int64_t most_members = 20'000'000;

int member_count(const Campaign& campaign);
/// number in [0, member_count): arrangement * cases + case.
MemberKey member_key(const Campaign& campaign, int number);
/// The case of that member.
const Case& case_of(const Campaign& campaign, int number);

/// Seed of the random streams that the case's arrangements are drawn from: the campaign's where arrangements are
/// common, otherwise one that the case's name gives.
std::uint64_t arrangement_seed(const Campaign& campaign, int case_index);

std::vector<std::string> case_names(const Campaign& campaign);

/// The campaign's case of that name, or its only one where none is named. Throws InputError if there is none.
const Case& chosen_case(const Campaign& campaign, const std::string& name);

/// Index of run.base_case; none where it is not given.
std::optional<std::size_t> base_case(const Campaign& campaign);

/// A number for each case, equal for two cases exactly when each arrangement of one has the same floes as that of the
/// other: common arrangements, the same field geometry, and an end or none. From 0, in order of the first case of each.
std::vector<int> sharing_groups(const Campaign& campaign);

/// The case's value of a key that takes numbers, in the key's unit.
double numeric_value(const Case& one, const std::string& path);

/// Steps x elements of the member, in level ice also for its breaks: what its run time is expected to be proportional
/// to.
double expected_cost(const Campaign& campaign, int number);

// Whether the lists of all cases can be held in memory. For this module only.

class HeldNumbers {
  public:
    /// `file` begins the messages.
    explicit HeldNumbers(std::string file) : file_(std::move(file)) {}

    /// Counts the poses, profile points, levels and times of one more case. Throws InputError when those of all cases
    /// are too many.
    void add(const Scenario& scenario);

  private:
    std::string file_;
    std::size_t numbers_ = 0;
};

// The identity of campaigns and cases: digests that are equal exactly when the members are, and what differs otherwise.

/// 32 hex digits: equal exactly when every member of the two campaigns is the same and they have the same members.
std::string fingerprint(const Campaign& campaign);

/// 32 hex digits of one case's physics (scenario and seed, not its name or the number of arrangements): what a stored
/// member of it is valid for.
std::string case_fingerprint(const Campaign& campaign, int case_index);
/// Of each case.
std::vector<std::string> case_fingerprints(const Campaign& campaign);

/// True if every member of `part` is one of `whole`. Names and order of cases do not matter.
bool is_part_of(const Campaign& part, const Campaign& whole);

/// One line a differing key: "general.iterations: 50 there, 20 here". Empty when equal.
std::vector<std::string> differences(const Campaign& there, const Campaign& here);

}  // namespace floes
