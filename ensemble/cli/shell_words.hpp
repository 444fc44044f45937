#pragma once
// Commands that people copy into a shell.

#include <string>

namespace floes {

/// The word quoted for a shell.
std::string quoted(const std::string& word);

/// What people type to start the program: the script that started it, otherwise `program`.
std::string typed_program(const std::string& program);

}  // namespace floes
