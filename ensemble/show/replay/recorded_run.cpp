// What a recording says of the run as a whole.

#include <algorithm>

#include "replay/recording.hpp"

namespace floes {

std::vector<std::uint8_t> broken_floes(const std::vector<BreakEvent>& breaks, int floes, double time) {
    std::vector<std::uint8_t> broken(static_cast<std::size_t>(floes), 0);
    for (const BreakEvent& event : breaks) {
        if (event.time > time) break;
        broken[static_cast<std::size_t>(event.floe)] = 1;
    }
    return broken;
}

Channel RecordingSubject::channel() const {
    Channel channel = make_channel(scenario, floes);
    if (!scenario.field.endless()) return channel;
    channel.begin = std::max(channel.begin, way.x() - seen_behind());
    channel.end = way.y() + seen_ahead();
    for (IceSheet& sheet : channel.sheets) {
        sheet.centre.x() = 0.5 * (channel.begin + channel.end);
        sheet.half_extents.x() = 0.5 * (channel.end - channel.begin);
    }
    return channel;
}

double RecordingSubject::seen_ahead() const {
    return scenario.window_ahead() + largest_side(floes);
}

double RecordingSubject::seen_behind() const {
    return scenario.window_behind() + largest_side(floes);
}

}  // namespace floes
