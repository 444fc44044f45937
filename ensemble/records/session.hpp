#pragma once
// One start of the program on a campaign: where, with what, from when to when. Provenance only.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bytes.hpp"
#include "records/build_info.hpp"

namespace floes {

struct Session {
    std::string started;  ///< UTC, ISO 8601
    std::string ended;    ///< UTC, ISO 8601; empty: at work or killed
    std::string outcome;  ///< "complete", "stopped", …; empty: at work or killed
    std::string host;     ///< of rank 0
    std::string machine;  ///< system, release, processor of rank 0
    std::string job;      ///< batch job id; empty outside a batch system
    int ranks = 1;
    int threads = 1;    ///< over all ranks
    int reused = 0;     ///< members that had their result, or stood aside, when it began
    int retried = 0;    ///< members that it tried again, since they had failed or were lost with their process
    int computed = 0;   ///< members that it finished; counted by the journal
    int set_aside = 0;  ///< members that it gave up; counted by the journal
    std::vector<Software> software;
    friend bool operator==(const Session&, const Session&) = default;
};

/// This process, now. `others`: software that only the caller knows the version of (MPI).
Session describe_session(int ranks, int threads, std::span<const Software> others);

/// Of the computer that this process is on.
std::string host_name();

/// The present moment, UTC, ISO 8601 to the second.
std::string utc_now();

/// The version named `name`; empty when there is none.
std::string version_of(const Session& session, std::string_view name);

/// What differs between two sessions of all that may change the last bits of a member: revision, compiler, flags,
/// Bullet, and the C library with the path its sin and cos take. "git_revision: 1a2b3c before, 4d5e6f now", one a line.
std::vector<std::string> changed_software(const Session& before, const Session& now);

Bytes encode(const Session& session);

/// Throws RunError when the bytes are not exactly one session.
Session decode_session(std::span<const std::byte> bytes);

}  // namespace floes
