// The files for ParaView, decoded again: boxes where the frames have them, arrays as they were, every file listed.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "draw/vtk_reader.hpp"
#include "draw/vtk_series.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace vtk_test {

using testing::ElementsAre;
using testing::HasSubstr;

class Vtk : public testing::Test {
  protected:
    VtkReader written(const VtkMesh& mesh) const {
        write_vtk(folder / "one", mesh, 1.5);
        return VtkReader(folder / "one");
    }

    const TemporaryFolder folder;
};

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

Vec3 point(const std::vector<float>& values, std::size_t index) {
    return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

TEST_F(Vtk, IceIsABoxForEachElementWhereTheFrameHasIt) {
    const Frame frame = some_frame(0.5);
    const Scenario scenario;
    const VtkReader file = written(ice_part(frame, two_floes(scenario), std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(file.number("NumberOfPoints"), 18 * 8);
    EXPECT_EQ(file.number("NumberOfCells"), 18);
    const auto points = file.values<float>("Points");
    const auto connectivity = file.values<std::int32_t>("connectivity");
    const auto offsets = file.values<std::int32_t>("offsets");
    ASSERT_EQ(points.size(), 18U * 8 * 3);
    const Vec3 half = Vec3(scenario.floe.element, scenario.floe.thickness, scenario.floe.element) / 2;
    for (std::size_t cell = 0; cell < 18; ++cell) {
        ASSERT_EQ(offsets[cell], 8 * static_cast<int>(cell + 1));
        const BodyState& element = frame.elements[cell];
        const auto corner = [&](std::size_t i) { return point(points, connectivity[8 * cell + i]); };
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
    EXPECT_EQ(file.values<std::uint8_t>("types"), std::vector<std::uint8_t>(18, 12));
}

TEST_F(Vtk, PolygonsAreSolidsOfTheirCorners) {
    Scenario scenario;
    scenario.field.floes = 12;
    scenario.shapes.kind = ShapeKind::voronoi;
    const IceLayout layout(floes_of(scenario, {1, 0}));
    Frame frame;
    frame.elements.resize(layout.elements.size(), {.position = {1, 2, 3}});
    frame.pieces.resize(frame.elements.size());
    frame.utilisation.resize(frame.elements.size());
    const VtkReader file = written(ice_part(frame, layout, std::vector<std::uint8_t>(12)));
    const auto points = file.values<float>("Points");
    const auto offsets = file.values<std::int32_t>("offsets");
    const auto types = file.values<std::uint8_t>("types");
    std::size_t first = 0;
    bool unlike_boxes = false;
    for (std::size_t i = 0; i < layout.elements.size(); ++i) {
        const Outline& corners = layout.elements[i].corners;
        ASSERT_EQ(static_cast<std::size_t>(offsets[i]), first + 2 * corners.size());
        EXPECT_EQ(types[i], corners.size() == 4 ? 12 : 41);
        unlike_boxes |= corners.size() != 4;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            EXPECT_LT((point(points, first + k) - Vec3(1 + corners[k].x, 2 - 0.0165, 3 + corners[k].z)).norm(), 1e-6);
            EXPECT_NEAR(point(points, first + corners.size() + k).y(), 2.0165, 1e-6);
        }
        first += 2 * corners.size();
    }
    EXPECT_TRUE(unlike_boxes);
}

TEST_F(Vtk, EveryElementCarriesItsNumbers) {
    const Frame frame = some_frame(0.5);
    const VtkReader file = written(ice_part(frame, two_floes({}), std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(file.values<std::int32_t>("piece"), frame.pieces);
    const auto floe = file.values<std::int32_t>("floe");
    const auto broken = file.values<std::uint8_t>("broken");
    const auto utilisation = file.values<float>("utilisation");
    const auto velocity = file.values<float>("velocity");
    for (std::size_t i = 0; i < 18; ++i) {
        EXPECT_EQ(floe[i], i / 9);
        EXPECT_EQ(broken[i], i / 9);
        EXPECT_FLOAT_EQ(utilisation[i], static_cast<float>(i) / 20);
        EXPECT_LT((point(velocity, i) - frame.elements[i].velocity).norm(), 1e-8);
    }
    EXPECT_EQ(file.type("broken"), "UInt8");
    EXPECT_EQ(file.type("floe"), "Int32");
    EXPECT_EQ(file.type("velocity"), "Float32");
}

TEST_F(Vtk, ContactsAreVerticesWithForces) {
    const VtkReader file = written(contacts_part(some_frame(0.5)));
    EXPECT_EQ(file.number("NumberOfVerts"), 2);
    EXPECT_THAT(file.values<float>("Points"), ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_THAT(file.values<float>("normal"), ElementsAre(10, 0, 0, 0, 7, 0));
    EXPECT_THAT(file.values<float>("friction"), ElementsAre(0, 4, 0, 1, 0, 0));
    EXPECT_THAT(file.values<float>("force"), ElementsAre(10, 4, 0, 1, 7, 0));
    EXPECT_THAT(file.values<std::int32_t>("element"), ElementsAre(3, 5));
    EXPECT_THAT(file.values<std::int32_t>("other"), ElementsAre(touches_structure, 9));
    EXPECT_THAT(file.values<std::int32_t>("connectivity"), ElementsAre(0, 1));
    EXPECT_THAT(file.values<std::int32_t>("offsets"), ElementsAre(1, 2));
}

TEST_F(Vtk, AFrameWithoutContactsHasNone) {
    const VtkReader file = written(contacts_part({}));
    EXPECT_EQ(file.number("NumberOfPoints"), 0);
    EXPECT_THAT(file.values<float>("normal"), ElementsAre());
}

TEST_F(Vtk, TheLoadActsOnTheAxisInThreePartsAndWhole) {
    const VtkReader file = written(load_part(some_frame(10)));
    EXPECT_THAT(file.values<float>("force"), ElementsAre(-300, 0, 0, 0, 5, 0, 0, 0, 2, -300, 5, 2));
    EXPECT_THAT(file.values<std::int32_t>("component"), ElementsAre(0, 1, 2, 3));
    const float axis = 2.7F;
    EXPECT_THAT(file.values<float>("Points"), ElementsAre(axis, 0, 0, axis, 0, 0, axis, 0, 0, axis, 0, 0));
}

TEST_F(Vtk, TheStructureIsClosedAndFacesOutward) {
    const VtkReader file = written(structure_part(Shape({{-0.4, 0.3}, {0.2, 0.6}}), {.position = {5, 0, 0}}));
    const auto points = file.values<float>("Points");
    const auto connectivity = file.values<std::int32_t>("connectivity");
    double volume = 0;  // divergence theorem over the triangles of every polygon's fan
    std::int32_t begin = 0;
    for (const std::int32_t end : file.values<std::int32_t>("offsets")) {
        for (std::int32_t i = begin + 1; i + 1 < end; ++i)
            volume += point(points, connectivity[begin])
                          .dot(point(points, connectivity[i]).cross(point(points, connectivity[i + 1]))) /
                      6;
        begin = end;
    }
    const double frustum = std::numbers::pi * 0.6 / 3 * (0.09 + 0.18 + 0.36);
    EXPECT_NEAR(volume, frustum, 0.002 * frustum);  // 96 sides of a circle
    Vec3 lowest = point(points, 0);
    for (std::size_t i = 0; i < points.size() / 3; ++i) lowest = lowest.cwiseMin(point(points, i));
    EXPECT_LT((lowest - Vec3(4.4, -0.4, -0.6)).norm(), 1e-5);
}

TEST_F(Vtk, FloesAreBrokenFromTheStepInWhichAJointFails) {
    const std::vector<BreakEvent> breaks{{.time = 0.5, .floe = 1}, {.time = 0.7, .floe = 0}};
    EXPECT_THAT(broken_floes(breaks, 2, 0.48), ElementsAre(0, 0));
    EXPECT_THAT(broken_floes(breaks, 2, 0.5), ElementsAre(0, 1));
    EXPECT_THAT(broken_floes(breaks, 2, 0.9), ElementsAre(1, 1));
}

TEST_F(Vtk, ASeriesOfARecordHasEveryPartAtEveryTime) {
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
    write_vtk_series(folder / "a & b.pvd", recording);

    const std::string list = text_of(folder / "a & b.pvd");
    for (const std::string part : {"ice", "structure", "load", "contacts", "ice_sheets"})
        for (const std::string time : {"0.5", "1"})
            EXPECT_THAT(list, testing::ContainsRegex("timestep=\"" + time + "\"[^/]*name=\"" + part + "\""));
    const std::regex name("file=\"a &amp; b/([^\"]*)\"");
    int listed = 0;
    for (std::sregex_iterator at(list.begin(), list.end(), name); at != std::sregex_iterator(); ++at, ++listed)
        EXPECT_TRUE(std::filesystem::exists(folder / "a & b" / (*at)[1].str())) << (*at)[1];
    EXPECT_EQ(listed, 10);

    const VtkReader second(folder / "a & b" / "ice_00001.vtu");
    EXPECT_EQ(second.values<float>("Points"),
              ice_part(recording.read(1), recording.layout(), std::vector<std::uint8_t>{0, 1}).points);
    EXPECT_THAT(second.values<std::uint8_t>("broken"), testing::Contains(1).Times(9));
    EXPECT_THAT(VtkReader(folder / "a & b" / "ice_00000.vtu").values<std::uint8_t>("broken"), testing::Each(0));
    EXPECT_THAT(text_of(folder / "a & b" / "ice_00001.vtu"), HasSubstr(">1</DataArray></FieldData>"));

    const std::string state = text_of(folder / "a & b.py");
    EXPECT_THAT(state, HasSubstr("collection = 'a & b.pvd'"));
    EXPECT_THAT(state, HasSubstr("time_shown = 1 "));
    // The largest force of all, the load of the second frame, is one and a half radii long.
    EXPECT_THAT(state, HasSubstr(fmt::format("metres_per_newton = {:.4g}", 1.5 * 0.736 / std::hypot(30, 5, 2))));
}

TEST_F(Vtk, SaysWhyASeriesCannotBeWritten) {
    const RecordingSubject subject;
    EXPECT_THROW(VtkSeries(folder / "a.vtk", subject, {}), InputError);
    std::ofstream(folder / "file") << "no folder";
    EXPECT_THROW(VtkSeries(folder / "file" / "a.pvd", subject, {}), RunError);
    EXPECT_THROW(write_vtk(folder / "nowhere" / "a.vtp", {}, 0), RunError);
}

}  // namespace vtk_test
}  // namespace floes
