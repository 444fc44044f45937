#pragma once
// Names of links and of attributes. For this room only.

#include <algorithm>
#include <string>
#include <vector>

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// Those that iterate(visit, names) visits, as H5Literate and H5Aiterate do; Info is what these say of one. Ordered
/// here: HDF5 may free what it has not read where it orders those of a damaged file.
template <class Info, class Iterate>
std::vector<std::string> names_in_order(const Iterate& iterate) {
    std::vector<std::string> names;
    iterate(
        +[](hid_t, const char* name, const Info*, void* to) -> herr_t {
            static_cast<std::vector<std::string>*>(to)->emplace_back(name);
            return 0;
        },
        &names);
    std::ranges::sort(names);
    return names;
}

}  // namespace floes::hdf5
