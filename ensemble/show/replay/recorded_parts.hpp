#pragma once
// What a recording has once, read: its subject and its outcome. For this room only.

#include "hdf5/handle.hpp"
#include "replay/recording.hpp"

namespace floes {

/// Both throw InputError for files that are damaged.
RecordingSubject read_subject(hid_t file);
RecordingOutcome read_outcome(hid_t file, const IceLayout& layout);

}  // namespace floes
