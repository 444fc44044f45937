#pragma once
// A small file beside the journal that shows other terminals and nodes what a run is doing. It is replaced every few
// seconds and removed at the end. It is for display only; no decision depends on it.

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
        double seconds = 0;  ///< since it was handed out
    };

    std::string host;                 ///< of rank 0
    std::int64_t process = 0;         ///< of rank 0
    std::int64_t time = 0;            ///< time of writing, s since 1970 by that host's clock
    double elapsed = 0;               ///< s since the session began
    int finished = 0;                 ///< members done or failed in the session
    double finished_cost = 0;         ///< their expected cost
    double remaining_cost = 0;        ///< of all unfinished members, same unit
    std::vector<UnderWay> under_way;  ///< longest first, at most 20
};

/// `a.h5` -> `a.alive`, in the same folder.
std::filesystem::path heartbeat_path(const std::filesystem::path& campaign_file);

/// Sets host, process and time, and replaces the file by renaming. Errors of the file system are ignored.
void write_heartbeat(const std::filesystem::path& path, Heartbeat heartbeat);

/// Empty if there is no such file or it cannot be parsed.
std::optional<Heartbeat> read_heartbeat(const std::filesystem::path& path);

/// Seconds since it was written, if the clocks agree.
double age_of(const Heartbeat& heartbeat);

/// True if the run has certainly or probably died: its process does not exist on this host, or the heartbeat is more
/// than a minute old.
bool is_stale(const Heartbeat& heartbeat);

}  // namespace floes
