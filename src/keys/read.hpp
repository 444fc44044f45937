#pragma once
// From entries of a document to the fields that keys bind.

#include <span>
#include <string>

#include "keys/key.hpp"

namespace floes {

/// Sets the key's field. Throws InputError, one sentence: where, key, value, what is wrong with it, what is allowed.
void assign(const Key& key, const Entry& entry);

/// Finds the entry's key and sets its field. Returns the path of that key, or "" for a known table without keys ([ice]
/// and nothing below it). Throws InputError as assign() does, and for an unknown key, naming the nearest known one.
std::string assign_known(std::span<const Key> keys, const Entry& entry);

}  // namespace floes
