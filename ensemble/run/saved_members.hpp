#pragma once
// Members that run for long. The state of each goes to a file beside the journal from time to time, and when the run is
// stopped; from there another run, on any rank, continues the member with the same bits (Simulation::saved). The file
// of a member that is done is of no use any more and goes when the campaign file is published.
//
// A file is taken only by the same program on the same kind of processor, of the same member, and whole; otherwise the
// member begins at its start.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/bytes.hpp"
#include "run/attempt.hpp"
#include "store/session.hpp"
#include "store/system.hpp"

namespace floes {

/// `a.h5` -> `a.CASE-ARRANGEMENT.saved`, in the same folder.
std::filesystem::path saved_path(const std::filesystem::path& campaign_file, const MemberIdentity& member);

/// A member on its way.
struct SavedMember {
    double wall_time = 0;  ///< s that it took so far
    double cpu_time = 0;   ///< likewise
    Bytes state{};         ///< Simulation::saved()
};

/// What must be equal for a state to be set again: this program with its mathematical library, and the member.
std::string saved_stamp(const Campaign& campaign, int number);

/// Puts the file in its place by a rename; on return it is on the disk. Throws RunError or InputError where the file
/// system refuses.
void write_saved(const std::filesystem::path& path, const std::string& stamp, const SavedMember& member,
                 const System& system = this_system());

/// Nothing if there is no file. Throws RunError with the reason, a clause, if it is torn or has another stamp.
std::optional<SavedMember> read_saved(const std::filesystem::path& path, const std::string& stamp,
                                      const System& system = this_system());

/// What becomes of files that a killed process left half written; while members run, one of them may be writing it.
enum class HalfWritten { removed, kept };

/// Removes the files of a campaign's members that are not wanted any more.
void remove_saved(const std::filesystem::path& campaign_file, const std::function<bool(const MemberIdentity&)>& wanted,
                  HalfWritten half_written, const System& system = this_system());

/// How many members of the campaign have a file; those of another one that was written there do not count.
int count_saved(const Campaign& campaign, const std::filesystem::path& campaign_file,
                const System& system = this_system());

/// compute_member(), with members that are saved every `interval` s of wall clock, and when they are put off; 0 s:
/// never. So are none that can_be_saved() says no of.
MemberFunction long_members(std::filesystem::path campaign_file, double interval);

}  // namespace floes
