#pragma once
// Words of commands that the program names, for people to copy.

#include <string>

namespace floes {

/// The word as a shell takes it for one: "a.h5", "'my file.h5'".
std::string shell_word(const std::string& word);

}  // namespace floes
