#include "draw/explore_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "draw/page_parts.hpp"
#include "findings/conditions.hpp"
#include "findings/evidence.hpp"
#include "member/quantity.hpp"

namespace floes {

namespace {

using nlohmann::json;

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

/// A value of each done member, as the page shows it.
struct Column {
    std::string key;
    std::string words;  ///< "mean load"
    std::string unit;
    std::string about;                         ///< a sentence's worth; may be empty
    std::string kind;                          ///< "place", "input" or "quantity"
    bool logarithmic = false;                  ///< its axis at first
    std::vector<std::string> categories = {};  ///< its values are places in this list; empty: they are numbers
    std::vector<float> values = {};

    bool varies() const {
        float first = nothing;
        for (const float value : values) {
            if (std::isnan(value)) continue;
            if (std::isnan(first)) first = value;
            if (value != first) return true;
        }
        return false;
    }
};

/// Done members, in member order.
std::vector<std::size_t> done_members(const Evidence& evidence) {
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < evidence.table.members.size(); ++k)
        if (evidence.table.members[k].done()) done.push_back(k);
    return done;
}

/// Case, arrangement and number. Of many cases each is a point of a design, which the inputs tell better.
std::vector<Column> places(const Evidence& evidence, const std::vector<std::size_t>& done) {
    constexpr std::size_t most_cases_by_name = 40;
    std::vector<Column> columns;
    if (const std::size_t cases = evidence.table.cases.size(); cases > 1 && cases <= most_cases_by_name) {
        Column& of_case = columns.emplace_back(Column{"case", "case", "", "", "place"});
        for (std::size_t k = 0; k < cases; ++k) of_case.categories.push_back(evidence.summary.name_of(k));
        for (const std::size_t member : done)
            of_case.values.push_back(static_cast<float>(evidence.sample.case_of(member)));
    }
    Column& arrangement = columns.emplace_back(Column{"arrangement", "arrangement", "", "", "place"});
    for (const std::size_t member : done)
        arrangement.values.push_back(static_cast<float>(evidence.sample.number_of(member)));
    if (!arrangement.varies()) columns.pop_back();
    Column& number = columns.emplace_back(Column{"member", "member's number", "", "", "place"});
    for (const std::size_t member : done) number.values.push_back(static_cast<float>(member));
    return columns;
}

Column column_of(const VariedInput& input, const Evidence& evidence, const std::vector<std::size_t>& done) {
    Column column{input.key, input.words.name, input.words.unit, input.key, "input", input.logarithmic};
    const bool numeric = input.numeric();
    std::vector<float> by_case;
    for (const auto& value : input.values) {
        const auto* number = std::get_if<double>(&value);
        if (numeric) {
            by_case.push_back(number == nullptr ? nothing : static_cast<float>(*number));
            continue;
        }
        const std::string words = number == nullptr ? std::get<std::string>(value) : fmt::format("{:g}", *number);
        if (words.empty()) {
            by_case.push_back(nothing);
            continue;
        }
        const auto found = std::ranges::find(column.categories, words);
        by_case.push_back(static_cast<float>(found - column.categories.begin()));
        if (found == column.categories.end()) column.categories.push_back(words);
    }
    for (const std::size_t member : done) column.values.push_back(by_case[evidence.sample.case_of(member)]);
    return column;
}

/// "sd_load" as people read it: "SD load".
std::string words_of(const Quantity& quantity) {
    std::string words{quantity.key.view()};
    std::ranges::replace(words, '_', ' ');
    if (words.starts_with("sd ")) words.replace(0, 2, "SD");
    return words;
}

Column column_of(const Quantity& quantity, const Evidence& evidence, const std::vector<std::size_t>& done) {
    const Units::Shown shown = evidence.units.of(quantity.percent ? "share" : quantity.unit);
    Column column{std::string{quantity.key.view()}, words_of(quantity), shown.name, std::string{quantity.long_name},
                  "quantity"};
    for (const std::size_t member : done)
        column.values.push_back(static_cast<float>(shown.factor * evidence.table.members[member].value(quantity)));
    return column;
}

struct Columns {
    std::vector<Column> shown;
    std::vector<std::string> alike;     ///< words of quantities that are the same in all members, or in none
    std::vector<std::string> left_out;  ///< words of those that did not fit
};

Columns columns_of(const Evidence& evidence, const std::vector<std::size_t>& done, std::size_t most_values) {
    Columns columns{places(evidence, done), {}, {}};
    for (const VariedInput& input : varied_inputs(evidence.campaign))
        columns.shown.push_back(column_of(input, evidence, done));
    std::vector<Quantity> quantities = evidence.table.quantities();
    std::ranges::stable_sort(quantities, std::ranges::greater{}, &Quantity::shown);
    for (const Quantity& quantity : quantities) {
        Column column = column_of(quantity, evidence, done);
        if (!column.varies() && done.size() > 1) {
            columns.alike.push_back(column.words);
        } else if ((columns.shown.size() + 1) * done.size() > most_values && quantity.shown < Shown::in_headlines) {
            columns.left_out.push_back(column.words);
        } else {
            columns.shown.push_back(std::move(column));
        }
    }
    return columns;
}

Bytes packed(const std::vector<Column>& columns) {
    Deflater all;
    for (const Column& column : columns) {
        Bytes bytes;
        for (const float value : column.values) put(bytes, value);
        all.add(bytes);
    }
    return all.finish();
}

Bytes packed_members(const Evidence& evidence, const std::vector<std::size_t>& done) {
    Bytes bytes;
    for (const std::size_t member : done) put(bytes, static_cast<std::int32_t>(member));
    for (const std::size_t member : done) put(bytes, static_cast<std::int32_t>(evidence.sample.case_of(member)));
    return deflated(bytes);
}

/// Least and largest of each part of every member's surge load.
struct Histories {
    std::size_t parts = 0;
    std::size_t kept = 0;           ///< members that have one
    double quantum = 1;             ///< as the page shows loads
    bool thinned = false;           ///< some part holds more than one value
    std::vector<float> extremes;    ///< a member: 2 parts; NaN where it kept none
    std::vector<double> ends = {};  ///< of each case: s; 0 where none is kept
};

Histories histories_of(const Evidence& evidence, const CampaignFile& file, const std::vector<std::size_t>& done,
                       std::size_t most_parts) {
    constexpr std::size_t fewest = 8;
    constexpr std::size_t most = 500;
    Histories found;
    found.parts = std::clamp(most_parts / done.size(), fewest, most);
    found.extremes.assign(2 * found.parts * done.size(), nothing);
    found.ends.assign(evidence.table.cases.size(), 0);
    const double factor = evidence.units.of("N").factor;
    double largest = 0;
    for_each_history(file, [&](const StoredHistory& history) {
        const auto place = std::ranges::lower_bound(done, static_cast<std::size_t>(history.member)) - done.begin();
        if (history.values.empty()) return;
        const std::size_t count = history.values.size();
        found.thinned = found.thinned || count > found.parts;
        found.ends[evidence.case_of(history.member)] = history.step * static_cast<double>(count);
        for (std::size_t part = 0; part < found.parts; ++part) {
            const std::size_t from = std::min(part * count / found.parts, count - 1);
            const std::size_t to = std::max(from + 1, (part + 1) * count / found.parts);
            const auto [least, most_of_it] = std::ranges::minmax(history.values.subspan(from, to - from));
            float* at = &found.extremes[2 * (static_cast<std::size_t>(place) * found.parts + part)];
            at[0] = static_cast<float>(factor * least);
            at[1] = static_cast<float>(factor * most_of_it);
            largest = std::max({largest, std::abs(factor * least), std::abs(factor * most_of_it)});
        }
        ++found.kept;
    });
    found.quantum = std::max(largest, 1e-9) / 32767;
    return found;
}

Bytes packed(const Histories& histories) {
    Bytes bytes;
    bytes.reserve(2 * histories.extremes.size());
    for (const float value : histories.extremes)
        put(bytes, std::isnan(value) ? std::int16_t{-32768}
                                     : static_cast<std::int16_t>(std::clamp(std::lround(value / histories.quantum),
                                                                            long{-32767}, long{32767})));
    return deflated(bytes);
}

/// Its names are read by page_assets/explore_data.js.
std::string header(const Evidence& evidence, const Columns& columns, const Histories& histories,
                   const std::string& file) {
    const MemberCounts counts = evidence.summary.counts();
    json about = json::array();
    for (const Column& column : columns.shown)
        about.push_back({{"key", column.key},
                         {"words", column.words},
                         {"unit", column.unit},
                         {"about", column.about},
                         {"kind", column.kind},
                         {"log", column.logarithmic},
                         {"categories", column.categories}});
    json cases = json::array();
    json windows = json::array();
    for (std::size_t k = 0; k < evidence.table.cases.size(); ++k) {
        const Analysis& analysis = evidence.table.cases[k].analysis;
        cases.push_back(evidence.summary.label_of(k));
        windows.push_back({analysis.steady_start, analysis.steady_start + analysis.window});
    }
    json failed = json::array();
    for (const SetAside& one : evidence.summary.failed) failed.push_back({{"member", one.member}, {"why", one.reason}});
    const json all{{"title", evidence.summary.title},
                   {"file", file},
                   {"done", counts.done},
                   {"missing", counts.missing_members},
                   {"failed", failed},
                   {"cases", cases},
                   {"columns", about},
                   {"alike", columns.alike},
                   {"left_out", columns.left_out},
                   {"history",
                    {{"parts", histories.parts},
                     {"kept", histories.kept},
                     {"thinned", histories.thinned},
                     {"quantum", histories.quantum},
                     {"unit", evidence.units.of("N").name},
                     {"ends", histories.ends},
                     {"windows", windows}}}};
    return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

void write_explore_page(std::ostream& page, const Evidence& evidence, const CampaignFile& file,
                        const ExploreOptions& options) {
    const std::vector<std::size_t> done = done_members(evidence);
    if (done.empty())
        throw InputError(fmt::format("No member of {} is done; there is nothing to explore yet.", options.file));
    const Columns columns = columns_of(evidence, done, options.most_values);
    const Histories histories = histories_of(evidence, file, done, options.most_parts);
    expand(
        asset("explore.html").value(), [&](std::string_view text) { page << text; },
        [&](std::string_view name) {
            if (name == "title") {
                page << markup_escaped(evidence.summary.title);
            } else if (name == "header") {
                page << in_a_script(header(evidence, columns, histories, options.file));
            } else if (name == "streams") {
                write_stream(page, "members", packed_members(evidence, done));
                write_stream(page, "columns", packed(columns.shown));
                write_stream(page, "history", histories.kept > 0 ? packed(histories) : Bytes{});
            } else {
                page << asset(name).value();
            }
        });
}

}  // namespace floes
