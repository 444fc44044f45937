#include "campaign/pose_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

#include "core/error.hpp"
#include "keys/literal.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

constexpr const char* header = "x_m,z_m,yaw_deg";
constexpr std::size_t columns = 3;

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
    bool header_seen = false;
    int number = 0;
    for (std::string raw; std::getline(lines, raw);) {
        ++number;
        const std::string line = squeezed(raw);
        if (line.empty()) continue;
        if (!header_seen) {
            if (line != header) {
                throw InputError(fmt::format("{}:{}: {} is not the header of a pose file; write {}", file, number,
                                             text_literal(line), header));
            }
            header_seen = true;
            continue;
        }
        std::vector<Value> numbers = numbers_of(line);
        if (numbers.size() != columns) {
            throw InputError(fmt::format("{}:{}: {} is not a pose; write three numbers, {}", file, number,
                                         text_literal(line), header));
        }
        if (poses.size() == std::size_t{most_floes})
            throw InputError(fmt::format("{}:{}: there are more than {} poses, the most floes of a field", file, number,
                                         most_floes));
        poses.emplace_back(std::move(numbers));
        places.push_back(number);
    }
    if (poses.empty())
        throw InputError(fmt::format("{}: there are no poses; write {} and a line for each floe", file, header));
    return {file, {std::move(poses)}, std::move(places)};
}

}  // namespace floes
