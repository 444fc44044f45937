#pragma once
// A picture of one frame: the ice round the structure with its loads as in Fig. 5, or the channel from above as in
// Fig. 3; underneath the load over time.

#include "picture/scene.hpp"

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

/// Draws the frame all over the canvas.
void draw_picture(Canvas& canvas, const Stage& stage, const Frame& frame, const PictureStyle& style);

}  // namespace floes
