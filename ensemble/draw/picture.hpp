#pragma once
// A picture of one frame: the ice round the structure with its loads as in Fig. 5, or the channel from above as in
// Fig. 3; underneath the load over time.

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "draw/scene.hpp"

namespace floes {

struct PictureStyle {
    View view = View::perspective;
    Colouring colouring = Colouring::ice;
    int width = 1280;  ///< pixels
    int height = 800;  ///< pixels; of `plan`: as high as the channel needs at this width, and the load
    double from = 0;   ///< s that the load is drawn from
    double to = 0;     ///< s; not above `from`: the whole run
};

/// The height that a picture of this style gets, pixels; even, as films want it.
int picture_height(const PictureStyle& style, const RecordingSubject& subject);

/// What stands at the ends of an axis of times, s: to whole seconds, and finer over less than ten.
std::pair<std::string, std::string> ends_of_axis(double from, double to);

/// Draws the frame all over the canvas.
void draw_picture(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style);

// A film of a recording: .mp4, .webm, .webp and .gif through ffmpeg, .apng without it.

/// Every frame of the recording becomes one of the film, `rate` of them a second. `progress`: after each, the share
/// that is done. Throws InputError when the ending is none of the above or ffmpeg is missing, and RunError when it
/// fails or the file cannot be written.
void write_film(const std::filesystem::path& path, const Recording& recording, const PictureStyle& style, int rate,
                const std::function<void(double done)>& progress);

}  // namespace floes
