#pragma once
// Keys of floes 1.0.0 that have another path now, or were replaced.
//
// Digests are made of the paths and values that keys had in 1.0.0, so that members keep theirs. Texts that floes stored
// may have either spelling; texts of users have the present one.

#include <span>
#include <string_view>
#include <vector>

#include "keys/key.hpp"

namespace floes {

/// A key that had the path `path` in 1.0.0.
Key formerly(std::string_view path, Key key);

/// A key that replaced `before`, several keys of 1.0.0, which are bound to the fields that `key` sets. One of them may
/// have the path of `key`.
Key instead_of(std::vector<Key> before, Key key);

/// The keys with the paths and forms of 1.0.0, without derived ones: what digests are made of.
Keys keys_of_digest(Keys keys);

/// The key that stands for a path that only 1.0.0 had; none for other paths.
const Key* present_key(std::span<const Key> keys, std::string_view path);

}  // namespace floes
