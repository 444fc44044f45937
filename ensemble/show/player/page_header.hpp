#pragma once
// What the page of a replay knows besides its frames: what was run, the shapes, the cameras, joints that failed and the
// load history. For this room only.

#include <optional>
#include <string>

#include "player/frame_packer.hpp"
#include "replay/recording.hpp"

namespace floes {

/// A JSON object; its names are read by page_assets/data.js. SI units.
std::string page_header(const Recording& recording, const Quanta& quanta, const PackedFrames& frames,
                        std::optional<double> start = {});

}  // namespace floes
