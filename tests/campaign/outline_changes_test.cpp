// Floes whose file is written otherwise are the same floes, and files that lost something are refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "campaign/outline_file.hpp"
#include "core/error.hpp"
#include "support/refusal.hpp"
#include "support/written_otherwise.hpp"

namespace floes {
namespace outline_changes_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

struct Traced {
    std::string name;
    std::vector<Outline> rings;  ///< the outline and its holes, closed
};

TracedOutlines taken(const std::string& text, const std::string& file) {
    TracedOutlines traced;
    traced.path = file;
    take_outlines(traced, text, file);
    return traced;
}

std::string message(const std::string& text, const std::string& file = "x.geojson") {
    return refusal([&] { static_cast<void>(taken(text, file)); });
}

/// Areas and places from the least corner on, floe by floe in the order of their names.
std::vector<double> numbers_of(const TracedOutlines& traced) {
    std::vector<std::vector<double>> floes;
    for (std::size_t i = 0; i < traced.outlines.size(); ++i) {
        Outline ring = traced.outlines[i];
        EXPECT_GT(area_of(ring), 0);
        std::ranges::rotate(ring,
                            std::ranges::min_element(ring, {}, [](const Corner& one) { return one.x + 0.01 * one.z; }));
        std::vector<double>& numbers = floes.emplace_back();
        for (const Corner& corner : ring) numbers.insert(numbers.end(), {corner.x, corner.z});
        numbers.push_back(traced.areas[i]);
    }
    std::ranges::sort(floes, {}, [](const auto& floe) { return std::pair(std::lround(1e3 * floe[0]), floe[1]); });
    std::vector<double> all;
    for (const auto& floe : floes) all.insert(all.end(), floe.begin(), floe.end());
    return all;
}

void expect_same(const TracedOutlines& one, const TracedOutlines& other, const std::string& what,
                 double within = 1e-12) {
    const std::vector<double> a = numbers_of(one);
    const std::vector<double> b = numbers_of(other);
    ASSERT_EQ(a.size(), b.size()) << what;
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], within) << what << ", number " << k;
}

Outline square(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}, {x, y}};
}

/// A triangle, a floe with a bay, one with a hole, and one that touches it.
std::vector<Traced> some_floes() {
    return {{"A", {{{0.1, 0.2}, {1.6, 0.3}, {0.5, 1.1}, {0.1, 0.2}}}},
            {"B", {{{3, 0}, {5, 0}, {5, 2}, {4.5, 2}, {4.5, 1}, {3.5, 1}, {3.5, 2}, {3, 2}, {3, 0}}}},
            {"C", {square(0, 3, 2), square(0.5, 3.5, 0.4)}},
            {"D", {square(2, 3, 1.3)}}};
}

std::vector<Traced> each(std::vector<Traced> floes, const std::function<void(Outline&)>& change) {
    for (Traced& one : floes)
        for (Outline& ring : one.rings) change(ring);
    return floes;
}

std::string geojson(const std::vector<Traced>& floes, const std::string& members = "") {
    std::string text = "{\"type\": \"FeatureCollection\",\n" + members + "\"features\": [\n";
    for (const Traced& one : floes) {
        text += one.name == floes.front().name ? "" : ",\n";
        text += fmt::format(
            "{{\"type\": \"Feature\", \"properties\": {{\"name\": \"{}\", \"seen\": [1, null]}},\n"
            "\"geometry\": {{\"type\": \"Polygon\", \"coordinates\": [",
            one.name);
        for (std::size_t r = 0; r < one.rings.size(); ++r) {
            text += r > 0 ? ", [" : "[";
            for (std::size_t k = 0; k < one.rings[r].size(); ++k)
                text += fmt::format("{}[{}, {}]", k > 0 ? ", " : "", one.rings[r][k].x, one.rings[r][k].z);
            text += "]";
        }
        text += "]}}";
    }
    return text + "\n]}\n";
}

/// Without holes.
std::string csv(const std::vector<Traced>& floes, bool closed = true) {
    std::string text = "floe,x,y\n";
    for (const Traced& one : floes)
        for (std::size_t k = 0; k < one.rings[0].size() - (closed ? 0 : 1); ++k)
            text += fmt::format("{},{},{}\n", one.name, one.rings[0][k].x, one.rings[0][k].z);
    return text;
}

std::vector<Traced> without_holes() {
    std::vector<Traced> floes = some_floes();
    for (Traced& one : floes) one.rings.resize(1);
    return floes;
}

/// Eight floes in two rows, as the files of floes_*.geojson in the field.
std::vector<Traced> eight_squares() {
    std::vector<Traced> floes;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 2; ++row)
            floes.push_back({fmt::format("F{}{}", column, row), {square(column, row, 0.7)}});
    return floes;
}

// tests/readers has the changes that all texts have in common.
TEST(OutlineChanges, TextsThatAreWrittenOtherwiseAreTheSameFloes) {
    const TracedOutlines plain = taken(geojson(some_floes()), "x.geojson");
    const TracedOutlines filled = taken(csv(without_holes()), "x.csv");
    expect_same(filled, taken(replaced(csv(without_holes()), ",", " ,\t"), "x.csv"), "blanks");
    expect_same(filled, taken(csv(without_holes(), false), "x.csv"), "not closed");
    expect_same(plain, taken(geojson(some_floes(), R"("name": "ice", "bbox": [0, 0, 5, 5], "crs": null,)"), "X.JSON"),
                "more members");
    expect_same(plain, taken(replaced(replaced(geojson(some_floes()), "\n", ""), " ", "\t"), "x.json"), "one line");
}

TEST(OutlineChanges, WhereRingsBeginAndTheOrderOfFloesDoNotMatter) {
    const TracedOutlines plain = taken(geojson(some_floes()), "x.geojson");
    std::vector<Traced> other = each(some_floes(), [](Outline& ring) {
        ring.pop_back();
        std::ranges::rotate(ring, ring.begin() + 2);
        std::ranges::reverse(ring);
        ring.insert(ring.begin() + 1, ring[1]);  // a corner twice
        ring.push_back(ring.front());
    });
    std::ranges::reverse(other);
    expect_same(plain, taken(geojson(other), "x.geojson"), "other order");
}

TEST(OutlineChanges, FarFromTheOriginTheyAreTheSameFloes) {
    const TracedOutlines plain = taken(geojson(some_floes()), "x.geojson");
    for (const Corner& place : {Corner{1e6, 1e6}, Corner{512345.678, 7654321.012}, Corner{-3e6, 12}}) {
        const auto moved = each(some_floes(), [&](Outline& ring) {
            for (Corner& one : ring) one = one + place;
        });
        expect_same(plain, taken(geojson(moved), "x.geojson"), "moved", 1e-8);
    }
    TracedOutlines in_mm;
    in_mm.unit = LengthUnit::mm;
    take_outlines(in_mm,
                  geojson(each(some_floes(),
                               [](Outline& ring) {
                                   for (Corner& one : ring) one = 1000 * one;
                               })),
                  "x.geojson");
    expect_same(plain, in_mm, "mm", 1e-9);
}

TEST(OutlineChanges, TheSameFloeTwiceIsRefusedUnderAnyName) {
    std::vector<Traced> floes = eight_squares();
    floes.push_back({"again", {square(0, 0, 0.7)}});
    const std::string said =
        "x.geojson, feature 9: again: this floe and another one (x.geojson, feature 1: F00) share 100 % of the smaller "
        "one's area, so that the same ice would count twice; leave one of them out, or move it aside";
    EXPECT_EQ(message(geojson(floes)), said);
    Outline& ring = floes.back().rings[0];
    ring = {{0.7, 0.7}, {0.7, 0.3}, {0.7, 1e-12}, {0, 0}, {0, 0.7}, {0.7, 0.7}};  // begun elsewhere, other direction
    EXPECT_EQ(message(geojson(floes)), said);
    ring = square(0.1, 0, 0.7);
    EXPECT_THAT(message(geojson(floes)), HasSubstr("share 85.7 % of the smaller"));
    ring = square(0.2, 0.2, 0.3);
    EXPECT_THAT(message(geojson(floes)), HasSubstr("share 100 % of the smaller"));
    ring = square(0.4, 0, 0.7);  // neighbours that were traced roughly
    EXPECT_EQ(taken(geojson(floes), "x.geojson").outlines.size(), 9U);
    EXPECT_THAT(message(R"({"type": "Feature", "id": "M", "geometry": {"type": "MultiPolygon", "coordinates": [
        [[[0, 0], [0.7, 0], [0.7, 0.7], [0, 0.7], [0, 0]]], [[[0.0, 0], [0.7, 0], [0.7, 0.7], [0.0, 0.7], [0, 0]]]]}})"),
                StartsWith("x.geojson, polygon 2: M part 2: this floe and another one (x.geojson, polygon 1: M part 1) "
                           "share 100 %"));
    std::string text = csv(eight_squares()) + "again,0,0\nagain,0.7,0\nagain,0.7,0.7\nagain,0,0.7\nagain,0,0\n";
    EXPECT_THAT(message(text, "x.csv"), StartsWith("x.csv:42: again: this floe and another one (x.csv:2: F00) share"));
}

TEST(OutlineChanges, AFloeInTheHoleOfAnotherIsAFloe) {
    std::vector<Traced> floes{{"A", {square(0, 0, 4), square(1, 1, 2)}}, {"B", {square(1.2, 1.2, 1.5)}}};
    EXPECT_EQ(taken(geojson(floes), "x.geojson").outlines.size(), 2U);
    floes[0].rings.pop_back();
    EXPECT_THAT(message(geojson(floes)), HasSubstr("share 100 % of the smaller"));
}

TEST(OutlineChanges, RingsThatAreNoHolesAreRefused) {
    const auto said = [](const std::vector<Outline>& holes) {
        std::vector<Traced> floes = eight_squares();
        floes[0].rings.insert(floes[0].rings.end(), holes.begin(), holes.end());
        return message(geojson(floes));
    };
    EXPECT_EQ(
        said({square(10, 10, 0.2)}),
        "x.geojson, feature 1, hole 1: 100 % of it lies outside of the floe, so it is no hole; move it inside, or "
        "make it a polygon of its own");
    EXPECT_THAT(said({square(0.6, 0.2, 0.2)}), StartsWith("x.geojson, feature 1, hole 1: 50 % of it lies outside"));
    EXPECT_EQ(said({square(0.1, 0.1, 0.2), square(0.1, 0.1, 0.2)}),
              "x.geojson, feature 1, hole 2: it and another hole (x.geojson, feature 1, hole 1) share 100 % of the "
              "smaller, which would be taken off the floe twice; make one hole of the two");
    EXPECT_THAT(said({square(0.1, 0.1, 0.2), square(0.2, 0.1, 0.2)}), HasSubstr("share 50 % of the smaller"));
}

TEST(OutlineChanges, DegreesAcrossTheDateLineAreRefused) {
    const auto said = [](double west, double apart, double side) {
        std::vector<Traced> floes;
        for (int k = 0; k < 8; ++k) {
            const auto wrapped = [](double x) { return x > 180 ? x - 360 : x; };
            Outline ring = square(west + k * apart, 72, side);
            for (Corner& one : ring) one.x = wrapped(one.x);
            floes.push_back({fmt::format("{}", k), {ring}});
        }
        return message(geojson(floes));
    };
    EXPECT_THAT(said(176.8, 1, 0.4),
                StartsWith("x.geojson: its coordinates look like degrees of longitude and latitude: "
                           "the largest floe is 0.4 across over the date line, and all lie within"));
    EXPECT_THAT(said(179.9937, 0.002, 0.0006), HasSubstr("the largest floe is 0.0006 across over the date line"));
    EXPECT_THAT(said(179.9, 0.002, 0.0006), HasSubstr("the largest floe is 0.0006 across, and all lie within"));
    // A floe of 200 m about the origin is none.
    EXPECT_EQ(taken(geojson({{"A", {square(-80, -80, 160)}}}), "x.geojson").outlines.size(), 1U);
}

TEST(OutlineChanges, AReferenceSystemWithoutANameIsRefused) {
    const auto with = [](const std::string& crs) { return geojson(eight_squares(), "\"crs\": " + crs + ",\n"); };
    EXPECT_EQ(
        message(with(R"({"type": "link", "properties": {"href": "http://x/y", "type": "proj4"}})")),
        "x.geojson: its reference system is not known, since crs has no name in it: "
        R"({"properties":{"href":"http://x/y","type":"proj4"},"type":"link"}; name it, as EPSG:32633, or, if its )"
        "places are lengths, take it out of the file and give shapes.unit");
    EXPECT_THAT(message(with("\"EPSG:4326\"")), HasSubstr("is not known"));
    EXPECT_THAT(message(with(R"({"type": "name", "properties": {"name": {}}})")), HasSubstr("is not known"));
    std::string inside = geojson(eight_squares());
    inside.insert(inside.find("\"geometry\""), R"("crs": {"type": "name", "properties": {"name": "EPSG:4326"}}, )");
    EXPECT_THAT(message(inside), StartsWith("x.geojson, feature 1: its reference system EPSG:4326 is in degrees"));
}

// Floes of some 30 m in a UTM zone: northings of seven digits are then multiples of 10 m.
TEST(OutlineChanges, SaysThatDigitsAreLost) {
    const auto far = [](double side, const std::function<double(double)>& written) {
        std::vector<Traced> floes;
        for (int k = 0; k < 12; ++k) {
            Outline ring;
            for (int c = 0; c < 8; ++c) {
                const double angle = 0.3 * k + c * std::numbers::pi / 4;
                ring.push_back(
                    {512345.678 + 2 * side * k + side / 2 * std::cos(angle), 7654321.012 + side / 2 * std::sin(angle)});
            }
            ring.push_back(ring.front());
            for (Corner& one : ring) one = {written(one.x), written(one.z)};
            floes.push_back({fmt::format("F{}", k), {ring}});
        }
        return geojson(floes);
    };
    const auto whole = [](double number) { return number; };
    const auto six_digits = [](double number) { return std::stod(fmt::format("{:.6g}", number)); };
    const auto single = [](double number) { return static_cast<double>(static_cast<float>(number)); };
    const TracedOutlines exact = taken(far(30, whole), "x.geojson");
    for (const double area : exact.areas) EXPECT_NEAR(area, 15 * 15 * std::sqrt(8), 1e-5);
    const std::string said = message(far(30, six_digits));
    EXPECT_THAT(
        said,
        HasSubstr(": the coordinates of this file lost their last digits: in y all are multiples of 10, so that the "
                  "area of this floe may be off by "));
    EXPECT_EQ(taken(far(30, single), "x.geojson").outlines.size(), 12U);
    EXPECT_THAT(message(far(3, single)),
                HasSubstr("in x all are multiples of 0.03125, in y all are multiples of 0.5, so"));
    EXPECT_EQ(taken(far(300, six_digits), "x.geojson").outlines.size(), 12U);
}

// What it says is two standard deviations: some floes in twenty lie beyond.
TEST(OutlineChanges, SaysByHowMuchAreasAreOff) {
    int beyond = 0;
    for (int k = 0; k < 200; ++k) {
        Outline ring;
        for (int c = 0; c < 8; ++c) {
            const double angle = 0.3 * k + c * std::numbers::pi / 4;
            ring.push_back({7654321 + 17.3 * k + 15 * std::cos(angle), 7654321 + 31.7 * k + 15 * std::sin(angle)});
        }
        for (Corner& one : ring) one = {10 * std::round(one.x / 10), 10 * std::round(one.z / 10)};
        ring.push_back(ring.front());
        const std::string said = refusal([&] { taken(geojson({{"A", {ring}}}), "x.geojson"); });
        const std::size_t at = said.find("off by ");
        if (at == std::string::npos) continue;  // corners that became one or cross
        const double off = std::stod(said.substr(at + 7)) / 100;
        beyond += std::abs(std::abs(area_of(ring)) / (15 * 15 * std::sqrt(8)) - 1) > off ? 1 : 0;
    }
    EXPECT_GE(beyond, 2);
    EXPECT_LE(beyond, 20);
}

TEST(OutlineChanges, RingsThatCrossThemselvesAreRefused) {
    for (std::size_t floe = 0; floe < some_floes().size(); ++floe) {
        std::vector<Traced> floes = some_floes();
        Outline& ring = floes[floe].rings[0];
        if (ring.size() < 5) continue;
        std::swap(ring[1], ring[2]);
        EXPECT_THAT(message(geojson(floes)),
                    StartsWith(fmt::format("x.geojson, feature {}: it crosses or touches itself", floe + 1)));
        EXPECT_THAT(message(csv(floes), "x.csv"), HasSubstr(": it crosses or touches itself"));
    }
}

TEST(OutlineChanges, ACsvFileThatIsCutOffIsRefusedWhereItShows) {
    const std::string text = csv(without_holes());
    const TracedOutlines whole = taken(text, "x.csv");
    for (std::size_t size = 1; size + 1 < text.size(); ++size) {
        const std::string cut = text.substr(0, size);
        try {  // behind a floe nothing shows that others came
            const TracedOutlines part = taken(cut, "x.csv");
            EXPECT_TRUE(whole.names.starts_with(part.names)) << cut;
            const std::size_t last = part.areas.size() - 1;
            EXPECT_TRUE(last == 0 || part.areas[last] == whole.areas[last]) << cut;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), StartsWith("x.csv:"));
        }
    }
    std::string one_open = text;
    one_open.erase(one_open.rfind("D,"));
    EXPECT_EQ(
        message(one_open, "x.csv"),
        "x.csv:20: floe D does not end at the corner with which it begins, as all others do; was the file cut off? "
        "Close it too, or none");
}

TEST(OutlineChanges, AnotherUnitIsRefusedWhereItIsNoField) {
    const auto scaled = [](double by) {
        return geojson(each(some_floes(), [&](Outline& ring) {
            for (Corner& one : ring) one = by * one;
        }));
    };
    EXPECT_THAT(message(scaled(1e5)), HasSubstr("is shapes.unit right?"));
    EXPECT_THAT(message(scaled(1e-3)), HasSubstr("degrees"));
}

TEST(OutlineChanges, ManyThatLieOverEachOtherEndSoon) {
    std::vector<Traced> floes;
    for (int k = 0; k < 9000; ++k) {  // long and askew, side by side: every box meets all others
        const double x = 0.01 * k;
        floes.push_back(
            {fmt::format("{}", k),
             {{{x, -x}, {x + 1000, -x + 1000}, {x + 1000.004, -x + 999.996}, {x + 0.004, -x - 0.004}, {x, -x}}}});
    }
    EXPECT_THAT(message(geojson(floes)),
                StartsWith("x.geojson: so many of its outlines or holes lie one over the other"));
}

}  // namespace outline_changes_test
}  // namespace floes
