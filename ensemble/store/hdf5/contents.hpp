#pragma once
// The contents of a whole file: the paths of all datasets, and one digest over them. Only for sources of rooms with
// HDF5 files of their own.

#include <string>
#include <vector>

#include "hdf5/digest.hpp"

namespace floes::hdf5 {

/// Paths of all groups, or of all datasets, from the root on ("/members/status"), each group's in alphabetical order.
struct Paths {
    std::vector<std::string> groups;  ///< the root "/" is the first
    std::vector<std::string> datasets;
    std::vector<std::string> unreadable;  ///< of both kinds; only a search for damage continues with these
};
Paths paths_of(hid_t file);

/// The digest over everything except how the file was made: for each group and dataset outside /provenance the path and
/// all attributes that are text or numbers, which include the digest of the dataset. Two files of the same members have
/// the same. `provenance`: the digest over /provenance; empty if there is none.
struct ContentsDigests {
    std::string contents;
    std::string provenance;
    friend bool operator==(const ContentsDigests&, const ContentsDigests&) = default;
};
ContentsDigests contents_digests(hid_t file);

/// Writes both digests, as attributes of the root and of /provenance. Call it last.
void write_contents_digests(hid_t file);

/// The digests that the file has; empty if there are none.
ContentsDigests read_contents_digests(hid_t file);

}  // namespace floes::hdf5
