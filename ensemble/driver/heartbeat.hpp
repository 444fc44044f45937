#pragma once
// A small file beside the journal that tells other terminals and nodes what a run is doing: replaced every few seconds,
// removed at the end. For people only: nothing is computed, kept or given up because of it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floes {

struct Heartbeat {
    /// A member that was handed out.
    struct UnderWay {
        int number = 0;
        int attempt = 1;
        double seconds = 0;  ///< since then
    };

    std::string host;                 ///< of rank 0
    std::int64_t process = 0;         ///< of rank 0
    std::int64_t time = 0;            ///< when it was written, s since 1970 by that host's clock
    double elapsed = 0;               ///< s since the session began
    int finished = 0;                 ///< members done or failed in the session
    double finished_cost = 0;         ///< their expected cost
    double remaining_cost = 0;        ///< of all that is not finished, same unit
    std::vector<UnderWay> under_way;  ///< longest first, at most 20
};

/// `a.h5` -> `a.alive`, in the same folder.
std::filesystem::path heartbeat_path(const std::filesystem::path& campaign_file);

/// Fills host, process and time, and replaces the file by renaming. A file system that refuses is no trouble.
void write_heartbeat(const std::filesystem::path& path, Heartbeat heartbeat);

/// None where there is no such file or it cannot be understood.
std::optional<Heartbeat> read_heartbeat(const std::filesystem::path& path);

/// Seconds since it was written, as far as the clocks agree.
double age_of(const Heartbeat& heartbeat);

/// True when the run is certainly or probably gone: its process does not exist on this host, or nothing was heard of it
/// for a minute.
bool is_stale(const Heartbeat& heartbeat);

}  // namespace floes
