#pragma once
// The values of one array of one member, and how they are taken out of its result and put back.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/error.hpp"
#include "member/result.hpp"

namespace floes {

/// Row-major; as many values as the sizes multiply to. Without values: the member does not have the array.
struct ArrayValues {
    std::vector<std::size_t> sizes;  ///< one for each axis
    std::vector<double> values;

    bool empty() const { return values.empty(); }
};

struct ArrayAccess {
    ArrayValues (*get)(const MemberResult&);
    /// The array must have as many sizes as the list gives it axes. Throws RunError for what the field cannot hold.
    void (*set)(MemberResult&, const ArrayValues&);
};

/// Of a field that holds fewer numbers than doubles: throws RunError for those that it cannot.
template <class Field>
Field as_field(double value) {
    if constexpr (std::is_same_v<Field, double>) {
        return value;
    } else {
        using Number = std::conditional_t<std::is_enum_v<Field>, std::int8_t, Field>;
        double most = std::numeric_limits<Number>::max();
        if constexpr (std::is_same_v<Field, FailureMode>) most = failure_mode_names.size() - 1;
        if (!(value >= 0 && value <= most && value == std::floor(value)))
            throw RunError("a stored member has a number that there is not; it was damaged");
        return static_cast<Field>(static_cast<Number>(value));
    }
}

/// A vector of numbers along one axis, reached by a chain of data members.
template <auto... Path>
constexpr ArrayAccess at_vector() {
    return {[](const MemberResult& result) {
                const std::vector<double>& field = (result.*....*Path);
                return ArrayValues{{field.size()}, field};
            },
            [](MemberResult& result, const ArrayValues& array) { (result.*....*Path) = array.values; }};
}

/// A vector of numbers along two fixed axes, with as many places as these have.
template <std::size_t rows, std::size_t columns, auto... Path>
constexpr ArrayAccess at_table() {
    ArrayAccess access = at_vector<Path...>();
    access.get = [](const MemberResult& result) {
        const std::vector<double>& field = (result.*....*Path);
        return ArrayValues{{rows, columns}, field};
    };
    return access;
}

/// One number of each element of a vector.
template <auto Elements, auto Number>
constexpr ArrayAccess at_each() {
    return {[](const MemberResult& result) {
                ArrayValues array{{(result.*Elements).size()}, {}};
                for (const auto& one : result.*Elements) array.values.push_back(static_cast<double>(one.*Number));
                return array;
            },
            [](MemberResult& result, const ArrayValues& array) {
                auto& elements = result.*Elements;
                elements.resize(array.values.size());
                for (std::size_t k = 0; k < elements.size(); ++k)
                    elements[k].*Number =
                        as_field<std::remove_reference_t<decltype(elements[k].*Number)>>(array.values[k]);
            }};
}

/// A vector of numbers in each element of a vector; shorter ones are filled up with NaN, which is left out again.
template <auto Elements, auto Numbers>
constexpr ArrayAccess at_rows() {
    return {[](const MemberResult& result) {
                std::size_t width = 0;
                for (const auto& one : result.*Elements) width = std::max(width, (one.*Numbers).size());
                ArrayValues array{{(result.*Elements).size(), width}, {}};
                for (const auto& one : result.*Elements) {
                    array.values.insert(array.values.end(), (one.*Numbers).begin(), (one.*Numbers).end());
                    array.values.insert(array.values.end(), width - (one.*Numbers).size(),
                                        std::numeric_limits<double>::quiet_NaN());
                }
                return array;
            },
            [](MemberResult& result, const ArrayValues& array) {
                auto& elements = result.*Elements;
                elements.resize(array.sizes.at(0));
                for (std::size_t k = 0; k < elements.size(); ++k) {
                    const auto first = array.values.begin() + static_cast<std::ptrdiff_t>(k * array.sizes.at(1));
                    auto last = first + static_cast<std::ptrdiff_t>(array.sizes.at(1));
                    while (last != first && std::isnan(*(last - 1))) --last;
                    (elements[k].*Numbers).assign(first, last);
                }
            }};
}

/// Poses as rows of x, z and yaw.
template <auto Poses>
constexpr ArrayAccess at_poses() {
    return {[](const MemberResult& result) {
                ArrayValues array{{(result.*Poses).size(), 3}, {}};
                for (const PlanarPose& pose : result.*Poses)
                    array.values.insert(array.values.end(), {pose.x, pose.z, pose.yaw});
                return array;
            },
            [](MemberResult& result, const ArrayValues& array) {
                (result.*Poses).clear();
                for (std::size_t k = 0; k + 2 < array.values.size(); k += 3)
                    (result.*Poses).push_back({array.values[k], array.values[k + 1], array.values[k + 2]});
            }};
}

/// Rows of as many numbers as the second axis has places, one after another.
template <std::size_t columns, auto... Path>
constexpr ArrayAccess at_row_list() {
    ArrayAccess access = at_vector<Path...>();
    access.get = [](const MemberResult& result) {
        const std::vector<double>& field = (result.*....*Path);
        return ArrayValues{{field.size() / columns, columns}, field};
    };
    return access;
}

/// A single number, which has no axis.
template <auto Number>
constexpr ArrayAccess at_number() {
    return {[](const MemberResult& result) {
                return ArrayValues{{}, {result.*Number}};
            },
            [](MemberResult& result, const ArrayValues& array) { result.*Number = array.values.at(0); }};
}

}  // namespace floes
