#pragma once
// The ice and the structure of one frame as coloured faces of a picture.

#include <cstdint>
#include <span>
#include <vector>

#include "picture/canvas.hpp"
#include "replay/recording.hpp"
#include "view/colours.hpp"
#include "view/projection.hpp"

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

}  // namespace floes
