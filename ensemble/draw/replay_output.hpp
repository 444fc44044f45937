#pragma once
// The files that floes replay makes of a recording, by the ending of their names.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "replay/recording.hpp"

namespace floes {

enum class ReplayOutput { recording, page, picture, film, series };

/// Throws InputError, with all endings, for any other.
ReplayOutput kind_of(const std::filesystem::path& path);

struct ReplayLook {
    std::optional<double> at = {};  ///< s, of pictures; not given: the largest load among the frames
    bool worst = false;             ///< pages open at the largest load too; of part of a run they do anyway
    std::string view = "perspective";
    std::string colours = "ice";
    std::string size = "1280x800";
    int rate = 25;  ///< frames of films a second
};

/// Throws InputError if something in it cannot be drawn.
void check(const ReplayLook& look);

/// Throws InputError if its time is more than `every` beyond the frames, which go from `from` to `to` s.
void check_time(const ReplayLook& look, double from, double to, double every);

/// Makes the file; if that fails, an earlier file stays as it was. `go_on` is called repeatedly while a film is drawn,
/// with the share that is done, and throws to stop it. Not for ReplayOutput::recording.
void write_replay_output(const std::filesystem::path& path, const Recording& recording, const ReplayLook& look,
                         const std::function<void(double)>& go_on);

}  // namespace floes
