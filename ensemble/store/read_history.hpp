#pragma once
// The load histories of a campaign file, member by member: all of them at once may not fit into memory.

#include <filesystem>
#include <functional>
#include <span>

namespace floes {

struct SurgeHistory {
    int member = 0;
    double time_step = 0;           ///< s
    std::span<const double> surge;  ///< N, from t = 0 to the end of the run
};

/// Calls `use` for each done member with a stored history, in member order. Throws as read_campaign_file() does.
void for_each_history(const std::filesystem::path& path, const std::function<void(const SurgeHistory&)>& use);

}  // namespace floes
