#include "store/session.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gnu/libc-version.h>

#include "core/error.hpp"
#include "core/fields.hpp"
#include "store/build_facts.hpp"
#include "store/git_revision.hpp"

namespace floes {

std::string floes_version() {
    return FLOES_VERSION;
}

std::string git_revision() {
    return FLOES_GIT_REVISION;
}

std::vector<Software> built_with() {
    return {{"floes", floes_version()},       {"git_revision", git_revision()},
            {"compiler", FLOES_COMPILER},     {"compiler_flags", FLOES_COMPILER_FLAGS},
            {"bullet", FLOES_BULLET_VERSION}, {"eigen", FLOES_EIGEN_VERSION},
            {"hdf5", FLOES_HDF5_VERSION},     {"tbb", FLOES_TBB_VERSION},
            {"boost", FLOES_BOOST_VERSION}};
}

void AttemptBook::session_ended() {
    std::erase_if(entries_, [](const auto& entry) { return entry.second.lost == 0; });
    for (auto& [member, entry] : entries_) entry.open = false;
}

void AttemptBook::close_session() {
    for (auto& [member, entry] : entries_) entry.lost += std::exchange(entry.open, false) ? 1 : 0;
}

int AttemptBook::lost(const MemberIdentity& member) const {
    const auto found = entries_.find(member);
    return found == entries_.end() ? 0 : found->second.lost;
}

namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

std::string system_and_processor() {
    utsname name{};
    if (uname(&name) != 0) return processor();
    return fmt::format("{} {} {}, {}", name.sysname, name.release, name.machine, processor());
}

/// glibc has sin and cos with and without fused multiply-add and chooses by processor, so the bits differ. Bullet's own
/// solver calls them; the lanes do not.
std::string math_library() {
#if defined(__x86_64__)
    const bool fused = __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
    return fmt::format("glibc {} {} FMA", gnu_get_libc_version(), fused ? "with" : "without");
#else
    return fmt::format("glibc {}", gnu_get_libc_version());
#endif
}

std::string batch_job() {
    for (const char* variable : {"SLURM_JOB_ID", "PBS_JOBID", "LSB_JOBID", "JOB_ID"})
        if (const char* value = std::getenv(variable)) return value;
    return {};
}

}  // namespace

std::string host_name() {
    std::array<char, 256> name{};
    gethostname(name.data(), name.size() - 1);
    return name.data();
}

std::string utc_now(const System& system) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(system.seconds_since_1970())));
}

std::string version_of(const Session& session, std::string_view name) {
    for (const Software& software : session.software)
        if (software.name == name) return software.version;
    return {};
}

Session describe_session(int ranks, int threads, std::span<const Software> others, const System& system) {
    Session session;
    session.started = utc_now(system);
    session.host = host_name();
    session.machine = system_and_processor();
    session.job = batch_job();
    session.ranks = ranks;
    session.threads = threads;
    session.software = built_with();
    session.software.push_back({"math_library", math_library()});
    session.software.insert(session.software.end(), others.begin(), others.end());
    return session;
}

std::vector<std::string> changed_software(const Session& before, const Session& now, std::string_view where_before,
                                          std::string_view where_now) {
    std::vector<std::string> changes;
    for (const char* name : {"floes", "git_revision", "compiler", "compiler_flags", "bullet", "math_library"}) {
        const std::string then = version_of(before, name);
        const std::string here = version_of(now, name);
        if (then != here)
            changes.push_back(fmt::format("{}: {} {}, {} {}", name, then.empty() ? "none" : then, where_before,
                                          here.empty() ? "none" : here, where_now));
    }
    return changes;
}

/// What sessions of every version have, and what came later; their surroundings are a record of their own.
constexpr auto first_fields =
    std::tuple(&Session::started, &Session::ended, &Session::outcome, &Session::host, &Session::machine, &Session::job,
               &Session::ranks, &Session::threads, &Session::software);
constexpr auto later_fields = std::tuple(&Session::reused, &Session::retried);
constexpr auto surroundings = std::tuple(&Session::part, &Session::parts, &Session::clock_ahead);

constexpr auto fields_of(std::type_identity<Software>) {
    return std::tuple(&Software::name, &Software::version);
}

Bytes encode(const Session& session) {
    ByteWriter out;
    put(out, session, first_fields);
    put(out, session, later_fields);
    return out.take();
}

Bytes encode_surroundings(const Session& session, std::int64_t process) {
    ByteWriter out;
    put(out, session, surroundings);
    out.u64(static_cast<std::uint64_t>(process));
    return out.take();
}

void decode_surroundings(std::span<const std::byte> bytes, Session& session) {
    ByteReader in(bytes);
    take(in, session, surroundings);
}

Session decode_session(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    Session session;
    take(in, session, first_fields);
    if (in.left() == 0) return session;  // from a version without counts
    take(in, session, later_fields);
    if (in.left() != 0) throw RunError("a stored session is longer than expected; it was written by another version");
    return session;
}

}  // namespace floes
