// The series for ParaView, read again: solids where the frames have them, arrays as they were, nothing written twice.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "core/error.hpp"
#include "draw/xdmf_series.hpp"
#include "hdf5/read.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace xdmf_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// The array of that name.
template <class Value>
std::vector<Value> values(const std::vector<XdmfArray>& arrays, const std::string& name) {
    return std::get<std::vector<Value>>(std::ranges::find(arrays, name, &XdmfArray::name)->values);
}

/// The points of each cell, of which `kinds` says what they are.
std::vector<std::vector<std::int32_t>> cells_of(const XdmfMesh& mesh, std::vector<std::int32_t>* kinds = nullptr) {
    std::vector<std::vector<std::int32_t>> cells;
    for (std::size_t at = 0; at < mesh.cells.size();) {
        const std::int32_t kind = mesh.cells[at++];
        const std::int32_t points = kind == 9 ? 8 : kind == 8 ? 6 : mesh.cells[at++];
        cells.emplace_back(mesh.cells.begin() + static_cast<int>(at),
                           mesh.cells.begin() + static_cast<int>(at) + points);
        at += static_cast<std::size_t>(points);
        if (kinds != nullptr) kinds->push_back(kind);
    }
    EXPECT_EQ(std::ssize(cells), mesh.count);
    return cells;
}

/// Two floes of nine elements, every element turned in its own way, and two contacts.
Frame some_frame(double time) {
    Frame frame;
    frame.step = static_cast<int>(std::lround(50 * time));
    frame.time = time;
    frame.structure.position.x() = 2 + 0.07 * time;
    frame.load = {-30 * time, 5, 2};
    for (int i = 0; i < 18; ++i) {
        BodyState state;
        state.position = {0.5 * i, 0.01 * i, time};
        state.rotation = Quat(1, 0.02 * i, 0.1 * i, -0.03).normalized().toRotationMatrix();
        state.velocity = {0.07, 0, 0.001 * i};
        frame.elements.push_back(state);
        frame.pieces.push_back(i < 9 ? 0 : i < 12 ? 9 : 12);
        frame.utilisation.push_back(i / 20.0);
    }
    frame.contacts = {{3, touches_structure, {1, 2, 3}, {10, 0, 0}, {0, 4, 0}},
                      {5, 9, {4, 5, 6}, {0, 7, 0}, {1, 0, 0}}};
    return frame;
}

IceLayout two_floes(const Scenario& scenario) {
    return IceLayout(floes_at(scenario, std::vector<PlanarPose>(2)));
}

Vec3 point(const std::vector<float>& values, std::int32_t index) {
    const std::size_t at = 3 * static_cast<std::size_t>(index);
    return {values[at], values[at + 1], values[at + 2]};
}

TEST(Xdmf, LevelIceIsBrokenWhereItHasBrokenOff) {
    const XdmfMesh mesh = ice_part(some_frame(0.5), two_floes({}), std::vector<std::uint8_t>{0, 1}, 9);
    for (std::size_t i = 0; i < 18; ++i)
        EXPECT_EQ(values<std::int8_t>(mesh.cell_data, "broken")[i], i < 9 || i >= 12) << i;
}

TEST(Xdmf, IceIsABoxForEachElementWhereTheFrameHasIt) {
    const Frame frame = some_frame(0.5);
    const Scenario scenario;
    const XdmfMesh mesh = ice_part(frame, two_floes(scenario), std::vector<std::uint8_t>{0, 1});
    ASSERT_EQ(mesh.points.size(), 18U * 8 * 3);
    std::vector<std::int32_t> kinds;
    const auto cells = cells_of(mesh, &kinds);
    EXPECT_EQ(kinds, std::vector<std::int32_t>(18, 9));
    const Vec3 half = Vec3(scenario.floe.element, scenario.floe.thickness, scenario.floe.element) / 2;
    for (std::size_t cell = 0; cell < 18; ++cell) {
        const BodyState& element = frame.elements[cell];
        const auto corner = [&](std::size_t i) { return point(mesh.points, cells[cell][i]); };
        int seen = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            const Vec3 own = (element.rotation.transpose() * (corner(i) - element.position)).cwiseQuotient(half);
            EXPECT_LT((own.cwiseAbs() - Vec3::Ones()).norm(), 1e-4) << own.transpose();
            seen |= 1 << ((own.x() > 0) + 2 * (own.y() > 0) + 4 * (own.z() > 0));
        }
        EXPECT_EQ(seen, 0xff);
        // VTK's order: the fifth point stands on the side that the first four turn round, so the volume is positive.
        const double volume = (corner(1) - corner(0)).cross(corner(3) - corner(0)).dot(corner(4) - corner(0));
        EXPECT_NEAR(volume, 8 * half.prod(), 1e-6);
        EXPECT_LT((corner(0) - corner(1) + corner(2) - corner(3)).norm(), 1e-5);
        for (std::size_t i = 1; i < 4; ++i) EXPECT_LT((corner(4 + i) - corner(i) - corner(4) + corner(0)).norm(), 1e-5);
    }
}

TEST(Xdmf, PrismsAreHexahedraAndAWedgeThatFillThem) {
    Scenario scenario;
    scenario.field.floes = 12;
    scenario.shapes.kind = ShapeKind::voronoi;
    const IceLayout layout(floes_of(scenario, {1, 0}));
    Frame frame;
    frame.elements.resize(layout.elements.size(), {.position = {1, 2, 3}});
    frame.pieces.resize(frame.elements.size());
    frame.utilisation.resize(frame.elements.size());
    const XdmfMesh mesh = ice_part(frame, layout, std::vector<std::uint8_t>(12));
    std::vector<std::int32_t> kinds;
    const auto cells = cells_of(mesh, &kinds);
    const auto element = values<std::int32_t>(mesh.cell_data, "element");
    std::size_t cell = 0;
    std::int32_t first = 0;
    for (std::size_t i = 0; i < layout.elements.size(); ++i) {
        const Outline& corners = layout.elements[i].corners;
        double area = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Corner& next = corners[(k + 1) % corners.size()];
            area += (corners[k].x * next.z - next.x * corners[k].z) / 2;
            const auto index = first + static_cast<std::int32_t>(k);
            EXPECT_LT((point(mesh.points, index) - Vec3(1 + corners[k].x, 2 - 0.0165, 3 + corners[k].z)).norm(), 1e-6);
            EXPECT_NEAR(point(mesh.points, index + std::ssize(corners)).y(), 2.0165, 1e-6);
        }
        double filled = 0;
        for (std::size_t sides = 2; sides < corners.size(); ++cell) {
            ASSERT_EQ(element[cell], i);
            const std::size_t half = kinds[cell] == 9 ? 4 : 3;  // points of a face
            // In VTK's order the first face of a hexahedron turns towards the second, that of a wedge away from it.
            const double turn = half == 4 ? 0.5 : -0.5;
            const auto at = [&](std::size_t k) { return point(mesh.points, cells[cell][k]); };
            for (std::size_t k = 1; k + 1 < half; ++k) filled += turn * (at(k) - at(0)).cross(at(k + 1) - at(0)).y();
            for (std::size_t k = 0; k < half; ++k) EXPECT_NEAR((at(half + k) - at(k)).y(), 0.033, 1e-6);
            sides += half - 2;
        }
        EXPECT_NEAR(filled, area, 1e-5 * area);
        first += 2 * static_cast<std::int32_t>(corners.size());
    }
    EXPECT_EQ(cell, cells.size());
    EXPECT_THAT(kinds, testing::AllOf(testing::Contains(8), testing::Contains(9)));
}

TEST(Xdmf, EveryElementCarriesItsNumbers) {
    const Frame frame = some_frame(0.5);
    const XdmfMesh mesh = ice_part(frame, two_floes({}), std::vector<std::uint8_t>{0, 1});
    EXPECT_EQ(values<std::int32_t>(mesh.cell_data, "piece"), frame.pieces);
    const auto velocity = values<float>(mesh.cell_data, "velocity");
    for (std::size_t i = 0; i < 18; ++i) {
        EXPECT_EQ(values<std::int32_t>(mesh.cell_data, "floe")[i], i / 9);
        EXPECT_EQ(values<std::int8_t>(mesh.cell_data, "broken")[i], i / 9);
        EXPECT_FLOAT_EQ(values<float>(mesh.cell_data, "utilisation")[i], static_cast<float>(i) / 20);
        EXPECT_LT((point(velocity, static_cast<int>(i)) - frame.elements[i].velocity).norm(), 1e-8);
    }
}

TEST(Xdmf, ContactsAreVerticesWithForces) {
    const XdmfMesh mesh = contacts_part(some_frame(0.5));
    EXPECT_THAT(mesh.points, ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_THAT(values<float>(mesh.point_data, "normal"), ElementsAre(10, 0, 0, 0, 7, 0));
    EXPECT_THAT(values<float>(mesh.point_data, "friction"), ElementsAre(0, 4, 0, 1, 0, 0));
    EXPECT_THAT(values<float>(mesh.point_data, "force"), ElementsAre(10, 4, 0, 1, 7, 0));
    EXPECT_THAT(values<std::int32_t>(mesh.point_data, "element"), ElementsAre(3, 5));
    EXPECT_THAT(values<std::int32_t>(mesh.point_data, "other"), ElementsAre(touches_structure, 9));
    EXPECT_THAT(mesh.cells, ElementsAre(1, 1, 0, 1, 1, 1));
    EXPECT_EQ(contacts_part({}).count, 0);
}

TEST(Xdmf, TheLoadActsOnTheAxisInThreePartsAndWhole) {
    const XdmfMesh mesh = load_part(some_frame(10));
    EXPECT_THAT(values<float>(mesh.point_data, "force"), ElementsAre(-300, 0, 0, 0, 5, 0, 0, 0, 2, -300, 5, 2));
    EXPECT_THAT(values<std::int32_t>(mesh.point_data, "component"), ElementsAre(0, 1, 2, 3));
    const float axis = 2.7F;
    EXPECT_THAT(mesh.points, ElementsAre(axis, 0, 0, axis, 0, 0, axis, 0, 0, axis, 0, 0));
}

TEST(Xdmf, TheStructureIsClosedAndFacesOutward) {
    const XdmfMesh mesh = structure_part(Shape({{-0.4, 0.3}, {0.2, 0.6}}).mesh(96), {.position = {5, 0, 0}});
    double volume = 0;  // divergence theorem over the triangles of every polygon's fan
    for (const std::vector<std::int32_t>& polygon : cells_of(mesh))
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            volume += point(mesh.points, polygon[0])
                          .dot(point(mesh.points, polygon[i]).cross(point(mesh.points, polygon[i + 1]))) /
                      6;
    const double frustum = std::numbers::pi * 0.6 / 3 * (0.09 + 0.18 + 0.36);
    EXPECT_NEAR(volume, frustum, 0.002 * frustum);  // 96 sides of a circle
    Vec3 lowest = point(mesh.points, 0);
    for (int i = 0; i < std::ssize(mesh.points) / 3; ++i) lowest = lowest.cwiseMin(point(mesh.points, i));
    EXPECT_LT((lowest - Vec3(4.4, -0.4, -0.6)).norm(), 1e-5);
}

TEST(Xdmf, FloesAreBrokenFromTheStepInWhichAJointFails) {
    const std::vector<BreakEvent> breaks{{.time = 0.5, .floe = 1}, {.time = 0.7, .floe = 0}};
    EXPECT_THAT(broken_floes(breaks, 2, 0.48), ElementsAre(0, 0));
    EXPECT_THAT(broken_floes(breaks, 2, 0.5), ElementsAre(0, 1));
    EXPECT_THAT(broken_floes(breaks, 2, 0.9), ElementsAre(1, 1));
}

TEST(Xdmf, ASeriesOfARecordHasEveryPartAtEveryTimeAndNothingTwice) {
    const TemporaryFolder folder;
    RecordingSubject subject;
    subject.scenario.field.floes = 2;
    subject.scenario.elements.form = ElementForm::squares;
    subject.floes = floes_of(subject.scenario);
    {
        RecordingWriter recording(folder / "recording.h5", subject);
        recording.add(some_frame(0.5));
        recording.add(some_frame(1));
        recording.finish({.history = {}, .breaks = {{.time = 0.8, .floe = 1}}});
    }
    const Recording recording(folder / "recording.h5");
    write_xdmf_series(folder / "a & b.xdmf2", recording);

    const std::string list = file_text(folder / "a & b.xdmf2");
    for (const std::string part : {"ice", "structure", "load", "contacts", "ice_sheets"})
        for (const std::string time : {"0.5", "1"})
            EXPECT_THAT(list, HasSubstr(fmt::format(R"(<Grid Name="{}"><Time Value="{}"/>)", part, time)));
    EXPECT_THAT(list, HasSubstr(">a &amp; b.xdmf2.h5:/ice_z_00001<"));

    const hdf5::Handle numbers = hdf5::open_for_reading(folder / "a & b.xdmf2.h5");
    const XdmfMesh ice = ice_part(recording.read(1), recording.layout(), std::vector<std::uint8_t>{0, 1});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        hdf5::RowReader<float> rows(numbers.id(), fmt::format("ice_{}_0000{}", "xyz"[axis], axis / 2));
        const std::span<const float> read = rows.read(0, rows.rows());
        ASSERT_EQ(3 * read.size(), ice.points.size());
        for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i], ice.points[3 * i + axis]);
    }
    EXPECT_EQ(hdf5::read_values<std::int32_t>(numbers.id(), "ice_cells_00000"), ice.cells);
    EXPECT_THAT(hdf5::read_values<std::int8_t>(numbers.id(), "ice_broken_00000"), testing::Each(0));
    EXPECT_EQ(hdf5::read_values<std::int8_t>(numbers.id(), "ice_broken_00001"),
              values<std::int8_t>(ice.cell_data, "broken"));
    for (const std::string same :
         {"ice_cells", "ice_floe", "structure_cells", "structure_y", "structure_z", "ice_sheets_x"}) {
        EXPECT_TRUE(hdf5::exists(numbers.id(), same + "_00000")) << same;
        EXPECT_FALSE(hdf5::exists(numbers.id(), same + "_00001")) << same;
        EXPECT_THAT(list, Not(HasSubstr(same + "_00001")));
    }
    EXPECT_TRUE(hdf5::exists(numbers.id(), "structure_x_00001"));

    const std::string state = file_text(folder / "a & b.py");
    EXPECT_THAT(state, HasSubstr("file = 'a & b.xdmf2'"));
    EXPECT_THAT(state, HasSubstr("time_shown = 1 "));
    // The largest force of all, the load of the second frame, is one and a half radii long.
    EXPECT_THAT(state, HasSubstr(fmt::format("metres_per_newton = {:.4g}", 1.5 * 0.736 / std::hypot(30, 5, 2))));
}

TEST(Xdmf, SaysWhyASeriesCannotBeWritten) {
    const TemporaryFolder folder;
    const RecordingSubject subject;
    EXPECT_THROW(XdmfSeries(folder / "a.xdmf", subject, {}), InputError);
    EXPECT_THROW(XdmfSeries(folder / "nowhere" / "a.xdmf2", subject, {}), RunError);
    std::ofstream(folder / "mine.py") << "import numpy\n";
    EXPECT_THAT(refusal([&] { XdmfSeries(folder / "mine.xdmf2", subject, {}); }),
                HasSubstr("is no state for ParaView"));
    EXPECT_EQ(file_text(folder / "mine.py"), "import numpy\n");
    EXPECT_FALSE(std::filesystem::exists(folder / "mine.xdmf2.h5"));
}

}  // namespace xdmf_test
}  // namespace floes
