#include "tables/workbook.hpp"

#include <fmt/format.h>
#include <xlsxwriter.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include "core/error.hpp"

namespace floes {
namespace {

constexpr std::size_t most_rows = LXW_ROW_MAX - 1;  // below the header
constexpr std::size_t longest_text = 32'000;        // of a cell; a sheet takes 32,767 characters
constexpr double widest_column = 40;

/// Writes one value into a cell.
struct Writer {
    lxw_worksheet* sheet;
    lxw_row_t row;
    lxw_col_t column;

    void operator()(Absent) const {}
    void operator()(Undefined) const {}
    void operator()(bool value) const { worksheet_write_boolean(sheet, row, column, value ? 1 : 0, nullptr); }
    void operator()(std::int64_t value) const {
        worksheet_write_number(sheet, row, column, static_cast<double>(value), nullptr);
    }
    void operator()(double value) const {
        if (std::isfinite(value)) worksheet_write_number(sheet, row, column, value, nullptr);
    }
    void operator()(const Estimate& one) const { (*this)(one.value); }
    void operator()(const Bracket&) const {}
    void operator()(const Named& one) const { (*this)(one.name); }
    void operator()(const std::string& text) const {
        worksheet_write_string(sheet, row, column, text.substr(0, longest_text).c_str(), nullptr);
    }
};

/// Wide enough for the name of a column, or for a text in it.
double width_of(const DataRows& records, std::size_t column) {
    std::size_t longest = std::max<std::size_t>(records.names[column].size() + 2, 9);
    for (const std::vector<Datum>& row : records.rows)
        if (const auto* text = std::get_if<std::string>(&row[column].get())) longest = std::max(longest, text->size());
    return std::min(widest_column, 1.0 + static_cast<double>(longest));
}

void fill(lxw_worksheet* sheet, const DataRows& records, lxw_format* heading) {
    for (std::size_t k = 0; k < records.names.size(); ++k) {
        const auto column = static_cast<lxw_col_t>(k);
        worksheet_set_column(sheet, column, column, width_of(records, k), nullptr);
        worksheet_write_string(sheet, 0, column, records.names[k].c_str(), heading);
    }
    for (std::size_t row = 0; row < records.rows.size(); ++row)
        for (std::size_t k = 0; k < records.names.size(); ++k)
            std::visit(Writer{sheet, static_cast<lxw_row_t>(row + 1), static_cast<lxw_col_t>(k)},
                       records.rows[row][k].get());
    worksheet_freeze_panes(sheet, 1, 1);
    worksheet_autofilter(sheet, 0, 0, static_cast<lxw_row_t>(records.rows.size()),
                         static_cast<lxw_col_t>(records.names.size() - 1));
}

}  // namespace

void write_workbook(const std::filesystem::path& path, std::span<const Sheet> sheets) {
    for (const Sheet& sheet : sheets)
        if (sheet.records.rows.size() > most_rows)
            throw InputError(
                fmt::format("The sheet {} would have {} lines and a sheet has at most {}; --format csv "
                            "has no such limit.",
                            sheet.name, sheet.records.rows.size(), most_rows));
    const auto refuse = [&](std::string_view reason) {
        throw RunError(fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?",
                                   path.string(), reason));
    };
    if (!std::ofstream(path)) refuse(std::strerror(errno));  // of which the library would print lines of its own
    lxw_workbook* book = workbook_new(path.c_str());
    if (book == nullptr) refuse("no memory");
    lxw_format* heading = workbook_add_format(book);
    format_set_bold(heading);
    format_set_bottom(heading, LXW_BORDER_THIN);
    for (const Sheet& sheet : sheets)
        if (sheet.records.in_csv) fill(workbook_add_worksheet(book, sheet.name.c_str()), sheet.records, heading);
    if (const lxw_error error = workbook_close(book); error != LXW_NO_ERROR) refuse(lxw_strerror(error));
}

}  // namespace floes
