#pragma once
// What is to be seen of a run at the end of a step: how everything lies, moves, bears and touches. Read on request;
// nothing of a run depends on it.

#include <vector>

#include "core/vector.hpp"
#include "world/state.hpp"

namespace floes {

/// What touches an element, where that is no element.
inline constexpr int touches_structure = -1;
inline constexpr int touches_ice_sheet = -2;

/// A contact that exerted a force during the step.
struct FrameContact {
    int element = 0;               ///< in the order of IceField::elements(); the forces act on it
    int other = 0;                 ///< the other element, or touches_structure or touches_ice_sheet
    Vec3 point = Vec3::Zero();     ///< m
    Vec3 normal = Vec3::Zero();    ///< N
    Vec3 friction = Vec3::Zero();  ///< N
};

/// A mooring line that holds.
struct FrameLine {
    int line = 0;                  ///< in the order of moorings.lines and hanging_lines
    Vec3 fairlead = Vec3::Zero();  ///< m; of a line without weight at the height of the water
    Vec3 anchor = Vec3::Zero();    ///< m, likewise
    double tension = 0;            ///< N
};

struct Frame {
    int step = 0;     ///< steps completed; 0: the start
    double time = 0;  ///< s
    StructurePose structure;
    Vec3 load = Vec3::Zero();         ///< contact force on the structure, world axes (surge load: -x), N
    std::vector<BodyState> elements;  ///< in the order of IceField::elements()
    std::vector<int> pieces;          ///< of each element: the first element of its piece
    std::vector<double> utilisation;  ///< of each element: largest λ/ε of its live joints, 0-1
    /// In a field without end, what each of the above is in the numbers of the record (replay/floe_roll.hpp), which
    /// `pieces` and `contacts` have too; only what is there stands above. Empty: all elements, in order.
    std::vector<int> ids{};
    std::vector<FrameLine> lines{};      ///< mooring lines that hold
    std::vector<FrameContact> contacts;  ///< of the structure and among the ice, in the order of the solve

    /// The number of the `k`-th element.
    std::size_t id(std::size_t k) const { return ids.empty() ? k : static_cast<std::size_t>(ids[k]); }
};

}  // namespace floes
