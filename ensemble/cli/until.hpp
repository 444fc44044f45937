#pragma once
// Words for a stop rule: "mooring_force 3 h +- 15 %".

#include <string>
#include <vector>

namespace floes {

/// The most arrangements of a run that ends by such words.
inline constexpr int most_until = 1000;

/// Settings, as --set takes them, of a rule that a text states: a word of design_ofs, for the design value in 3 hours
/// or the time given, or the key of a quantity, for its mean; then the half-width wanted in percent. Throws InputError
/// for what is none of these.
std::vector<std::string> until_settings(const std::string& text);

}  // namespace floes
