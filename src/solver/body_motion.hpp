#pragma once
// Where a body is and how it moves, together in memory for whoever asks about one body.

namespace floes {

/// World axes. Plain numbers only: kernels write it, under every instruction set.
struct alignas(64) BodyMotion {
    double position[3];  ///< m
    double rotation[9];  ///< body -> world, row by row
    double velocity[3];  ///< m/s
    double angular_velocity[3];
    double way;   ///< m, how far its centre went in the last step
    double turn;  ///< rad, by how much it turned at most
    double unused[4];
};

inline constexpr int motion_numbers = sizeof(BodyMotion) / sizeof(double);

}  // namespace floes
