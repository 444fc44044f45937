#pragma once
// Pictures of a run: the ice and the structure of one frame as coloured faces, and its loads.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

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

/// A history below the picture, in units that are shown.
struct HistoryStrip {
    std::string words;
    std::string unit;
    std::vector<double> values;  ///< of each step; empty: the recording does not have it
    bool from_zero = true;       ///< its axis has 0
    int decimals = 0;
};

/// Of what the subject asks and, for a hull that gives way, its offset, heading and largest tension of a line.
std::vector<HistoryStrip> strips_of(const RecordingSubject& subject, const RecordingOutcome& outcome);

/// A run on which frames are drawn: all that does not change from one to the next.
class Stage {
  public:
    Stage(RecordingSubject subject, RecordingOutcome outcome);

    /// What of the frame is seen in a picture of `size` pixels.
    std::vector<Face> faces(const Frame& frame, const Projection& projection, const Vec2& size,
                            Colouring colouring) const;

    FloeCounts floes(const Frame& frame) const {
        return is_level() ? count_pieces(frame) : count_floes(frame, layout_, outcome_.breaks);
    }
    double drift() const { return drift_; }  ///< Scenario::drift()
    bool is_level() const { return subject_.scenario.arrangement.level(); }
    double largest_load() const { return largest_load_; }  ///< of all steps, surge, sway and heave together, N
    /// That loads of all steps lie in, with none: as Frame::load, N.
    const Eigen::AlignedBox3d& loads() const { return loads_; }
    const std::vector<double>& asked() const { return asked_; }  ///< what the subject asks, of every step, SI
    const std::vector<HistoryStrip>& strips() const { return strips_; }
    const RecordingSubject& subject() const { return subject_; }
    const RecordingOutcome& outcome() const { return outcome_; }
    /// "ice from 20° at 0.5 m/s" in the step that ends at `time` s, 0° ahead along +x, 90° from +z; empty of the
    /// straight tow, whose ice comes from ahead all the time.
    std::string ice_words(double time) const;

  private:
    RecordingSubject subject_;
    RecordingOutcome outcome_;
    double drift_;
    double largest_load_;
    Eigen::AlignedBox3d loads_;
    std::vector<double> asked_;
    std::vector<HistoryStrip> strips_;
    IceLayout layout_;
    std::vector<SheetPart> sheets_;
    std::vector<PathPlace> way_;  ///< empty of the straight tow
};

/// Metres that a newton of the load is long in a picture of this size (pixels): no load of the run leaves it. 0
/// without any load.
double metres_a_newton(const Stage& stage, const Frame& frame, const Projection& projection, const Vec2& size);

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

/// "largest mooring force over 1 s: 332 kN" of the frame that has it among the times of the style; empty of others.
std::string moment_words(const Stage& stage, const Frame& frame, const PictureStyle& style);

/// The height that a picture of this style gets, pixels; even, as films want it.
int picture_height(const PictureStyle& style, const RecordingSubject& subject);

/// What stands at the ends of an axis of times, s: to whole seconds, and finer over less than ten.
std::pair<std::string, std::string> ends_of_axis(double from, double to);

/// Draws the frame all over the canvas.
void draw_picture(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style);

}  // namespace floes
