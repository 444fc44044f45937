#include "driver/heartbeat.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "records/session.hpp"

namespace floes {
namespace {

constexpr double longest_silence = 60;  // s; heartbeats come every few seconds, but publishing may delay one

}  // namespace

std::filesystem::path heartbeat_path(const std::filesystem::path& campaign_file) {
    return std::filesystem::path(campaign_file).replace_extension(".alive");
}

void write_heartbeat(const std::filesystem::path& path, Heartbeat heartbeat) {
    const std::filesystem::path aside = path.string() + ".tmp";
    std::ofstream out(aside, std::ios::trunc);
    out << fmt::format("host {}\nprocess {}\ntime {}\n", host_name(), ::getpid(), std::time(nullptr));
    out << fmt::format("elapsed {}\nfinished {}\nfinished_cost {}\nremaining_cost {}\n", heartbeat.elapsed,
                       heartbeat.finished, heartbeat.finished_cost, heartbeat.remaining_cost);
    for (const Heartbeat::UnderWay& one : heartbeat.under_way)
        out << fmt::format("member {} {} {}\n", one.number, one.attempt, one.seconds);
    out.close();
    std::error_code ignored;
    if (out) {
        std::filesystem::rename(aside, path, ignored);
    } else {
        std::filesystem::remove(aside, ignored);
    }
}

std::optional<Heartbeat> read_heartbeat(const std::filesystem::path& path) {
    std::ifstream in(path);
    Heartbeat heartbeat;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        if (name == "host") words >> heartbeat.host;
        if (name == "process") words >> heartbeat.process;
        if (name == "time") words >> heartbeat.time;
        if (name == "elapsed") words >> heartbeat.elapsed;
        if (name == "finished") words >> heartbeat.finished;
        if (name == "finished_cost") words >> heartbeat.finished_cost;
        if (name == "remaining_cost") words >> heartbeat.remaining_cost;
        if (name == "member") {
            Heartbeat::UnderWay& one = heartbeat.under_way.emplace_back();
            words >> one.number >> one.attempt >> one.seconds;
        }
        if (words.fail()) return {};
    }
    if (heartbeat.host.empty() || heartbeat.process <= 0) return {};
    return heartbeat;
}

double age_of(const Heartbeat& heartbeat) {
    return static_cast<double>(std::time(nullptr) - heartbeat.time);
}

bool is_stale(const Heartbeat& heartbeat) {
    const bool gone =
        heartbeat.host == host_name() && ::kill(static_cast<pid_t>(heartbeat.process), 0) != 0 && errno == ESRCH;
    return gone || age_of(heartbeat) > longest_silence;
}

}  // namespace floes
