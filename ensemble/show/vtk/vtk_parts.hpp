#pragma once
// What ParaView shows of a run, part by part. World axes and SI throughout; forces in N, velocities in m/s.

#include <span>

#include "replay/recording.hpp"
#include "simulation/channel.hpp"
#include "simulation/frame.hpp"
#include "structure/shape.hpp"
#include "vtk/vtk_file.hpp"

namespace floes {

/// A hexahedron for each element. Cells have floe, piece (the first element of the piece), broken (1: a joint of its
/// floe has failed), utilisation (0-1, cracks to 2) and velocity. `broken`: of each floe.
VtkMesh ice_part(const Frame& frame, const IceLayout& layout, std::span<const std::uint8_t> broken);

/// A point for each contact that exerts a force. Points have normal, friction and force (their sum) on the element, the
/// element, and the other element or touches_structure or touches_ice_sheet.
VtkMesh contacts_part(const Frame& frame);

/// Four points on the structure's axis at the waterline. Points have the force on the structure and which one it is,
/// component: 0 surge, 1 heave, 2 sway (along x, y, z), 3 their sum.
VtkMesh load_part(const Frame& frame);

/// Mooring lines that hold, from fairlead to anchor. Cells have tension and which line it is.
VtkMesh moorings_part(const Frame& frame);

/// The surface of the structure with its axis there.
VtkMesh structure_part(const Shape& shape, const PlanarPose& pose);

/// A hexahedron for each sheet of fixed ice.
VtkMesh ice_sheets_part(const Channel& channel);

}  // namespace floes
