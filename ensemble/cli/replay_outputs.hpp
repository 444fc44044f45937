#pragma once
// What floes replay makes of a recording, by the ending of each file's name.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "replay/recording.hpp"

namespace floes {

enum class ReplayOutput { recording, page, picture, film, vtk };

/// Throws InputError, with all endings, for any other.
ReplayOutput kind_of(const std::filesystem::path& path);

struct ReplayLook {
    std::optional<double> at = {};  ///< s, of pictures; not given: the largest load among the frames
    std::string view = "perspective";
    std::string colours = "ice";
    std::string size = "1280x800";
    int rate = 25;  ///< frames of films a second
};

/// Throws InputError when there is something in it that cannot be drawn.
void check(const ReplayLook& look);

/// Makes the file, with progress on standard error; one that fails leaves what was there before. `go_on` is called
/// again and again where that takes long, and throws to stop it. Not for ReplayOutput::recording.
void write_replay_output(const std::filesystem::path& path, const Recording& recording, const ReplayLook& look,
                         const std::function<void()>& go_on);

}  // namespace floes
