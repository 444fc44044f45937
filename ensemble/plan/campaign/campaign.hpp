#pragma once
// A campaign: cases times arrangements. Each pair is a member; its result is a pure function of (campaign, number).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/design.hpp"
#include "campaign/rules.hpp"
#include "scenario/scenario.hpp"

namespace floes {

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

/// The most members of a campaign: the master keeps some hundred bytes for each.
inline constexpr std::int64_t most_members = 2'000'000;

int member_count(const Campaign& campaign);
/// number in [0, member_count): arrangement * cases + case.
MemberKey member_key(const Campaign& campaign, int number);

/// Seed of the random streams that the case's arrangements are drawn from: the campaign's where arrangements are
/// common, otherwise one that the case's name gives.
std::uint64_t arrangement_seed(const Campaign& campaign, int case_index);

/// Index of run.base_case; none where it is not given.
std::optional<std::size_t> base_case(const Campaign& campaign);

/// A number for each case, equal for two cases exactly when each arrangement of one has the same floes as that of the
/// other: common arrangements and the same field geometry. From 0, in order of the first case of each.
std::vector<int> sharing_groups(const Campaign& campaign);

/// The case's value of a key that takes numbers, in the key's unit.
double numeric_value(const Case& one, const std::string& path);

/// Steps x elements of the member: what its run time is expected to be proportional to.
double expected_cost(const Campaign& campaign, int number);

}  // namespace floes
