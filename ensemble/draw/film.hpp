#pragma once
// A film of a recording: .mp4, .webm, .webp and .gif through ffmpeg, .apng without it.

#include <filesystem>
#include <functional>

#include "core/started_program.hpp"
#include "draw/picture.hpp"

namespace floes {

/// Throws InputError where a file of that name would be a film whose encoder is not on this machine.
void expect_encoder(const std::filesystem::path& path);

/// Every frame of the recording becomes one of the film, `rate` of them a second. `progress`: after each, the share
/// that is done. Throws InputError when the ending is none of the above or ffmpeg is missing, and RunError when it
/// fails, takes longer than that over a picture, or the file cannot be written.
void write_film(const std::filesystem::path& path, const Recording& recording, const PictureStyle& style, int rate,
                const std::function<void(double done)>& progress, Seconds longest_picture = Seconds(300));

}  // namespace floes
