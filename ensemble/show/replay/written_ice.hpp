#pragma once
// The part of a recording that says what the ice is, written. For this room only.

#include <vector>

#include "hdf5/write.hpp"
#include "ice/failure_mode.hpp"
#include "ice/ice_layout.hpp"
#include "replay/frame_series.hpp"
#include "scenario/floes.hpp"

namespace floes {

hdf5::Scale element_scale(hid_t file, const IceLayout& layout);

/// usual: the scenario's own floe, whose size an attribute has. `scales` have the elements.
void write_ice(hid_t file, const FloeShape& usual, const IceLayout& layout, const RecordScales& scales);

/// The floes of a field without end, which no configuration tells: what read_floes() makes them from again.
void write_floes(hid_t file, const FloeSet& floes, const std::vector<int>& numbers);

void write_joints(hid_t file, const IceLayout& layout, const std::vector<BreakEvent>& breaks);

}  // namespace floes
