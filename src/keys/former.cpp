#include "keys/former.hpp"

#include <algorithm>
#include <utility>

namespace floes {

Key formerly(std::string_view path, Key key) {
    key.former = path;
    return key;
}

Key instead_of(std::vector<Key> before, Key key) {
    key.before = std::move(before);
    for (Key& old : key.before) old.replaced = true;
    return key;
}

Keys keys_of_digest(Keys keys) {
    Keys old;
    old.reserve(keys.size() + 8);
    for (Key& key : keys) {
        if (key.derived()) continue;
        if (!key.former.empty()) key.path = key.former;
        if (key.before.empty()) old.push_back(std::move(key));
        for (Key& replaced : key.before) old.push_back(std::move(replaced));
    }
    return old;
}

const Key* present_key(std::span<const Key> keys, std::string_view path) {
    if (path.empty() || std::ranges::find(keys, path, &Key::path) != keys.end()) return nullptr;
    const auto stands = [&](const Key& key) { return key.former == path || find_key(key.before, path) != nullptr; };
    const auto found = std::ranges::find_if(keys, stands);
    return found == keys.end() ? nullptr : &*found;
}

}  // namespace floes
