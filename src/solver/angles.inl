// The arc functions of the joint error from exactly rounded operations, so that neither the lane width nor the maths
// library of the machine shows in a result. Coefficients: Cephes atan (S. Moshier), error below 2e-16 relative.

/// atan of |t| <= tan(π/8).
inline Pack arc_tangent_core(Pack t) {
    const Pack z = t * t;
    const Pack p =
        (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
         1.228866684490136173410e2) *
            z -
        6.485021904942025371773e1;
    const Pack q =
        ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2) * z +
         4.853903996359136964868e2) *
            z +
        1.945506571482613964425e2;
    return t + t * (z * p / q);
}

/// atan2(y, x) in [-π, π]; (0, 0) is not allowed.
inline Pack arc_tangent(Pack y, Pack x) {
    constexpr double quarter = 0.78539816339744830962;  // π/4
    constexpr double half = 1.57079632679489661923;
    constexpr double full = 3.14159265358979323846;
    const Pack zero = y * 0.0;
    const Pack up = absolute(y);
    const Pack across = absolute(x);
    const auto steep = up > across;
    const Pack small = steep ? across : up;
    const Pack large = steep ? up : across;
    const auto diagonal = small > 0.41421356237309503 * large;  // tan(π/8): atan t = π/4 + atan((t - 1) / (t + 1))
    const Pack numerator = diagonal ? small - large : small;
    const Pack denominator = diagonal ? small + large : large;
    Pack angle = arc_tangent_core(numerator / denominator) + (diagonal ? zero + quarter : zero);
    angle = steep ? half - angle : angle;
    angle = x < 0.0 ? full - angle : angle;
    return y < 0.0 ? -angle : angle;
}

/// asin, arguments beyond ±1 (rounding of a rotation matrix) taken as ±1.
inline Pack arc_sine(Pack s) {
    const Pack rest = (1.0 - s) * (1.0 + s);
    return arc_tangent(s, square_root(rest < 0.0 ? rest * 0.0 : rest));
}
