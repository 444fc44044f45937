#pragma once
// A load history for the eye: few enough points to draw, with every peak.

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "draw/frame_packer.hpp"
#include "replay/recording.hpp"

namespace floes {

/// values[k] is that of step steps[k].
struct ThinnedHistory {
    std::vector<int> steps;     ///< rising; index of the value in the whole history
    std::vector<float> values;  ///< N
};

/// The least and the largest value of each of at most `most / 2` equal parts of the steps [begin, end), in the order in
/// which they come; all values if they are not more than `most`.
ThinnedHistory thinned(std::span<const double> history, int begin, int end, int most);

// What the page of a replay knows besides its frames: what was run, the shapes, the cameras, joints that failed and the
// load history. For this module only.

/// A JSON object; its names are read by page_assets/data.js. SI units.
std::string page_header(const Recording& recording, const Quanta& quanta, const PackedFrames& frames,
                        std::optional<double> start = {});

// The page of a replay: one self-contained HTML file that plays a recording in any browser, opened from disk. It asks
// nothing of the network; three.js is part of it.

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
