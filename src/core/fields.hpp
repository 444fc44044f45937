#pragma once
// Structs as bytes by one list of their fields, which serves both ways:
//
//     struct Hello {
//         int cores = 1;
//         std::string host;
//
//         static constexpr auto fields() { return std::tuple(&Hello::cores, &Hello::host); }
//     };
//
//     put(out, hello);         // to a ByteWriter
//     take(in, hello);         // from a ByteReader; throws RunError as that does
//
// Where the list is not in the struct, its namespace has fields_of(std::type_identity<Hello>). Fields are truth values
// of one byte, int of four, sizes and double of eight, texts, bytes, arrays, vectors and maps with their count before
// them, structs with a list of their own, and what has put_value(out, value) and take_value(in, value) of its own.

#include <array>
#include <concepts>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/bytes.hpp"
#include "core/error.hpp"

namespace floes {

template <class T>
constexpr auto fields_of(std::type_identity<T>) requires requires {
    T::fields();
}
{ return T::fields(); }

template <class T>
concept WithFields = requires {
    fields_of(std::type_identity<T>{});
};

/// The fields of `list`, pointers to data members, in its order.
template <class T, class... Fields>
void put(ByteWriter& out, const T& of, const std::tuple<Fields...>& list) {
    std::apply([&](const auto... field) { (put(out, of.*field), ...); }, list);
}
template <class T, class... Fields>
void take(ByteReader& in, T& of, const std::tuple<Fields...>& list) {
    std::apply([&](const auto... field) { (take(in, of.*field), ...); }, list);
}

template <class T, std::size_t count>
void put_value(ByteWriter& out, const std::array<T, count>& items) {
    for (const T& one : items) put(out, one);
}
template <class T, std::size_t count>
void take_value(ByteReader& in, std::array<T, count>& items) {
    for (T& one : items) take(in, one);
}

template <class T>
void put_value(ByteWriter& out, const std::vector<T>& items) {
    out.u64(items.size());
    for (const T& one : items) put(out, one);
}
/// Grows with what is there, so that a wrong count takes no memory.
template <class T>
void take_value(ByteReader& in, std::vector<T>& items) {
    items.clear();
    for (std::uint64_t left = in.u64(); left > 0; --left) take(in, items.emplace_back());
}

template <class Key, class T>
void put_value(ByteWriter& out, const std::map<Key, T>& items) {
    out.u64(items.size());
    for (const auto& [key, one] : items) put(out, key), put(out, one);
}
template <class Key, class T>
void take_value(ByteReader& in, std::map<Key, T>& items) {
    items.clear();
    Key key{};
    for (std::uint64_t left = in.u64(); left > 0; --left) take(in, key), take(in, items[key]);
}

template <class T>
void put(ByteWriter& out, const T& value) {
    if constexpr (WithFields<T>)
        put(out, value, fields_of(std::type_identity<T>{}));
    else if constexpr (std::same_as<T, bool>)
        out.u8(value ? 1 : 0);
    else if constexpr (std::same_as<T, int>)
        out.i32(value);
    else if constexpr (std::same_as<T, std::uint64_t>)
        out.u64(value);
    else if constexpr (std::same_as<T, double>)
        out.f64(value);
    else if constexpr (std::same_as<T, std::string>)
        out.text(value);
    else if constexpr (std::same_as<T, Bytes>)
        out.blob(value);
    else
        put_value(out, value);
}

template <class T>
void take(ByteReader& in, T& value) {
    if constexpr (WithFields<T>) {
        take(in, value, fields_of(std::type_identity<T>{}));
    } else if constexpr (std::same_as<T, bool>) {
        const std::uint8_t read = in.u8();
        if (read > 1) throw RunError("a stored record says neither yes nor no; it was damaged");
        value = read == 1;
    } else if constexpr (std::same_as<T, int>)
        value = in.i32();
    else if constexpr (std::same_as<T, std::uint64_t>)
        value = in.u64();
    else if constexpr (std::same_as<T, double>)
        value = in.f64();
    else if constexpr (std::same_as<T, std::string>)
        value = in.text();
    else if constexpr (std::same_as<T, Bytes>)
        value = in.blob();
    else
        take_value(in, value);
}

}  // namespace floes
