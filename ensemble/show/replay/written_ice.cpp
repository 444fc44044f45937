#include "replay/written_ice.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace floes {
namespace {

using hdf5::Handle;
using hdf5::Scale;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Corners of elements that are polygons, NaN where an element has fewer.
void write_corners(hid_t group, const IceLayout& layout, const Scale& element) {
    std::size_t most = 0;
    for (const IceLayout::LaidElement& one : layout.elements) most = std::max(most, one.corners.size());
    if (most == 0) return;
    std::vector<double> x(most * layout.elements.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<double> z = x;
    for (std::size_t i = 0; i < layout.elements.size(); ++i) {
        const Outline& corners = layout.elements[i].corners;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            x[most * i + k] = corners[k].x;
            z[most * i + k] = corners[k].z;
        }
    }
    const Scale corner = hdf5::write_index_scale(group, "corner", "corner of an element, in order", most);
    hdf5::write_values(group, {"corner_x", "m", "of an element's corners, in its own axes"}, {element, corner}, x);
    hdf5::write_values(group, {"corner_z", "m", "of an element's corners, in its own axes"}, {element, corner}, z);
}

}  // namespace

Scale element_scale(hid_t file, const IceLayout& layout) {
    return hdf5::write_index_scale(file, "element", "element, floe by floe", layout.elements.size());
}

void write_ice(hid_t file, const FloeShape& usual, const IceLayout& layout, const RecordScales& scales) {
    const Scale& element = scales.element.value();
    std::vector<std::int32_t> floe;
    std::vector<double> sides;
    for (const IceLayout::LaidElement& one : layout.elements) {
        floe.push_back(one.floe);
        for (const double half : one.half_extents) sides.push_back(2 * half);
    }
    const Handle group = hdf5::create_group(file, "ice");
    hdf5::write_attribute(group.id(), "element_side", usual.element);
    hdf5::write_attribute(group.id(), "thickness", usual.thickness);
    hdf5::write_values(group.id(), {"floe", "1", "floe of each element"}, {element}, floe);
    hdf5::write_values(group.id(), {"sides", "m", "length of an element's sides along its own axes"},
                       {element, scales.coordinate}, sides);
    write_corners(group.id(), layout, element);
}

void write_floes(hid_t file, const FloeSet& floes, const std::vector<int>& numbers) {
    const Handle group = hdf5::create_group(file, "floes");
    const Scale floe =
        hdf5::write_index_scale(group.id(), "floe", "floe that frames show, in the order of entry", floes.size());
    const auto write = [&](const char* name, const char* text, auto of) {
        std::vector<double> values;
        for (std::size_t i = 0; i < floes.size(); ++i) values.push_back(of(floes.shape(i)));
        hdf5::write_values(group.id(), {name, "m", text}, {floe}, values);
    };
    hdf5::write_values(group.id(), {"number", "1", "the how-manieth to enter, from 0, as the breaks have it"}, {floe},
                       std::vector<std::int32_t>(numbers.begin(), numbers.end()));
    write("length", "extent along the floe's own x", [](const FloeShape& one) { return one.length; });
    write("breadth", "extent along its own z", [](const FloeShape& one) { return one.breadth; });
    write("thickness", "thickness", [](const FloeShape& one) { return one.thickness; });
    write("element", "side of its elements", [](const FloeShape& one) { return one.element; });
    std::size_t most = 0;
    for (std::size_t i = 0; i < floes.size(); ++i) most = std::max(most, floes.shape(i).outline.size());
    if (most == 0) return;
    std::vector<double> x(most * floes.size(), missing);
    std::vector<double> z = x;
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const Outline& outline = floes.shape(i).outline;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            x[most * i + k] = outline[k].x;
            z[most * i + k] = outline[k].z;
        }
    }
    const Scale corner = hdf5::write_index_scale(group.id(), "corner", "corner of a floe, in order", most);
    hdf5::write_values(group.id(), {"corner_x", "m", "of a floe's corners, in its own axes"}, {floe, corner}, x);
    hdf5::write_values(group.id(), {"corner_z", "m", "of a floe's corners, in its own axes"}, {floe, corner}, z);
}

void write_joints(hid_t file, const IceLayout& layout, const std::vector<BreakEvent>& breaks) {
    const std::vector<IceLayout::LaidJoint>& joints = layout.joints;
    std::vector<std::int32_t> a;
    std::vector<std::int32_t> b;
    for (const IceLayout::LaidJoint& joint : joints) {
        a.push_back(joint.a);
        b.push_back(joint.b);
    }
    std::vector<double> time(joints.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<std::int8_t> mode(joints.size(), -1);
    for (const BreakEvent& event : breaks) {
        const std::size_t joint = layout.joint(event.floe, event.joint);
        time[joint] = event.time;
        mode[joint] = static_cast<std::int8_t>(event.mode);
    }
    const Handle group = hdf5::create_group(file, "joints");
    const Scale joint = hdf5::write_index_scale(file, "joint", "joint, floe by floe", joints.size());
    hdf5::write_values(group.id(), {"a", "1", "element that the joint connects with b"}, {joint}, a);
    hdf5::write_values(group.id(), {"b", "1", "element that the joint connects with a"}, {joint}, b);
    hdf5::write_values(group.id(), {"failure_time", "s", "when it failed; NaN: it did not"}, {joint}, time);
    hdf5::write_values(group.id(), {"failure_mode", "1", "how it failed"}, {joint}, mode,
                       hdf5::flags_of(failure_mode_names, std::int8_t{-1}));
}

}  // namespace floes
