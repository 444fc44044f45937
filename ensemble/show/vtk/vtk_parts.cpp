#include "vtk/vtk_parts.hpp"

#include <utility>

namespace floes {
namespace {

void append(std::vector<float>& values, const Vec3& vector) {
    for (const double value : vector) values.push_back(static_cast<float>(value));
}

void append_box(VtkMesh& mesh, const Vec3& centre, const Mat3& rotation, const Vec3& half_extents) {
    // In VTK's order: round the lower face, then round the upper one above it.
    for (const double y : {-1.0, 1.0})
        for (const Vec2& corner : {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1)})
            append(mesh.points, centre + rotation * half_extents.cwiseProduct(Vec3(corner.x(), y, corner.y())));
    for (int i = 0; i < 8; ++i) mesh.connectivity.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
    mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
}

/// Round the lower face, then round the upper one.
void append_prism(VtkMesh& mesh, const BodyState& state, const IceLayout::LaidElement& element) {
    for (const double y : {-1.0, 1.0})
        for (const Corner& corner : element.corners)
            append(mesh.points,
                   state.position + state.rotation * Vec3(corner.x, y * element.half_extents.y(), corner.z));
    for (std::size_t i = 0; i < 2 * element.corners.size(); ++i)
        mesh.connectivity.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
    mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
}

/// The mesh of these points, a vertex at each.
VtkMesh vertices(std::vector<float> points) {
    VtkMesh mesh{.kind = VtkCells::points, .points = std::move(points)};
    for (std::size_t i = 0; i < mesh.points.size() / 3; ++i) {
        mesh.connectivity.push_back(static_cast<std::int32_t>(i));
        mesh.offsets.push_back(static_cast<std::int32_t>(i + 1));
    }
    return mesh;
}

template <class Items, class Read>
std::vector<float> vectors(const Items& items, Read read) {
    std::vector<float> values;
    values.reserve(3 * items.size());
    for (const auto& item : items) append(values, read(item));
    return values;
}

}  // namespace

VtkMesh ice_part(const Frame& frame, const IceLayout& layout, std::span<const std::uint8_t> broken) {
    const std::size_t elements = frame.elements.size();
    VtkMesh mesh{.kind = VtkCells::hexahedra};
    mesh.points.reserve(24 * elements);
    std::vector<std::int32_t> floe(elements);
    std::vector<std::uint8_t> is_broken(elements);
    for (std::size_t i = 0; i < elements; ++i) {
        const IceLayout::LaidElement& one = layout.elements[frame.id(i)];
        if (one.corners.empty()) {
            append_box(mesh, frame.elements[i].position, frame.elements[i].rotation, one.half_extents);
        } else {
            mesh.kind = VtkCells::solids;
            append_prism(mesh, frame.elements[i], one);
        }
        floe[i] = one.floe;
        is_broken[i] = broken[static_cast<std::size_t>(floe[i])];
    }
    mesh.cell_data = {
        vtk_array("floe", floe), vtk_array("piece", frame.pieces), vtk_array("broken", is_broken),
        vtk_array("utilisation", std::vector<float>(frame.utilisation.begin(), frame.utilisation.end())),
        vtk_array("velocity", vectors(frame.elements, [](const BodyState& one) { return one.velocity; }), 3)};
    if (!frame.ids.empty()) mesh.cell_data.push_back(vtk_array("element", frame.ids));
    return mesh;
}

VtkMesh contacts_part(const Frame& frame) {
    const auto read = [&](auto of) { return vectors(frame.contacts, of); };
    std::vector<std::int32_t> element;
    std::vector<std::int32_t> other;
    for (const FrameContact& contact : frame.contacts) {
        element.push_back(contact.element);
        other.push_back(contact.other);
    }
    VtkMesh mesh = vertices(read([](const FrameContact& one) { return one.point; }));
    mesh.point_data = {
        vtk_array("normal", read([](const FrameContact& one) { return one.normal; }), 3),
        vtk_array("friction", read([](const FrameContact& one) { return one.friction; }), 3),
        vtk_array("force", read([](const FrameContact& one) -> Vec3 { return one.normal + one.friction; }), 3),
        vtk_array("element", element), vtk_array("other", other)};
    return mesh;
}

VtkMesh load_part(const Frame& frame) {
    std::vector<float> force;
    for (int i = 0; i < 3; ++i) append(force, frame.load[i] * Vec3::Unit(i));
    append(force, frame.load);
    std::vector<float> points;
    for (int i = 0; i < 4; ++i) append(points, {frame.structure.x, 0, frame.structure.z});
    VtkMesh mesh = vertices(std::move(points));
    mesh.point_data = {vtk_array("force", force, 3), vtk_array("component", std::vector<std::int32_t>{0, 1, 2, 3})};
    return mesh;
}

VtkMesh moorings_part(const Frame& frame) {
    VtkMesh mesh{.kind = VtkCells::lines};
    std::vector<float> tension;
    std::vector<std::int32_t> number;
    for (const FrameLine& line : frame.lines) {
        for (const Vec3& end : {line.fairlead, line.anchor}) {
            append(mesh.points, end);
            mesh.connectivity.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
        }
        mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
        tension.push_back(static_cast<float>(line.tension));
        number.push_back(line.line);
    }
    mesh.cell_data = {vtk_array("tension", tension), vtk_array("line", number)};
    return mesh;
}

VtkMesh structure_part(const Shape& shape, const PlanarPose& pose) {
    const SurfaceMesh surface = shape.mesh(96);
    VtkMesh mesh{.kind = VtkCells::polygons};
    const Mat3 turn = Eigen::AngleAxisd(pose.yaw, Vec3::UnitY()).toRotationMatrix();
    for (const Vec3& point : surface.points) append(mesh.points, Vec3(pose.x, 0, pose.z) + turn * point);
    for (const std::vector<int>& polygon : surface.polygons) {
        mesh.connectivity.insert(mesh.connectivity.end(), polygon.begin(), polygon.end());
        mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
    }
    return mesh;
}

VtkMesh ice_sheets_part(const Channel& channel) {
    VtkMesh mesh{.kind = VtkCells::hexahedra};
    for (const IceSheet& sheet : channel.sheets) append_box(mesh, sheet.centre, Mat3::Identity(), sheet.half_extents);
    return mesh;
}

}  // namespace floes
