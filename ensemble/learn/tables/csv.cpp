#include <fmt/format.h>

#include <cmath>

#include "tables/data_rows.hpp"

namespace floes {
namespace {

struct Field {
    std::string operator()(Absent) const { return ""; }
    std::string operator()(Undefined) const { return ""; }
    std::string operator()(bool value) const { return value ? "1" : "0"; }
    std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const { return std::isfinite(value) ? fmt::format("{}", value) : ""; }
    /// Quoted if a comma, a quote or a line end would be misread.
    std::string operator()(const std::string& text) const {
        if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
        std::string quoted;
        for (const char letter : text) quoted.append(letter == '"' ? 2 : 1, letter);
        return fmt::format("\"{}\"", quoted);
    }
};

void end_line(std::string& line) {
    line.back() = '\n';  // in place of the last comma
}

}  // namespace

DataRows csv_only(DataRows records) {
    for (Names& one : records.names) one.json.clear();
    return records;
}

DataRows json_only(DataRows records) {
    for (Names& one : records.names) one.csv.clear();
    return records;
}

std::string csv(const DataRows& records) {
    std::string text;
    for (const Names& one : records.names)
        if (!one.csv.empty()) text += Field{}(one.csv) + ",";
    if (text.empty()) return text;
    end_line(text);
    for (const std::vector<Datum>& row : records.rows) {
        for (std::size_t k = 0; k < row.size(); ++k)
            if (!records.names[k].csv.empty()) text += std::visit(Field{}, row[k].get()) + ",";
        end_line(text);
    }
    return text;
}

}  // namespace floes
