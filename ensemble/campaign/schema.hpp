#pragma once
// The JSON Schema of a configuration, for editors and validators, made of the same keys that read it.

#include <string>

namespace floes {

/// Draft 7, which editors know. It says of every key its type, range, default, words, unit and meaning, of a [[case]]
/// and a [[design.axis]] what they take, and which keys name the same thing and exclude each other. What two values say
/// together it cannot say: floes config --check does.
std::string configuration_schema();

}  // namespace floes
