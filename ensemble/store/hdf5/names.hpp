#pragma once
// Names of links and of attributes. For this room only.

#include <algorithm>
#include <string>
#include <vector>

#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// The names that iterate(visit, names) visits, as H5Literate and H5Aiterate do; Info is the type of their information.
/// Sorted here, because HDF5 itself can crash when it sorts the names of a damaged file.
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
