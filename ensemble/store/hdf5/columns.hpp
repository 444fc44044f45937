#pragma once
// Reading datasets and checking that they are complete. Those of files with digests are; older files may be damaged
// without a trace. Only for sources of rooms with HDF5 files of their own.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "hdf5/damage.hpp"
#include "hdf5/read.hpp"

namespace floes::hdf5 {

inline void check_count(hid_t file, const std::string& name, std::size_t found, std::size_t wanted) {
    if (found != wanted) refuse_damaged(file, fmt::format("{} has {} values where {} belong", name, found, wanted));
}

/// Throws RunError unless there are `count` values.
template <class Value>
std::vector<Value> read_column(hid_t file, const std::string& name, std::size_t count) {
    std::vector<Value> values = read_values<Value>(file, name);
    check_count(file, name, values.size(), count);
    return values;
}

/// Throws RunError unless each value is from `least` to `most`.
template <class Value>
std::vector<Value> read_numbers(hid_t file, const std::string& name, std::size_t count, Value least, Value most) {
    std::vector<Value> values = read_column<Value>(file, name, count);
    for (const Value value : values)
        if (value < least || value > most)
            refuse_damaged(file, fmt::format("{} has the value {}, which there is not", name, value));
    return values;
}

/// The value of a dataset with one text.
inline std::string read_text(hid_t file, const std::string& name) {
    const std::vector<std::string> texts = read_texts(file, name);
    check_count(file, name, texts.size(), 1);
    return texts.front();
}

/// Values of `rows` rows of equal width; none if there are no rows.
template <class Value>
std::vector<Value> read_table(hid_t file, const std::string& name, std::size_t rows, std::size_t& width) {
    std::vector<Value> values = read_values<Value>(file, name);
    width = rows == 0 ? 0 : values.size() / rows;
    check_count(file, name, values.size(), rows * width);
    return values;
}

}  // namespace floes::hdf5
