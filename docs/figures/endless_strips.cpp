// Prints how much of the water fields without end cover from the end of one part to that of the next, for the table of
// docs/field.md:
//   endless_strips [FIELDS]
// Parts of 24 floes of 0.36 m² at 75 % in a channel 2.5 m wide, eight of each field, in eight strips.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "arrangement/order.hpp"

namespace {

using namespace floes;

constexpr std::size_t parts = 8, strips = 8;

Scenario channel(ShapeKind kind) {
    Scenario scenario;
    scenario.field.far_end = FarEnd::never;
    scenario.field.floes = 24;
    scenario.field.half_width = 1.25;
    scenario.shapes.kind = kind;
    scenario.joint.failure = JointFailure::moment;
    return scenario;
}

Outline where_it_lies(const FloeShape& shape, const PlanarPose& pose) {
    const double x = 0.5 * shape.length, z = 0.5 * shape.breadth;
    const Outline square{{-x, -z}, {x, -z}, {x, z}, {-x, z}};
    return on_water(shape.is_polygon() ? shape.outline : square, pose);
}

/// Of single strips: [strip][strip of any part].
using Found = std::vector<std::vector<double>>;

void look(const Scenario& scenario, std::uint32_t number, Found& found) {
    const LaidField field = lay_field(scenario, 1, number);
    std::vector<Outline> floes;
    std::vector<double> ends{field.ahead.end};
    for (std::size_t i = 0; i < field.floes.size(); ++i)
        floes.push_back(where_it_lies(field.floes.shape(i), field.floes.floes[i].pose));
    while (ends.size() < parts) {
        const FieldPart part = field.ahead.next();
        for (const SingleFloe& floe : part.floes) floes.push_back(where_it_lies(floe.shape, floe.pose));
        ends.push_back(part.end);
    }
    for (std::size_t k = 0; k + 2 < ends.size(); ++k) {
        const double strip = (ends[k + 1] - ends[k]) / strips;
        for (std::size_t i = 0; i < strips; ++i)
            found[i].push_back(100 * coverage({ends[k] + static_cast<double>(i) * strip, -scenario.field.half_width,
                                               strip, 2 * scenario.field.half_width},
                                              floes));
    }
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double error(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values) squares += std::pow(value - mean(values), 2);
    const auto count = static_cast<double>(values.size());
    return std::sqrt(squares / count / (count - 1));
}

}  // namespace

int main(int argc, char** argv) {
    const int fields = argc > 1 ? std::atoi(argv[1]) : 48;
    fmt::print("| floes | coverage of the strips, % | least | largest | each to | s for a part |\n");
    for (const auto& [kind, name] : {std::pair(ShapeKind::rectangle, "squares"),
                                     {ShapeKind::polygon, "polygons"},
                                     {ShapeKind::voronoi, "Voronoi cells"}}) {
        Found found(strips);
        const auto begin = std::chrono::steady_clock::now();
        for (int number = 0; number < fields; ++number) look(channel(kind), static_cast<std::uint32_t>(number), found);
        const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        std::vector<double> means;
        std::string text;
        double largest_error = 0;
        for (const std::vector<double>& strip : found) {
            means.push_back(mean(strip));
            text += fmt::format("{}{:.1f}", text.empty() ? "" : " ", means.back());
            largest_error = std::max(largest_error, error(strip));
        }
        const auto [least, most] = std::ranges::minmax(means);
        fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.3f} |\n", name, text, least, most, largest_error,
                   took / (fields * static_cast<double>(parts)));
    }
}
