#pragma once
// A film of a recording: .mp4, .webm, .webp and .gif through ffmpeg, .apng without it.

#include <filesystem>
#include <functional>

#include "picture/picture.hpp"

namespace floes {

/// Every frame of the recording becomes one of the film, `rate` of them a second. `progress`: after each, the share
/// that is done. Throws InputError when the ending is none of the above or ffmpeg is missing, and RunError when it
/// fails or the file cannot be written.
void write_film(const std::filesystem::path& path, const Recording& recording, const PictureStyle& style, int rate,
                const std::function<void(double done)>& progress);

}  // namespace floes
