#pragma once
// What array_output.hpp's list says of each array.

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "member/array_axis.hpp"
#include "member/array_values.hpp"

namespace floes {

/// What the numbers are in a campaign file; everywhere else they are doubles.
enum class ArrayNumbers { real, index, flag };

/// How a campaign file keeps the values of a member.
enum class ArrayChunks {
    with_others,  ///< plain, many members together
    of_its_own    ///< compressed, a chunk a member, which the process that computed it makes
};

struct ArrayOutput {
    std::string_view path;  ///< group and name in the file, and its key in journals; only a name: in journals alone
    std::string_view unit;  ///< in the file
    std::string_view long_name;              ///< in the file and on its page
    std::array<const ArrayAxis*, 2> axes{};  ///< row-major; nullptr after the last
    ArrayAccess access;
    ArrayChunks chunks = ArrayChunks::with_others;
    bool in_table = false;        ///< read with the quantities; others when somebody asks for them
    bool of_arrangement = false;  ///< stored once for all members that begin from the same floes
    ArrayNumbers numbers = ArrayNumbers::real;
    std::span<const char* const> words = {};  ///< of flags, counted from 0

    constexpr std::string_view group() const { return in_file() ? path.substr(0, path.find('/')) : ""; }
    constexpr std::string_view name() const { return path.substr(path.find('/') + 1); }
    constexpr bool in_file() const { return path.find('/') != std::string_view::npos; }
    constexpr bool lies_along(const ArrayAxis& axis) const { return std::ranges::find(axes, &axis) != axes.end(); }
    /// Its axis of that kind; nullptr if it has none.
    constexpr const ArrayAxis* axis_of(AxisKind kind) const {
        for (const ArrayAxis* axis : axes)
            if (axis != nullptr && axis->kind == kind) return axis;
        return nullptr;
    }
};

}  // namespace floes
