#include "member/result_bytes.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "quantities/quantity.hpp"

namespace floes {
namespace {

std::uint8_t read_below(ByteReader& in, std::uint8_t limit) {
    const std::uint8_t value = in.u8();
    if (value >= limit) throw RunError("a stored member has an unknown state; it was damaged");
    return value;
}

void write_quantities(ByteWriter& out, const MemberOutputs& outputs) {
    out.u32(static_cast<std::uint32_t>(quantities.size()));
    for (const Quantity& one : quantities) {
        out.text(one.key.view());
        out.f64(one.of(outputs));
    }
}

/// Keys unknown to this version are skipped.
void read_quantities(ByteReader& in, MemberOutputs& outputs) {
    outputs = unmeasured(0);
    for (std::uint32_t left = in.u32(); left > 0; --left) {
        const Quantity* known = find_quantity(in.text());
        const double value = in.f64();
        if (known == nullptr) continue;
        if (!known->holds(value)) throw RunError("a stored member has a count beyond all counts; it was damaged");
        known->place.set(outputs, value);
    }
}

}  // namespace

void write(ByteWriter& out, const MemberResult& result) {
    out.u8(static_cast<std::uint8_t>(result.status));
    out.text(result.reason);
    write_quantities(out, result);
    out.u8(result.load.steady ? 1 : 0);
    out.f64(result.wall_time);
    out.f64(result.cpu_time);
}

MemberResult read_outcome(ByteReader& in) {
    MemberResult result;
    result.status = static_cast<MemberStatus>(read_below(in, 2));
    result.reason = in.text();
    read_quantities(in, result);
    result.load.steady = read_below(in, 2) == 1;
    return result;
}

MemberResult read_member_result(ByteReader& in) {
    MemberResult result = read_outcome(in);
    result.wall_time = in.f64();
    result.cpu_time = in.f64();
    return result;
}

void write_arrays(ByteWriter& out, const MemberResult& result) {
    for (const ArrayOutput& one : array_outputs) {
        const ArrayValues array = one.access.get(result);
        if (array.empty()) continue;
        out.text(one.path);
        out.u8(static_cast<std::uint8_t>(array.sizes.size()));
        for (const std::size_t size : array.sizes) out.u64(size);
        out.doubles(array.values);
    }
    out.text("");
}

void read_arrays(ByteReader& in, MemberResult& result) {
    for (std::string path = in.text(); !path.empty(); path = in.text()) {
        ArrayValues array;
        array.sizes.resize(in.u8());
        for (std::size_t& size : array.sizes) size = in.u64();
        array.values = in.doubles();
        const std::size_t number = array_number(path);
        if (number == array_outputs.size()) continue;
        check_sizes(array_outputs[number], array.sizes, array.values.size());
        array_outputs[number].access.set(result, array);
    }
}

void check_sizes(const ArrayOutput& array, std::span<const std::size_t> sizes, std::uint64_t values) {
    static const Scenario any;  // fixed axes are the same in all
    std::size_t axes = 0;
    std::uint64_t product = 1;
    bool right = true;
    for (const ArrayAxis* axis : array.axes) {
        if (axis == nullptr) break;
        if (axes >= sizes.size()) break;
        const std::size_t size = sizes[axes++];
        right = right && (axis->kind != AxisKind::fixed || size == axis->places(any).size()) && size <= values;
        product *= size;
    }
    const auto wanted =
        static_cast<std::size_t>(std::ranges::count_if(array.axes, [](const auto* one) { return one != nullptr; }));
    if (!right || axes != wanted || sizes.size() != wanted || product != values)
        throw RunError(fmt::format("a stored member has {} with sizes that do not fit; it was damaged", array.path));
}

}  // namespace floes
