#pragma once
// The page of a replay: one self-contained HTML file that plays a recording in any browser, opened from disk. It asks
// nothing of the network; three.js is part of it.

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>

#include "replay/recording.hpp"

namespace floes {

struct PageOptions {
    /// The page is at most this large. Where all frames would take more, only every second, third, ... is in it; the
    /// page moves the ice smoothly from one to the next and says how far apart they are.
    std::size_t most_bytes = 15'000'000;
    std::optional<double> start = {};  ///< s, that the page opens at; not given: its first frame
};

/// Frames are read one at a time, twice or oftener; what is kept of them is compressed, so memory is bounded by the
/// size of the page. Throws InputError when even its first and last frame are larger than that.
void write_replay_page(std::ostream& page, const Recording& recording, const PageOptions& options = {});

/// The same to a file. Throws RunError when it cannot be written.
void write_replay_page(const std::filesystem::path& path, const Recording& recording, const PageOptions& options = {});

}  // namespace floes
