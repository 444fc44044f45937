#include "player/thinned_history.hpp"

#include <algorithm>
#include <cstdint>

namespace floes {

ThinnedHistory thinned(std::span<const double> history, int begin, int end, int most) {
    ThinnedHistory kept;
    const auto keep = [&](int step) {
        kept.steps.push_back(step);
        kept.values.push_back(static_cast<float>(history[static_cast<std::size_t>(step)]));
    };
    const int count = end - begin;
    if (count <= most) {
        for (int step = begin; step < end; ++step) keep(step);
        return kept;
    }
    const int parts = most / 2;
    const auto edge = [&](int part) { return begin + static_cast<int>(std::int64_t{count} * part / parts); };
    for (int part = 0; part < parts; ++part) {
        const auto [least, largest] =
            std::minmax_element(history.begin() + edge(part), history.begin() + edge(part + 1));
        const auto first = static_cast<int>(std::min(least, largest) - history.begin());
        const auto second = static_cast<int>(std::max(least, largest) - history.begin());
        keep(first);
        if (second != first) keep(second);
    }
    return kept;
}

}  // namespace floes
