#pragma once
// The arrows of a picture and what they mean: forces, the tow, and the scales of lengths and forces. For this room
// only.

#include "picture/scene.hpp"

namespace floes {

/// A dark ground for words, between two corners.
void draw_ground(Canvas& canvas, const Vec2& from, const Vec2& to);

/// Mooring lines, at most as far as three radii of the structure. `unit`: pixels that a line is thick, as below.
void draw_lines(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit);

/// An arrow ahead of the structure, as far as the picture goes.
void draw_tow(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit);

/// Forces as lines of Fig. 5: the load in the middle of the structure, normal and friction forces where floes touch.
void draw_forces(Canvas& canvas, const Stage& stage, const Frame& frame, const Projection& projection, double unit);

/// Bars for a length and, with `forces`, a force, both as at the structure, and which line is which, in the lower right
/// of a picture of this size.
void draw_scales(Canvas& canvas, const Stage& stage, const Projection& projection, const Vec2& size, double unit,
                 bool forces);

}  // namespace floes
