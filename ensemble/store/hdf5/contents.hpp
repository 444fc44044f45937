#pragma once
// What a whole file holds: all its datasets by path, and the digest over them. Only for sources of rooms with HDF5
// files of their own.

#include <string>
#include <vector>

#include "hdf5/digest.hpp"

namespace floes::hdf5 {

/// Paths of all groups, or of all datasets, from the root on ("/members/status"), each group's in alphabetical order.
struct Paths {
    std::vector<std::string> groups;  ///< the root "/" is the first
    std::vector<std::string> datasets;
    std::vector<std::string> unreadable;  ///< of either: only who looks for damage goes on with these
};
Paths paths_of(hid_t file);

/// The digest over all that does not say how the file was made: of groups and datasets outside /provenance in turn the
/// path, each attribute that is a text or numbers, and so the digest of each dataset. Two files of the same members
/// have the same. `provenance`: the same of what lies in /provenance; empty where there is none.
struct ContentsDigests {
    std::string contents;
    std::string provenance;
    friend bool operator==(const ContentsDigests&, const ContentsDigests&) = default;
};
ContentsDigests contents_digests(hid_t file);

/// Writes them, when all else is written: the one as an attribute of the root, the other of /provenance.
void write_contents_digests(hid_t file);

/// Those written; empty where there are none.
ContentsDigests read_contents_digests(hid_t file);

}  // namespace floes::hdf5
