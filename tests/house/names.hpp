#pragma once
// Classes of one name: two of them in one program are undefined behaviour that the linker does not see.

#include <string>
#include <vector>

#include "house/includes.hpp"

namespace floes::house {

/// The classes, structs and enumerations that the text defines outside functions, classes and unnamed namespaces, with
/// the namespaces that they are in: "floes::hdf5::Handle".
std::vector<std::string> classes_of(const std::string& text);

/// One sentence for each name that stands for classes of several units (the .hpp and the .cpp of one stem are one).
std::vector<std::string> shared_names(const std::vector<Source>& sources);

}  // namespace floes::house
