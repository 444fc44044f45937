#include "keys/former.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "keys/read.hpp"

namespace floes {
namespace {

/// The key that stands for a path that only 1.0.0 had; none for others.
const Key* present_key(std::span<const Key> keys, std::string_view path) {
    if (path.empty() || std::ranges::find(keys, path, &Key::path) != keys.end()) return nullptr;
    const auto stands = [&](const Key& key) { return key.former == path || find_key(key.before, path) != nullptr; };
    const auto found = std::ranges::find_if(keys, stands);
    return found == keys.end() ? nullptr : &*found;
}

}  // namespace

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

void refuse_former(std::span<const Key> keys, const Entry& entry) {
    const Key* now = present_key(keys, entry.path);
    if (now == nullptr) return;
    std::string value = to_text(entry.value);
    if (now->former.empty()) {
        assign(*find_key(keys, entry.path), entry);  // the present key then shows what was meant
        value = literal(*now);
    }
    throw InputError(fmt::format("{}: {} = {} is a key of floes 1.0.0; write {} = {}", entry.where, entry.path,
                                 to_text(entry.value), now->path, value));
}

void refuse_former(std::span<const Key> keys, const std::string& path, const std::string& where) {
    if (const Key* now = present_key(keys, path))
        throw InputError(fmt::format("{}: {} is a key of floes 1.0.0; write {}", where, path, now->path));
}

}  // namespace floes
