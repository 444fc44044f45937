#pragma once
// From entries of a document to the fields that keys bind.

#include <span>
#include <string>

#include "keys/key.hpp"

namespace floes {

/// Sets the key's field. Throws InputError, one sentence: where, key, value, what is wrong with it, what is allowed.
void assign(const Key& key, const Entry& entry);

/// Throws InputError if the entry's path is one of 1.0.0 only: the sentence says what to write instead.
void refuse_former(std::span<const Key> keys, const Entry& entry);

/// The same for a path without a value, such as that of an axis; `where` begins the sentence.
void refuse_former(std::span<const Key> keys, const std::string& path, const std::string& where);

/// Finds the entry's key and sets its field. Returns the path of that key, or "" for a known table without keys ([ice]
/// and nothing below it). Throws InputError as assign() does, for an unknown key, naming the nearest known one, and for
/// one of 1.0.0, naming the one that replaced it.
std::string assign_known(std::span<const Key> keys, const Entry& entry);

}  // namespace floes
