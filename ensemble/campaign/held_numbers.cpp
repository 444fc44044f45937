#include "campaign/held_numbers.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace floes {
namespace {

constexpr std::size_t most_numbers = 30'000'000;     // 240 MB
constexpr std::size_t most_written_poses = 500'000;  // 75 bytes each, of the longest text that is read again

std::uint64_t digest_of(const std::vector<PlanarPose>& poses) {
    return digest64({reinterpret_cast<const char*>(poses.data()), poses.size() * sizeof(PlanarPose)});
}

}  // namespace

void HeldNumbers::add(const Scenario& scenario) {
    const std::vector<PlanarPose>& poses = scenario.arrangement.poses;
    numbers_ += 3 * poses.size() + 2 * scenario.structure.shape.rows().size() +
                scenario.analysis.exceedance_levels.size() + scenario.analysis.averaging.size();
    if (numbers_ > most_numbers)
        throw InputError(
            fmt::format("{}: poses, profiles, levels and times of all cases are more than {} numbers, which cannot be "
                        "held; take fewer cases or shorter lists",
                        file_, most_numbers));
    const std::uint64_t digest = digest_of(poses);
    if (cases_++ == 0) first_poses_ = digest;
    differ_ = differ_ || digest != first_poses_;
    poses_ += poses.size();
    if ((differ_ ? poses_ : poses.size()) > most_written_poses)
        throw InputError(
            fmt::format("{}: the cases have more than {} poses of their own, which the campaign keeps as text; take "
                        "fewer floes or fewer cases with poses",
                        file_, most_written_poses));
}

}  // namespace floes
