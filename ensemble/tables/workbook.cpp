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

    void operator()(const auto&) const {}  // none, or an estimate, which has columns of its own
    void operator()(bool value) const { worksheet_write_boolean(sheet, row, column, value ? 1 : 0, nullptr); }
    void operator()(std::int64_t value) const {
        worksheet_write_number(sheet, row, column, static_cast<double>(value), nullptr);
    }
    void operator()(double value) const {
        if (std::isfinite(value)) worksheet_write_number(sheet, row, column, value, nullptr);
    }
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

/// Writes the front sheet from its first line on.
class FrontWriter {
  public:
    FrontWriter(lxw_workbook* book, const Units& units, lxw_format* heading)
        : book_(book), units_(units), heading_(heading) {}

    void write(const FrontSheet& front) {
        sheet_ = workbook_add_worksheet(book_, front.name.c_str());
        name_ = front.name;
        sentences(front.above);
        if (!front.table.rows.empty()) table(front.table);
        sentences(front.below);
    }

  private:
    static constexpr double width = 16;
    static constexpr lxw_row_t chart_height = 19;

    void sentences(const std::vector<std::string>& all) {
        for (const std::string& one : all) worksheet_write_string(sheet_, row_++, 0, one.c_str(), nullptr);
        ++row_;
    }

    void table(const Results& table) {
        const lxw_row_t first = row_ + 1;
        lxw_col_t cell = 0;
        std::string charted;
        lxw_chart* chart = workbook_add_chart(book_, LXW_CHART_COLUMN);
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            const ResultColumn& column = table.columns[k];
            if (column.words.empty()) continue;
            const bool estimates = column.holds == ResultColumn::Holds::estimates;
            const Units::Shown unit = units_.of(column.unit);
            const std::string words = units_.heading(column.words, column.unit);
            lxw_format* format = number_format(table, k, unit.factor);
            worksheet_set_column(sheet_, cell, cell, std::max(width, 2.0 + static_cast<double>(words.size())), nullptr);
            worksheet_write_string(sheet_, row_, cell, words.c_str(), heading_);
            if (estimates) worksheet_write_string(sheet_, row_, static_cast<lxw_col_t>(cell + 1), "± (95 %)", heading_);
            for (std::size_t r = 0; r < table.rows.size(); ++r)
                value(table.rows[r][k], first + static_cast<lxw_row_t>(r), cell, unit.factor, format);
            if (estimates && column.form != ResultColumn::Form::difference &&
                (charted.empty() || charted == column.unit)) {
                charted = column.unit;
                series(chart, first, first + static_cast<lxw_row_t>(table.rows.size()) - 1, cell);
                chart_axis_set_name(chart->y_axis, unit.name.c_str());
            }
            cell = static_cast<lxw_col_t>(cell + (estimates ? 2 : 1));
        }
        row_ = first + static_cast<lxw_row_t>(table.rows.size()) + 1;
        if (charted.empty()) return;
        worksheet_insert_chart(sheet_, row_, 0, chart);
        row_ += chart_height;
    }

    /// Digits that give the largest value of the column about three.
    lxw_format* number_format(const Results& table, std::size_t column, double factor) {
        double largest = 0;
        for (const std::vector<Datum>& row : table.rows)
            if (const auto* one = std::get_if<Estimate>(&row[column].get());
                one != nullptr && std::isfinite(one->value))
                largest = std::max(largest, factor * std::abs(one->value));
        const int decimals = largest > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 6) : 0;
        lxw_format* made = workbook_add_format(book_);
        format_set_num_format(made, decimals == 0 ? "0" : fmt::format("0.{:0>{}}", "", decimals).c_str());
        return made;
    }

    void value(const Datum& one, lxw_row_t row, lxw_col_t cell, double factor, lxw_format* format) {
        const auto number = [&](double value, lxw_col_t place) {
            if (std::isfinite(value)) worksheet_write_number(sheet_, row, place, factor * value, format);
        };
        if (const auto* estimate = std::get_if<Estimate>(&one.get())) {
            number(estimate->value, cell);
            if (estimate->said) number(estimate->longer_side(), static_cast<lxw_col_t>(cell + 1));
        } else if (const auto* plain = std::get_if<double>(&one.get())) {
            number(*plain, cell);
        } else if (const auto* named = std::get_if<Named>(&one.get())) {
            worksheet_write_string(sheet_, row, cell, named->label.c_str(), nullptr);
        } else if (const auto* range = std::get_if<Bracket>(&one.get())) {
            if (range->said)
                worksheet_write_string(
                    sheet_, row, cell,
                    fmt::format("[{:.4g}, {:.4g}]", factor * range->limits.low, factor * range->limits.high).c_str(),
                    nullptr);
        } else if (const auto* none = std::get_if<Undefined>(&one.get())) {
            if (!none->why.empty()) worksheet_write_string(sheet_, row, cell, none->why.c_str(), nullptr);
        } else {
            std::visit(Writer{sheet_, row, cell}, one.get());
        }
    }

    void series(lxw_chart* chart, lxw_row_t first, lxw_row_t last, lxw_col_t cell) {
        lxw_chart_series* made = chart_add_series(chart, nullptr, nullptr);
        chart_series_set_categories(made, name_.c_str(), first, 0, last, 0);
        chart_series_set_values(made, name_.c_str(), first, cell, last, cell);
        chart_series_set_name_range(made, name_.c_str(), first - 1, cell);
    }

    lxw_workbook* book_;
    const Units& units_;
    lxw_format* heading_;
    lxw_worksheet* sheet_ = nullptr;
    std::string name_;
    lxw_row_t row_ = 0;
};

}  // namespace

void write_workbook(const std::filesystem::path& path, std::span<const Sheet> sheets, const Units& units,
                    const FrontSheet* front) {
    for (const Sheet& sheet : sheets)
        if (sheet.records.rows.size() > most_rows)
            throw InputError(fmt::format(
                "The sheet {} would have {} lines and a sheet has at most {}; --format csv has no such limit.",
                sheet.name, sheet.records.rows.size(), most_rows));
    const auto refuse = [&](std::string_view reason) {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
        throw RunError(fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?",
                                   path.string(), reason));
    };
    if (!std::ofstream(path)) refuse(std::strerror(errno));  // of which the library would print lines of its own
    lxw_workbook* book = workbook_new(path.c_str());
    if (book == nullptr) refuse("no memory");
    lxw_format* heading = workbook_add_format(book);
    format_set_bold(heading);
    format_set_bottom(heading, LXW_BORDER_THIN);
    if (front != nullptr) FrontWriter(book, units, heading).write(*front);
    for (const Sheet& sheet : sheets)
        if (sheet.records.in_csv) fill(workbook_add_worksheet(book, sheet.name.c_str()), sheet.records, heading);
    if (const lxw_error error = workbook_close(book); error != LXW_NO_ERROR) refuse(lxw_strerror(error));
}

}  // namespace floes
