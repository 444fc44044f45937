#pragma once
// Pictures of a run: the ice and the structure of one frame as coloured faces, its loads, and films.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/started_program.hpp"
#include "draw/canvas.hpp"
#include "replay/recording.hpp"
#include "replay/view.hpp"

namespace floes {

struct Face {
    std::vector<Vec3> corners;  ///< Projection::seen
    Colour colour;
    std::uint32_t edges = 0;  ///< bit k: a line from corner k to the next one
};

/// A part, of the floes' size, of an ice sheet.
struct SheetPart {
    IceSheet box;
    std::uint8_t exposed = 0;  ///< sides that are the sheet's own, bits of Edge
};

/// A run on which frames are drawn: all that does not change from one to the next.
class Stage {
  public:
    Stage(RecordingSubject subject, RecordingOutcome outcome);

    /// What of the frame is seen in a picture of `size` pixels.
    std::vector<Face> faces(const Frame& frame, const Projection& projection, const Vec2& size,
                            Colouring colouring) const;

    int broken_floes(double time) const;
    double largest_load() const { return largest_load_; }  ///< of all steps, surge, sway and heave together, N
    const RecordingSubject& subject() const { return subject_; }
    const RecordingOutcome& outcome() const { return outcome_; }

  private:
    RecordingSubject subject_;
    RecordingOutcome outcome_;
    double largest_load_;
    IceLayout layout_;
    std::vector<SheetPart> sheets_;
};

/// Where a mooring line runs, from its fairlead as far as `most` m.
std::vector<Vec3> beginning_of(const Moorings& moorings, const FrameLine& line, double most);

// A picture of one frame: the ice round the structure with its loads as in Fig. 5, or the channel from above as in
// Fig. 3; underneath the load over time.

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

/// Throws InputError where a file of that name would be a film whose encoder is not on this machine.
void expect_encoder(const std::filesystem::path& path);

/// Every frame of the recording becomes one of the film, `rate` of them a second. `progress`: after each, the share
/// that is done. Throws InputError when the ending is none of the above or ffmpeg is missing, and RunError when it
/// fails, takes longer than that over a picture, or the file cannot be written.
void write_film(const std::filesystem::path& path, const Recording& recording, const PictureStyle& style, int rate,
                const std::function<void(double done)>& progress, Seconds longest_picture = Seconds(300));

}  // namespace floes
