#include "driver/walltime.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

namespace floes {

namespace {

std::optional<int> number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
    return value;
}

std::string output_of(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    std::array<char, 64> text{};
    if (!pipe || std::fgets(text.data(), text.size(), pipe.get()) == nullptr) return {};
    return text.data();
}

}  // namespace

std::optional<double> parse_time_left(std::string_view text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.remove_suffix(1);
    std::optional<int> days = 0;
    if (const std::size_t dash = text.find('-'); dash != std::string_view::npos) {
        days = number(text.substr(0, dash));
        text.remove_prefix(dash + 1);
    }
    if (!days) return std::nullopt;
    double seconds = 0;
    int parts = 0;
    for (bool more = true; more; ++parts) {
        const std::size_t colon = text.find(':');
        more = colon != std::string_view::npos;
        const std::optional<int> part = number(text.substr(0, colon));
        if (!part) return std::nullopt;
        seconds = 60 * seconds + *part;
        if (more) text.remove_prefix(colon + 1);
    }
    if (parts > 3) return std::nullopt;
    return *days * 86400.0 + seconds;
}

std::optional<double> find_time_left(double asked) {
    if (asked > 0) return asked;
    const char* job = std::getenv("SLURM_JOB_ID");
    if (job == nullptr || !number(job)) return std::nullopt;
    return parse_time_left(output_of(std::string("squeue -h -j ") + job + " -o %L 2>/dev/null"));
}

Walltime::Walltime(std::optional<double> seconds_left, Time now) {
    if (!seconds_left) return;
    const std::chrono::duration<double> usable(*seconds_left - std::min(60.0, 0.1 * *seconds_left));
    end_ = now + std::chrono::duration_cast<Time::duration>(usable);
}

std::optional<double> Walltime::left(Time now) const {
    if (!end_) return std::nullopt;
    return std::chrono::duration<double>(*end_ - now).count();
}

}  // namespace floes
