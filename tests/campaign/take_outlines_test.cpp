// Files of traced floes: what is read, and what is refused with which sentence.

#include "campaign/outline_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shapes/elements.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace take_outlines_test {

using testing::HasSubstr;
using testing::StartsWith;

TracedOutlines taken(const std::string& text, const std::string& file, LengthUnit unit = LengthUnit::m) {
    TracedOutlines traced;
    traced.path = file;
    traced.unit = unit;
    take_outlines(traced, text, file);
    return traced;
}

std::string message(const std::string& text, const std::string& file = "a.geojson") {
    return refusal_or("", [&] { taken(text, file); });
}

const std::string square_ring = "[[10,20],[12,20],[12,22],[10,22],[10,20]]";

std::string polygon(const std::string& rings) {
    return fmt::format(R"({{"type":"Polygon","coordinates":[{}]}})", rings);
}

std::string feature(const std::string& geometry, const std::string& members = "") {
    return fmt::format(R"({{"type":"Feature",{}"geometry":{}}})", members, geometry);
}

std::string collection(const std::string& features, const std::string& members = "") {
    return fmt::format(R"({{"type":"FeatureCollection",{}"features":[{}]}})", members, features);
}

TEST(TakeOutlines, PutsThemFromXZeroOnAboutTheMiddleLineSeenFromAbove) {
    const TracedOutlines traced = taken(polygon("[[10,20],[13,20],[10,24],[10,20]]"), "a.geojson");
    ASSERT_EQ(traced.outlines.size(), 1u);
    EXPECT_THAT(traced.outlines[0], testing::UnorderedElementsAre(Corner{0, 2}, Corner{3, 2}, Corner{0, -2}));
    EXPECT_NEAR(area_of(traced.outlines[0]), 6, 1e-12);
    EXPECT_NEAR(traced.areas.at(0), 6, 1e-12);
    EXPECT_EQ(traced.names, "");
    EXPECT_TRUE(traced.path.empty());
}

TEST(TakeOutlines, ReadsEveryCollectionOfPolygons) {
    const std::string two =
        R"({"type":"MultiPolygon","coordinates":[[[[5,0],[6,0],[5,1],[5,0]]],[[[0,0],[1,0],[0,1],[0,0]]]]})";
    const std::string all = collection(
        feature(polygon(square_ring), R"("id":7,)") + "," + feature(two, R"("properties":{"name":"B"},)") + "," +
        feature(R"({"type":"GeometryCollection","geometries":[)" + polygon("[[0,5],[1,5],[0,6],[0,5]]") + "]}"));
    const TracedOutlines traced = taken(all, "a.GeoJSON");
    ASSERT_EQ(traced.outlines.size(), 4u);
    EXPECT_EQ(traced.names, "7, B part 1, B part 2, 4");
    EXPECT_NEAR(traced.areas[2], 0.5, 1e-12);
}

TEST(TakeOutlines, GeoJsonAndCsvOfTheSameFloesAreTheSame) {
    const TracedOutlines json = taken(collection(feature(polygon(square_ring), R"("id":"A",)") + "," +
                                                 feature(polygon("[[0,0],[3,1],[0,2],[0,0]]"), R"("id":"B",)")),
                                      "a.json", LengthUnit::cm);
    const TracedOutlines csv = taken(
        "\xEF\xBB\xBF floe, x, "
        "y\r\nA,10,20\r\nA,12,20\r\nA,12,22\r\nA,10,22\r\n\r\nB,0,0\r\nB,3,1\r\nB,0,2\r\nB,0,0\r\n",
        "a.csv", LengthUnit::cm);
    EXPECT_EQ(json.outlines, csv.outlines);
    EXPECT_EQ(json.areas, csv.areas);
    EXPECT_EQ(json.names, csv.names);
    EXPECT_NEAR(json.areas[0], 4e-4, 1e-16);
}

TEST(TakeOutlines, KeepBaysAndFillHoles) {
    // A square of 2 with a square bay of 1 in a side, and one with a hole of 1 m².
    const std::string bay = "[[0,0],[2,0],[2,2],[1.5,2],[1.5,1],[0.5,1],[0.5,2],[0,2],[0,0]]";
    const std::string hole = square_ring + ",[[10.5,20.5],[11.5,20.5],[11.5,21.5],[10.5,21.5],[10.5,20.5]]";
    const TracedOutlines traced = taken(collection(feature(polygon(bay)) + "," + feature(polygon(hole))), "a.json");
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(traced.areas[i], 3, 1e-12);
        EXPECT_NEAR(area_of(traced.outlines[i]), i == 0 ? 3 : 4, 1e-12);
        EXPECT_EQ(is_convex(traced.outlines[i]), i == 1);
    }
    EXPECT_EQ(traced.outlines[0].size(), 8u);
}

TEST(TakeOutlines, CloseBaysOfLessThanAHundredth) {
    const TracedOutlines traced = taken(polygon("[[0,0],[2,0],[2,2],[1,1.99],[0,2],[0,0]]"), "a.json");
    EXPECT_TRUE(is_convex(traced.outlines[0]));
    EXPECT_NEAR(area_of(traced.outlines[0]), 4, 1e-12);
}

TEST(TakeOutlines, ManyCornersBecomeSixteenOfTheSameArea) {
    std::string csv = "floe,x,y\n";
    const double pi = std::acos(-1);
    for (int k = 0; k < 400; ++k)
        csv += fmt::format("A,{},{}\n", 30 * std::cos(pi * k / 200), 20 * std::sin(pi * k / 200));
    const TracedOutlines traced = taken(csv, "a.csv");
    EXPECT_EQ(traced.outlines[0].size(), most_outline_corners);
    EXPECT_EQ(std::ranges::min(traced.outlines[0], {}, &Corner::x).x, 0);  // though the corners moved outwards
    EXPECT_GT(size_of(traced.outlines[0]).x, 60.1);
    EXPECT_NEAR(area_of(traced.outlines[0]), 600 * 200 * std::sin(pi / 200), 1e-6);
}

TEST(TakeOutlines, RefusesWhatIsNoGeoJson) {
    EXPECT_THAT(message("hello"), StartsWith("a.geojson: this is no JSON: parse error"));
    EXPECT_THAT(message(polygon("[[0,0],[1,0],[1,NaN],[0,0]]")), StartsWith("a.geojson: this is no JSON"));
    EXPECT_THAT(message(polygon("[[0,0],[1,0],[1,1e999],[0,0]]")), StartsWith("a.geojson: this is no JSON"));
    EXPECT_EQ(message("[1, 2]"),
              "a.geojson: this is no GeoJSON, which has a \"type\"; allowed: Polygon, MultiPolygon, Feature, "
              "FeatureCollection and GeometryCollection");
    EXPECT_THAT(message(R"({"type":"Point","coordinates":[1,2]})"), StartsWith("a.geojson: a Point encloses no ice;"));
    EXPECT_THAT(message(collection(feature(polygon(square_ring)) + "," +
                                   feature(R"({"type":"LineString","coordinates":[[1,2],[3,4]]})"))),
                StartsWith("a.geojson, feature 2: a LineString encloses no ice;"));
    EXPECT_EQ(message(collection("")), "a.geojson: the file has no outlines");
    EXPECT_EQ(message(R"({"type":"FeatureCollection"})"), "a.geojson: this collection has no list of features");
    EXPECT_EQ(message(feature("null")), "a.geojson: this feature has no geometry; leave it out");
    EXPECT_EQ(message(R"({"type":"Polygon"})"), "a.geojson: it has no coordinates");
    EXPECT_EQ(message(polygon(R"([[0,0],[1,"x"],[1,1],[0,0]])")),
              "a.geojson: place 2 of the ring is none; write [x, y]");
    EXPECT_EQ(message(" \n"), "a.geojson: the file is empty");
    EXPECT_EQ(message("x", "a.shp"),
              "a.shp: outlines are read from .geojson, .json and .csv files; export one of these");
    std::string nested = polygon(square_ring);
    for (int k = 0; k < 20; ++k) nested = fmt::format(R"({{"type":"GeometryCollection","geometries":[{}]}})", nested);
    EXPECT_THAT(message(nested), HasSubstr("flatten them"));
    EXPECT_EQ(message(std::string(1'000'000, '[')), "a.geojson: this is no GeoJSON: it is too deep");
}

TEST(TakeOutlines, RefusesRingsThatAreNone) {
    EXPECT_EQ(message(polygon("[[0,0],[1,0],[1,1],[0,1]]")),
              "a.geojson: the ring is not closed: it begins at (0, 0) and ends at (0, 1); let it end where it begins");
    EXPECT_EQ(message(polygon("[[0,0],[1,0],[0,0]]")),
              "a.geojson: a ring has at least 4 places, the last being the first again; this one has 3");
    EXPECT_EQ(message(polygon("[[0,0],[1,0],[1,0],[0,0]]")),
              "a.geojson: it has 2 different corners, and a floe has at least 3; trace it anew");
    EXPECT_EQ(message(collection(feature(polygon("[[0,0],[2,2],[2,0],[0,2],[0,0]]")))),
              "a.geojson, feature 1: it crosses or touches itself: its edges from corners 1 and 3 meet; trace it anew");
    EXPECT_EQ(message(polygon(square_ring + "," + square_ring)), "a.geojson: its holes leave nothing of it");
    EXPECT_EQ(message("floe,x,y\nA,0,0\nA,1,0\n", "a.csv"),
              "a.csv:2: it has 2 different corners, and a floe has at least 3; trace it anew");
}

TEST(TakeOutlines, RefusesDegrees) {
    const std::string square = polygon("[[18.5,79.1],[18.501,79.1],[18.501,79.101],[18.5,79.1]]");
    EXPECT_THAT(message(square), StartsWith("a.geojson: its coordinates look like degrees of longitude and latitude: "
                                            "the largest floe is 0.001 across, and all lie within x = 18.5 to 18.501 "
                                            "and y = 79.1 to 79.101; project them to lengths first"));
    EXPECT_THAT(message("floe,x,y\nA,18.5,79.1\nA,18.501,79.1\nA,18.501,79.101\n", "a.csv"),
                HasSubstr("look like degrees"));
    const auto with_crs = [](const std::string& name) {
        return collection(feature(polygon(square_ring)),
                          fmt::format(R"("crs":{{"type":"name","properties":{{"name":"{}"}}}},)", name));
    };
    EXPECT_THAT(message(with_crs("urn:ogc:def:crs:OGC:1.3:CRS84")),
                StartsWith("a.geojson: its reference system urn:ogc:def:crs:OGC:1.3:CRS84 is in degrees"));
    EXPECT_THAT(message(with_crs("EPSG:4326")), HasSubstr("is in degrees"));
    EXPECT_THAT(message(with_crs("urn:ogc:def:crs:EPSG::3857")), HasSubstr("one over the cosine of the latitude"));
    EXPECT_EQ(message(with_crs("urn:ogc:def:crs:EPSG::32633")), "");  // a UTM zone
    EXPECT_EQ(message(with_crs("EPSG:3996")), "") << "polar";
    for (const char* other : {"EPSG:4617", "EPSG:2225", "EPSG:3395", "my tank"})  // degrees, feet, stretched, a name
        EXPECT_THAT(
            message(with_crs(other)),
            HasSubstr(fmt::format("its reference system {} is none that is known here to have lengths", other)));
}

TEST(TakeOutlines, RefusesCsvWithLineAndWhatToWrite) {
    EXPECT_EQ(message("A,0,0\nA,1,0\nA,0,1\n", "a.csv"),
              "a.csv:1: \"A,0,0\" is not the header of a file of outlines; write floe,x,y and below it a line for each "
              "corner");
    EXPECT_THAT(message("floe,x\nA,0\n", "a.csv"), HasSubstr("is not the header"));
    EXPECT_EQ(message("floe,x,y\nA,0\n", "a.csv"), "a.csv:2: \"A,0\" is not a corner; write the floe's name, x and y");
    EXPECT_EQ(message("floe,x,y\nA,0,nan\n", "a.csv"), "a.csv:2: \"nan\" is not a finite number");
    EXPECT_EQ(message("floe,x,y\n\nA,0,1.5m\n", "a.csv"), "a.csv:3: \"1.5m\" is not a finite number");
    EXPECT_EQ(message("floe,x,y\n,0,1\n", "a.csv"),
              "a.csv:2: \",0,1\" is not a corner; write the floe's name, x and y");
    EXPECT_EQ(message("floe,x,y\n", "a.csv"), "a.csv: the file has no outlines");
    EXPECT_EQ(message("floe,x,y\n\xFF,1,1\n", "a.csv"), "a.csv: this is no text in UTF-8; save it as such");
    const std::string triangle = "A,0,0\nA,1,0\nA,0,1\n";
    EXPECT_EQ(message("floe,x,y\n" + triangle + "B,5,5\nB,6,5\nB,5,6\n" + triangle, "a.csv"),
              "a.csv:8: floe A comes again after another one; keep the corners of a floe together, and give each floe "
              "a name of its own");
}

TEST(TakeOutlines, RefusesNamesThatAreThereTwice) {
    const std::string one = feature(polygon(square_ring), R"("id":"F1",)");
    EXPECT_EQ(message(collection(one + "," + one)),
              "a.geojson, feature 2: floe F1 is there already (a.geojson, feature 1); was it traced twice? Give each "
              "floe a name of its own, or none a name");
}

TEST(TakeOutlines, RefusesTooMuch) {
    EXPECT_THAT(message(std::string(longest_outline_file + 1, 'x')), HasSubstr("simplify its outlines"));
    std::string csv = "floe,x,y\n";
    for (std::size_t k = 0; k <= most_ring_corners; ++k) csv += fmt::format("A,{},{}\n", k, k * k);
    EXPECT_EQ(message(csv, "a.csv"), "a.csv:2: the outline has 5001 corners, more than 5000; simplify it");
    csv = "floe,x,y\n";
    for (std::size_t k = 0; k <= most_outlines; ++k) csv += fmt::format("{},0,0\n", k);
    EXPECT_THAT(message(csv, "a.csv"), HasSubstr("the file has more than 10000 outlines; take a part of it"));
    csv = "floe,x,y\n";
    for (std::size_t k = 0; k <= most_file_corners; ++k) csv += "A,0,0\n";
    EXPECT_EQ(message(csv, "a.csv"), "a.csv:200002: the file has more than 200000 corners; simplify its outlines");
    EXPECT_THAT(message(polygon("[[0,0],[1e7,0],[0,1e7],[0,0]]")), HasSubstr("is shapes.unit right?"));
}

}  // namespace take_outlines_test
}  // namespace floes
