// Hulls whose files are written otherwise are the same hulls, and files that lost something are refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "campaign/drawn.hpp"
#include "campaign/hull_file.hpp"
#include "core/error.hpp"
#include "readers/example.hpp"
#include "shapes/hydrostatics.hpp"
#include "support/refusal.hpp"
#include "support/written_otherwise.hpp"

namespace floes {
namespace hull_changes_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using Solids = std::vector<std::pair<std::string, std::vector<Triangle3>>>;

Structure taken(const std::string& bytes, const std::string& name, const HullFile& file = {}) {
    Structure structure;
    structure.hull_file = file;
    take_hull(structure, bytes, name);
    structure.shape.set_kind(HullKind::file);
    return structure;
}

/// What the hull is to a naval architect.
std::vector<double> numbers_of(const Structure& structure) {
    EXPECT_FALSE(structure.shape.fault());
    const Hydrostatics found = hydrostatics(structure.shape);
    return {structure.hull_file.volume, structure.shape.volume(), found.volume,
            found.buoyancy.x(),         found.buoyancy.y(),       found.buoyancy.z(),
            found.waterplane,           found.about_length,       found.about_breadth,
            structure.shape.top(),      structure.shape.draught()};
}

void expect_same(const Structure& one, const Structure& other, const std::string& what) {
    const std::vector<double> a = numbers_of(one);
    const std::vector<double> b = numbers_of(other);
    for (std::size_t k = 0; k < a.size(); ++k)
        EXPECT_NEAR(a[k], b[k], 1e-8 * std::max(1.0, std::abs(a[k]))) << what << ", number " << k;
    EXPECT_EQ(one.shape.piece_rows().size(), other.shape.piece_rows().size()) << what;
}

/// An L of 5000 m³, 10 m high, and a leg beside it.
std::vector<Triangle3> l_prism() {
    return prism({{0, 0}, {30.5, 0}, {30.5, 10}, {10, 10}, {10, 29.5}, {0, 29.5}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}, 10.25);
}
const double l_volume = (30.5 * 10 + 10 * 19.5) * 10.25;

Solids l_and_leg() {
    return {{"the l", l_prism()}, {"leg", box({20, 20, 0.5}, {25, 26, 9.75})}};
}

const HullFile in_water{.path = "", .waterline = 5};

Solids each(Solids solids, const std::function<Vec3(const Vec3&)>& move) {
    for (auto& [name, triangles] : solids)
        for (Triangle3& one : triangles)
            for (Vec3& corner : one) corner = move(corner);
    return solids;
}

void turn_over(std::vector<Triangle3>& triangles) {
    for (Triangle3& one : triangles) std::swap(one[1], one[2]);
}

std::string message(const Solids& solids) {
    return refusal([&] { static_cast<void>(taken(stl_text(solids), "x.stl", in_water)); });
}

// tests/readers has the changes that all texts have in common.
TEST(HullChanges, TextsThatAreWrittenOtherwiseAreTheSameHull) {
    const Structure plain = taken(stl_text(l_and_leg()), "x.stl", in_water);
    EXPECT_NEAR(plain.hull_file.volume, l_volume + 5 * 6 * 9.25, 1e-9);
    const std::string stl = stl_text(l_and_leg());
    const std::string obj = obj_text(l_and_leg());
    expect_same(plain, taken(in_capitals(stl), "X.STL", in_water), "STL in capitals");
    expect_same(plain, taken(in_capitals(obj), "X.OBJ", in_water), "OBJ in capitals");
    expect_same(plain, taken(replaced(stl, " ", " \t  "), "x.stl", in_water), "blanks in STL");
    expect_same(plain, taken(replaced(obj, " ", " \t  "), "x.obj", in_water), "blanks in OBJ");
    expect_same(plain, taken("# made by hand\n" + replaced(obj, "f ", "s off # none\nf \\\n "), "x.obj", in_water),
                "comments and lines that go on");
    expect_same(plain, taken(replaced(stl, " 20 ", " 20. "), "x.stl", in_water), "a point at the end");
}

TEST(HullChanges, TheOrderOfTrianglesAndCornersDoesNotMatter) {
    const Structure plain = taken(stl_text(l_and_leg()), "x.stl", in_water);
    Solids other = l_and_leg();
    for (auto& [name, triangles] : other) {
        std::ranges::reverse(triangles);
        for (Triangle3& one : triangles) std::ranges::rotate(one, one.begin() + 1);
        triangles.push_back(triangles.front());                                    // a triangle twice
        triangles.push_back({triangles[0][0], triangles[0][1], triangles[0][0]});  // and one without area
    }
    std::ranges::reverse(other);
    expect_same(plain, taken(stl_text(other), "x.stl", in_water), "STL");
    expect_same(plain, taken(obj_text(other), "x.obj", in_water), "OBJ");
}

TEST(HullChanges, BytesAreTheSameHullAsTextThoughTheyBeginAsOne) {
    const Structure plain = taken(stl_text({{"", l_prism()}}), "x.stl", in_water);
    std::string bytes = stl_bytes(l_prism());
    bytes.replace(0, 24, "solid exported by my CAD");
    expect_same(plain, taken(bytes, "x.stl", in_water), "header");
    expect_same(plain, taken(bytes + std::string(100, '\0'), "x.stl", in_water), "zeros behind it");
    EXPECT_EQ(refusal([&] { taken(bytes + bytes, "x.stl"); }),
              "x.stl: it says that it has 20 triangles, which are 1084 bytes, and 1084 bytes follow; if it is several "
              "files in one, export them as one");
    EXPECT_EQ(refusal([&] { taken(bytes.substr(0, 1054), "x.stl"); }),
              "x.stl: it says that it has 20 triangles, for which it needs 1084 bytes, and it has 1054, so it was cut "
              "off; export it anew");
}

// As where it was made, though the file has it in the coordinates of a map, or in mm.
TEST(HullChanges, FarFromTheOriginItIsTheSameHull) {
    const Structure plain = taken(stl_text(l_and_leg()), "x.stl", in_water);
    for (const Vec3& place : {Vec3(1e6, 1e6, 0), Vec3(512345.678, 7654321.012, 0), Vec3(-3e6, 12, 1e6)}) {
        HullFile file = in_water;
        file.waterline += place.z();
        const Solids moved = each(l_and_leg(), [&](const Vec3& at) { return Vec3(at + place); });
        expect_same(plain, taken(stl_text(moved), "x.stl", file), "STL");
        expect_same(plain, taken(obj_text(moved), "x.obj", file), "OBJ");
        file.unit = LengthUnit::mm;
        expect_same(plain, taken(obj_text(each(moved, [](const Vec3& at) { return Vec3(1000 * at); })), "x.obj", file),
                    "mm");
    }
    // Its digits are all there in single precision.
    const Solids eighths = each({{"", l_prism()}}, [](const Vec3& at) { return Vec3(at + Vec3(1e6, 1e6, 0)); });
    expect_same(taken(stl_text({{"", l_prism()}}), "x.stl", in_water),
                taken(stl_bytes(eighths.front().second), "x.stl", in_water), "bytes");
}

TEST(HullChanges, SaysThatDigitsAreLost) {
    const Solids moved =
        each({{"", l_prism()}}, [](const Vec3& at) { return Vec3(at + Vec3(512345.678, 7654321.012, 0)); });
    const auto said =
        AllOf(StartsWith("x.stl: its points lie up to 7.654e+06 from the origin, where the numbers of this "
                         "file are "),
              HasSubstr("so that the volume may be off by "), HasSubstr("move the hull to the origin"));
    EXPECT_THAT(refusal([&] { taken(stl_bytes(moved.front().second), "x.stl", in_water); }),
                AllOf(said, HasSubstr("are 0.5 apart"), HasSubstr("by 1.7 %")));  // 0.5 / 29.5
    const auto few = [](double number) { return fmt::format("{:e}", number); };
    EXPECT_THAT(refusal([&] { taken(test::rewritten(stl_text(moved), few), "x.stl", in_water); }),
                AllOf(said, HasSubstr("are 1 apart")));
    expect_same(taken(stl_text({{"", l_prism()}}), "x.stl", in_water),
                taken(test::rewritten(stl_text({{"", l_prism()}}), few), "x.stl", in_water), "as few, near the origin");
}

TEST(HullChanges, AxesThatAreTurnedTogetherWithTheKeysAreTheSame) {
    const Structure plain = taken(stl_text(l_and_leg()), "x.stl", in_water);
    const auto unit = [](int axis) { return Vec3((axis % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(axis / 2)); };
    for (int up = 0; up < 6; ++up) {
        for (int ahead = 0; ahead < 6; ++ahead) {
            if (up / 2 == ahead / 2) continue;
            HullFile file = in_water;
            file.up = static_cast<HullAxis>(up);
            file.forward = static_cast<HullAxis>(ahead);
            const Vec3 aside = unit(ahead).cross(unit(up));
            const Solids turned = each(l_and_leg(), [&](const Vec3& at) {
                return Vec3(at.x() * unit(ahead) + at.z() * unit(up) - at.y() * aside);
            });
            expect_same(plain, taken(stl_text(turned), "x.stl", file), fmt::format("up {} ahead {}", up, ahead));
        }
    }
}

TEST(HullChanges, PolygonsOfAnObjAreCutIntoTriangles) {
    std::string text = "o l\nvt 0 0\nvn 0 0 1\n";
    const std::vector<std::pair<double, double>> corners{{0, 0},   {30.5, 0},  {30.5, 10},
                                                         {10, 10}, {10, 29.5}, {0, 29.5}};
    for (const double z : {0.0, 10.25})
        for (const auto& [x, y] : corners) text += fmt::format("v {} {} {} 0.5 0.5 0.5\n", x, y, z);
    text += "f 6/1/1 5/1/1 4/1/1 3/1/1 2/1/1 1/1/1\nf -6//1 -5//1 -4//1 -3//1 -2//1 -1//1\n";
    for (int k = 0; k < 6; ++k) text += fmt::format("f {} {} {} {}\n", k + 1, (k + 1) % 6 + 1, (k + 1) % 6 + 7, k + 7);
    expect_same(taken(stl_text({{"l", l_prism()}}), "x.stl", in_water), taken(text, "x.obj", in_water), "polygons");
}

TEST(HullChanges, BodiesCountOnceWhicheverWayTheyAreTurnedAndNamed) {
    const Structure plain = taken(stl_text(l_and_leg()), "x.stl", in_water);
    for (const std::size_t over : {0, 1}) {
        Solids turned = l_and_leg();
        turn_over(turned[over].second);
        expect_same(plain, taken(stl_text(turned), "x.stl", in_water), "named");
        for (auto& [name, triangles] : turned) name = "";
        expect_same(plain, taken(stl_text(turned), "x.stl", in_water), "unnamed");
        turned[0].second.insert(turned[0].second.end(), turned[1].second.begin(), turned[1].second.end());
        turned.pop_back();
        expect_same(plain, taken(stl_bytes(turned[0].second), "x.stl", in_water), "in one solid");
    }
    Solids touching{{"", box({0, 0, 0}, {5, 5, 8})}, {"", box({5, 0, 0}, {9, 5, 8})}};
    EXPECT_NEAR(taken(stl_text(touching), "x.stl", in_water).hull_file.volume, 9 * 5 * 8, 1e-9);
}

TEST(HullChanges, BodiesThatShareSpaceAreRefusedHoweverTheyAreNamed) {
    for (const bool named : {true, false}) {
        for (const bool over : {true, false}) {
            const auto beside = [&](std::vector<Triangle3> inner) {
                if (over) turn_over(inner);
                Solids two = {{named ? "hull" : "", l_prism()}, {named ? "tank" : "", std::move(inner)}};
                return message(two);
            };
            const std::string names = named ? "x.stl: body 1 \"hull\" and body 2 \"tank\"" : "x.stl: body 1 and body 2";
            EXPECT_THAT(beside(box({2, 2, 2}, {8, 8, 8})),
                        AllOf(StartsWith(names + " lie one inside the other, near ("), HasSubstr("as a hollow does")));
            EXPECT_THAT(beside(l_prism()), StartsWith(names + " are the same body, near ("));
            EXPECT_THAT(
                beside(box({28, 2, 2}, {33, 8, 8})),  // half of its 5 m
                AllOf(StartsWith(names + " overlap near ("), HasSubstr(": 50 % of the smaller would count twice")));
        }
    }
    // Its walls may cross by what cutting into triangles leaves.
    EXPECT_NEAR(taken(stl_text({{"hull", l_prism()}, {"fin", box({30.48, 2, 2}, {33, 8, 8})}}), "x.stl", in_water)
                    .hull_file.volume,
                l_volume + 2.52 * 36, 1e-9);
}

TEST(HullChanges, ATriangleLeftOutIsRefused) {
    for (std::size_t k = 0; k < l_prism().size(); ++k) {
        std::vector<Triangle3> open = l_prism();
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(k));
        EXPECT_THAT(message({{"one", open}}), StartsWith("x.stl: the surface is open: 3 edges"));
    }
}

TEST(HullChanges, ACornerMovedAcrossTheBodyIsRefused) {
    const Vec3 middle(15, 15, 5);
    for (std::size_t k = 0; k < l_prism().size(); ++k) {
        const Vec3 corner = l_prism()[k][0];
        if (corner.x() == 10 && corner.y() == 10) continue;  // the inner one, which makes the body larger
        const Solids moved = each({{"one", l_prism()}},
                                  [&](const Vec3& at) { return at == corner ? Vec3(at + 3 * (middle - at)) : at; });
        EXPECT_THAT(message(moved), AllOf(StartsWith("x.stl: the surface of body 1 \"one\" crosses itself near ("),
                                          HasSubstr("% of it would count twice or be missing")));
    }
}

TEST(HullChanges, AnotherUnitIsRefusedWhereItIsNoStructure) {
    HullFile file = in_water;
    file.unit = LengthUnit::mm;
    file.waterline = 0.005;
    EXPECT_THAT(refusal([&] {
                    taken(stl_text(each({{"", l_prism()}}, [](const Vec3& at) { return Vec3(0.1 * at); })), "x.stl",
                          {.path = "", .unit = LengthUnit::mm, .waterline = 0.0005});
                }),
                HasSubstr("is hull.unit right?"));
    file.unit = LengthUnit::m;
    EXPECT_THAT(
        refusal([&] {
            taken(stl_text(each({{"", l_prism()}}, [](const Vec3& at) { return Vec3(1000 * at); })), "x.stl", file);
        }),
        HasSubstr("is hull.unit right?"));
}

TEST(HullChanges, BytesThatAreCutOffAreRefused) {
    const std::string bytes = stl_bytes(l_prism());
    for (std::size_t size = 1; size < bytes.size(); size += 7)
        EXPECT_THAT(refusal([&] { taken(bytes.substr(0, size), "x.stl"); }), StartsWith("x.stl: "));
    EXPECT_EQ(refusal([] { taken("solid a\nfacet normal 0 0 1\n outer loop\n", "x.stl"); }),
              "x.stl:4: the file ends before endsolid, so it was cut off; export it anew");
}

TEST(HullChanges, RefusesWithTheLine) {
    const auto said = [](const std::string& text, const std::string& name) {
        return refusal([&] { taken(text, name); });
    };
    EXPECT_EQ(said("solid a\r\nfacet normal 0 0 1\r\nouter loop\r\nvertex 1 2 x\r\n", "x.stl"),
              "x.stl:4: \"x\" is not a finite number; export the file anew");
    EXPECT_EQ(said("solid a\rfacet normal 0 0 1\router loop\rvertex 1,5 2 3\r", "x.stl"),
              "x.stl:4: \"1,5\" is not a finite number; export the file anew");
    EXPECT_EQ(
        said("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\nvertex", "x.stl"),
        "x.stl:7: \"vertex\" stands where an STL text has endloop; export the file anew");
    EXPECT_EQ(said("solid a\nendsolid a\n", "x.stl"), "x.stl: the file has no triangles");
    EXPECT_EQ(said("v 1 2 inf\n", "x.obj"), "x.obj:1: \"inf\" is not a finite number; export the file anew");
    EXPECT_EQ(said("v 1 2\n", "x.obj"), "x.obj:1: \"\" is not a finite number; export the file anew");
    EXPECT_EQ(said("v 1 2 3\n\nf 1 2 3\n", "x.obj"),
              "x.obj:3: \"2\" is none of the 1 points above this face; export the file anew");
    EXPECT_EQ(said("v 1 2 3\nv 4 5 6\nf 1 2\n", "x.obj"),
              "x.obj:3: this face has 2 corners; allowed: 3 to 300; export the file anew, as triangles");
    EXPECT_EQ(said("surf 0 1 0 1\n", "x.obj"),
              "x.obj:1: \"surf\" is no statement of an OBJ file of polygons; export it anew, as a mesh");
}

}  // namespace hull_changes_test
}  // namespace floes
