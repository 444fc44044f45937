#pragma once
// One start of the program on a campaign, with version and tools of its build, and attempts that never ended.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/bytes.hpp"
#include "store/system.hpp"

namespace floes {

/// A piece of software and its version, e.g. {"Bullet", "3.24"}.
struct Software {
    std::string name;
    std::string version;
    friend bool operator==(const Software&, const Software&) = default;
};

/// Version of floes, e.g. "1.0.0".
std::string floes_version();

/// Revision of the source tree, with "-dirty" appended if files differed from it; "unknown" outside a git checkout.
std::string git_revision();

/// floes, its revision, compiler, flags, and the libraries.
std::vector<Software> built_with();

// Which attempts began but never ended: the trace of a member that crashes its process. It is kept in the journal,
// which survives the process.

/// Identity of a member in the journal: the fingerprint of its case, and its arrangement number.
using MemberIdentity = std::pair<std::string, int>;

class AttemptBook {
  public:
    void started(const MemberIdentity& member) { entries_[member].open = true; }
    /// The member has a result; its count starts again from zero.
    void finished(const MemberIdentity& member) { entries_.erase(member); }
    /// The session ended properly: running attempts do not count against their members.
    void session_ended();
    /// A new session begins, or the caller knows that none is active: attempts still running were lost.
    void close_session();

    /// Number of sessions lost while the member was running, since its last result if it has one.
    int lost(const MemberIdentity& member) const;

  private:
    struct Entry {
        bool open = false;
        int lost = 0;
    };
    std::map<MemberIdentity, Entry> entries_;
};

// One start of the program on a campaign: host, software, start and end. Provenance only.

struct Session {
    std::string started;  ///< UTC, ISO 8601
    std::string ended;    ///< UTC, ISO 8601; empty: running or killed
    std::string outcome;  ///< "complete", "stopped", …; empty: running or killed
    std::string host;     ///< of rank 0
    std::string machine;  ///< system, release, processor of rank 0
    std::string job;      ///< batch job id; empty outside a batch system
    int ranks = 1;
    int threads = 1;    ///< over all ranks
    int reused = 0;     ///< members done or set aside when it began
    int retried = 0;    ///< members retried because they had failed or were lost with their process
    int computed = 0;   ///< members done in it; counted by the journal
    int set_aside = 0;  ///< members set aside in it; counted by the journal
    std::vector<Software> software;
    int part = 1;            ///< K of --part K/N
    int parts = 1;           ///< N
    double clock_ahead = 0;  ///< s: the host's clock less that of the file system, to which it wrote; 0: they agree
    friend bool operator==(const Session&, const Session&) = default;
};

/// A session of this process that starts now. `others`: software whose version only the caller knows (MPI).
Session describe_session(int ranks, int threads, std::span<const Software> others,
                         const System& system = this_system());

/// Name of this computer.
std::string host_name();

/// The present moment, UTC, ISO 8601 to the second.
std::string utc_now(const System& system = this_system());

/// The version of the software `name`; empty if there is none.
std::string version_of(const Session& session, std::string_view name);

/// The differences between two sessions that may change the last bits of a member: revision, compiler, flags, Bullet,
/// and the C library with the code path of its sin and cos. Each line is like "git_revision: 1a2b3c before, 4d5e6f
/// now".
std::vector<std::string> changed_software(const Session& before, const Session& now,
                                          std::string_view where_before = "before", std::string_view where_now = "now");

/// Without part and clock, which encode_surroundings() has.
Bytes encode(const Session& session);

/// Part and clock of a session; and the process, so that two sessions that began alike differ.
Bytes encode_surroundings(const Session& session, std::int64_t process);

/// Into the session that it is of. Throws RunError as decode_session().
void decode_surroundings(std::span<const std::byte> bytes, Session& session);

/// Throws RunError if the bytes are not exactly one session.
Session decode_session(std::span<const std::byte> bytes);

}  // namespace floes
