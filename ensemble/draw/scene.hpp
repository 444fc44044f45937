#pragma once
// The ice and the structure of one frame as coloured faces of a picture.

#include <cstdint>
#include <span>
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

// The arrows of a picture and what they mean: forces, the tow, and the scales of lengths and forces. For this module
// only.

/// A dark ground for words, between two corners.
void draw_ground(Canvas& canvas, const Vec2& from, const Vec2& to);

/// Where a mooring line runs, from its fairlead as far as `most` m.
std::vector<Vec3> beginning_of(const Moorings& moorings, const FrameLine& line, double most);

/// Mooring lines, at most as far as three radii of the structure. `unit`: pixels that a line is thick, as below.
void draw_lines(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit);

/// An arrow ahead of the structure, as far as the picture goes.
void draw_tow(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit);

/// Forces as lines of Fig. 5: the load in the middle of the structure, normal and friction forces where floes touch.
void draw_forces(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit);

/// Bars for a length and, with `forces`, a force, both as at the structure, and which line is which, in the lower right
/// of a picture of this size.
void draw_scales(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, const Vec2& size,
                 double unit, bool forces);

}  // namespace floes
