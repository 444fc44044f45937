#pragma once
// One history of a campaign on a simulated machine (support/simulated_system.hpp), told by its seed: sessions that are
// killed, cut off from power, stopped, given a full or a failing disk, whose other ranks die, sleep, come late or
// answer twice, whose clock is set, into whose file a second run is started, and which others read meanwhile; then one
// that is left alone. Half of the histories keep the journal of a campaign that is whole in its file, and a fourth
// go on with an arrangement more. The driver of rank 0 is the real one, run_campaign() with all that it uses, and so is
// the Writer of other ranks; what else these do is played, and the campaign file's content is a text, since HDF5 writes
// to a real disk only.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "support/simulated_system.hpp"

namespace floes::simulated {

/// A campaign, and what is known of it beforehand.
struct Subject {
    Campaign campaign;
    std::string fingerprint;
    std::vector<std::string> case_keys;
    std::string content;                   ///< of the file of an undisturbed run
    int set_aside = 0;                     ///< members that always fail
    std::shared_ptr<const Subject> grown;  ///< with an arrangement more; none of one that has grown
};

std::vector<Subject> make_subjects();

/// What did not hold, a sentence; empty: nothing is lost that was told, nobody read half a file, no member counts
/// twice, and the last session gave the file of an undisturbed run. `account`, if given: what happened.
std::string history(const std::vector<Subject>& subjects, std::uint64_t seed, const Mutant& mutant,
                    std::string* account = nullptr);

}  // namespace floes::simulated
