#pragma once
// A script for ParaView that shows a series of VTK files as Fig. 5 shows a run.

#include <string>

#include "replay/recording.hpp"

namespace floes {

/// What a state needs to know of the series.
struct VtkStateOf {
    std::string collection;           ///< name of the .pvd file beside which the state will stand
    double first_axis = 0;            ///< x of the structure's axis in the first frame, m
    double last_axis = 0;             ///< in the last frame
    double largest_load = 0;          ///< on the structure in any frame, N
    double time_of_largest_load = 0;  ///< s
    double largest_force = 0;         ///< on the structure or at a contact, N
};

/// The text of NAME.py. The camera is that of View::perspective.
std::string vtk_state(const VtkStateOf& series, const RecordingSubject& subject);

}  // namespace floes
