#pragma once
// What a floe that cracked through is in at the end of a run.

namespace floes {

struct PieceArea {
    int floe = 0;     ///< its number in the order of entry: its index in the arrangement, if the field has an end
    double area = 0;  ///< of the upper side, m²
};

}  // namespace floes
