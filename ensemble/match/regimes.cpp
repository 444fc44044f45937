#include "match/regimes.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/design_points.hpp"
#include "keys/csv.hpp"
#include "keys/read.hpp"

namespace floes {

namespace {

constexpr const char* regime_block = "regime";

Value number_or_words(const std::string& cell) {
    const std::optional<double> number = number_in(cell);
    return number ? Value{*number} : Value{cell};
}

/// The ice of a regime, however its numbers and their order are written.
std::pair<std::string, std::map<std::string, double>> ice_of(const Regime& regime) {
    std::map<std::string, double> values;
    for (const Entry& value : regime.values) values.emplace(value.path, number_of(value.value).value());
    return {regime.case_name, values};
}

/// "thin", "thickness 0.5 m, speed 0.1 m/s": what a regime without a name is called.
std::string place_of(const Regime& regime) {
    std::string made = regime.case_name;
    for (const Entry& value : regime.values)
        made += (made.empty() ? "" : ", ") + key_words(value.path).with(to_text(value.value));
    return made;
}

Regime regime_of(const Block& block) {
    Regime regime;
    regime.where = block.where;
    double hours = -1;
    const Keys keys{text_key("name", regime.name, "", ""),
                    number_key("hours_per_year", hours, unit::one, at_least(0).at_most(leap_year_hours), "", ""),
                    text_key("case", regime.case_name, "", "")};
    for (const Entry& entry : block.entries) {
        if (entry.path.find('.') == std::string::npos)
            assign_known(keys, entry);
        else
            regime.values.push_back(entry);
    }
    if (hours < 0)
        throw InputError(fmt::format("{}: this [[regime]] has no hours_per_year; say how many hours of a year have it",
                                     block.where));
    if (regime.case_name.empty() && regime.values.empty())
        throw InputError(
            fmt::format("{}: this [[regime]] says nothing of its ice; give case = \"…\", a case of the campaign file, "
                        "or the values of its design's axes, as ice.thickness_m = 0.5",
                        block.where));
    for (const Entry& value : regime.values)
        if (!number_of(value.value))
            throw InputError(fmt::format(
                "{}: {} = {} is no number; a regime lies between the points of a design by the numbers of its axes",
                value.where, value.path, to_text(value.value)));
    regime.time = hours * unit::hour;
    if (regime.name.empty()) regime.name = place_of(regime);
    return regime;
}

void refuse_twice(const std::vector<Regime>& regimes) {
    std::map<std::string, std::string> names;
    std::map<std::pair<std::string, std::map<std::string, double>>, std::string> ices;
    for (const Regime& regime : regimes) {
        const auto [named, new_name] = names.emplace(regime.name, regime.where);
        if (!new_name)
            throw InputError(
                fmt::format("{}: {} is a regime already, at {}; give it another name, or add its hours to that one",
                            regime.where, regime.name, named->second));
        const auto [same, new_ice] = ices.emplace(ice_of(regime), regime.where);
        if (!new_ice)
            throw InputError(
                fmt::format("{}: the regime {} is the ice of another one, at {}; add its hours to that one",
                            regime.where, regime.name, same->second));
    }
}

void refuse_too_long(const std::vector<Regime>& regimes, const std::string& file) {
    double sum = 0;
    for (const Regime& regime : regimes) sum += regime.time / unit::hour;
    if (sum > leap_year_hours * (1 + rounding_of_hours))
        throw InputError(
            fmt::format("{}: the regimes have {:.6g} h together, and a year has {:g}, a leap year {:g}; hours_per_year "
                        "is of each regime alone, and open water is none",
                        file, sum, year_hours, leap_year_hours));
}

std::vector<Regime> regimes_of(const std::vector<Block>& blocks, const std::string& file) {
    std::vector<Regime> regimes;
    for (const Block& block : blocks) regimes.push_back(regime_of(block));
    refuse_twice(regimes);
    refuse_too_long(regimes, file);
    std::erase_if(regimes, [](const Regime& regime) { return regime.time == 0; });
    if (regimes.empty())
        throw InputError(
            fmt::format("{}: no regime has any hours; write [[regime]] with hours_per_year, and a case or values of "
                        "axes, for each kind of ice",
                        file));
    return regimes;
}

}  // namespace

std::vector<Regime> read_regimes(std::string_view text, const std::string& file) {
    const Document document = parse_document(text, file);
    if (!document.entries.empty())
        throw InputError(fmt::format("{}: {} = {} is in no regime; begin each one with [[regime]], in double brackets",
                                     document.entries.front().where, document.entries.front().path,
                                     to_text(document.entries.front().value)));
    for (const Block& block : document.blocks)
        if (block.path != regime_block)
            throw InputError(
                fmt::format("{}: [[{}]] is not a table of regimes; did you mean [[regime]]?", block.where, block.path));
    return regimes_of(document.blocks, file);
}

std::vector<Regime> read_regime_table(std::string_view text, const std::string& file) {
    const std::vector<CsvLine> lines = csv_lines(text, file);
    if (lines.empty())
        throw InputError(
            fmt::format("{}: the table is empty; its first line names the columns: regime, hours_per_year, and case or "
                        "axes of the design",
                        file));
    std::vector<std::string> columns = lines.front().cells;
    const auto regime = std::ranges::find(columns, "regime");
    if (regime != columns.end() && std::ranges::find(columns, "name") != columns.end())
        throw InputError(fmt::format("{}:{}: the columns regime and name are both the regime's name; keep one", file,
                                     lines.front().number));
    if (regime != columns.end()) *regime = "name";
    std::vector<Block> blocks;
    for (std::size_t row = 1; row < lines.size(); ++row) {
        const std::string where = fmt::format("{}:{}", file, lines[row].number);
        if (lines[row].cells.size() != columns.size())
            throw InputError(fmt::format("{}: the line has {} cells, and the header has {} columns", where,
                                         lines[row].cells.size(), columns.size()));
        Block& block = blocks.emplace_back(Block{regime_block, where, {}});
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (lines[row].cells[k].empty()) continue;
            const bool words = columns[k] == "name" || columns[k] == "case";
            block.entries.push_back(
                {columns[k], words ? Value{lines[row].cells[k]} : number_or_words(lines[row].cells[k]), where});
        }
    }
    return regimes_of(blocks, file);
}

}  // namespace floes
