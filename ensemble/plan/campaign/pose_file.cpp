#include "campaign/pose_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "core/error.hpp"
#include "keys/literal.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

constexpr std::string_view header = "x_m,z_m,yaw_deg";

/// The line without spaces, tabs and carriage returns.
std::string squeezed(const std::string& line) {
    std::string text;
    for (const char character : line) {
        if (character != ' ' && character != '\t' && character != '\r') text += character;
    }
    return text;
}

/// The numbers between commas; empty when there is anything else.
std::vector<Value> numbers_of(const std::string& line) {
    std::vector<Value> numbers;
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) {
        double number = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
        if (error != std::errc() || end != cell.data() + cell.size()) return {};
        numbers.emplace_back(number);
    }
    return numbers;
}

}  // namespace

PoseFile read_poses(const std::string& text, const std::string& file) {
    std::vector<Value> poses;
    std::istringstream lines(text);
    std::vector<int> places;
    std::optional<std::string> header_seen;
    int number = 0;
    for (std::string raw; std::getline(lines, raw);) {
        ++number;
        const std::string line = squeezed(raw);
        if (line.empty()) continue;
        if (!header_seen) {
            const bool longer = line.size() > header.size() && line[header.size()] == ',';
            if (!line.starts_with(header) || !(line == header || longer)) {
                throw InputError(
                    fmt::format("{}:{}: {} is not the header of a pose file; write {}, and behind it keys "
                                "of which each floe has a value of its own, such as ice.thickness_m",
                                file, number, text_literal(line), header));
            }
            header_seen = line;
            continue;
        }
        std::vector<Value> numbers = numbers_of(line);
        const auto columns = static_cast<std::size_t>(1 + std::ranges::count(*header_seen, ','));
        if (numbers.size() != columns) {
            throw InputError(fmt::format("{}:{}: {} is not a pose; write {} numbers, {}", file, number,
                                         text_literal(line), columns, *header_seen));
        }
        if (poses.size() == std::size_t{most_floes})
            throw InputError(fmt::format("{}:{}: there are more than {} poses, the most floes of a field", file, number,
                                         most_floes));
        poses.emplace_back(std::move(numbers));
        places.push_back(number);
    }
    if (poses.empty())
        throw InputError(fmt::format("{}: there are no poses; write {} and a line for each floe", file, header));
    std::string columns = header_seen->substr(std::min(header_seen->size(), header.size() + 1));
    return {file, std::move(columns), {std::move(poses)}, std::move(places)};
}

}  // namespace floes
