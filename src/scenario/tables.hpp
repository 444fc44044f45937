#pragma once
// The keys of each table of a scenario; describe() strings them together.

#include <functional>
#include <utility>
#include <vector>

#include "keys/key.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// One number of a record, as a column of a key's rows.
template <class Record>
struct RecordColumn {
    Column column;
    std::function<double&(Record&)> number;
};

/// Rows bound to records, a row for each.
template <class Record>
RowsField rows_of(std::vector<Record>& records, std::vector<RecordColumn<Record>> columns) {
    RowsField field;
    for (const auto& one : columns) field.columns.push_back(one.column);
    field.get = [&records, columns] {
        std::vector<std::vector<double>> rows(records.size());
        for (std::size_t k = 0; k < rows.size(); ++k)
            for (const auto& one : columns) rows[k].push_back(one.number(records[k]));
        return rows;
    };
    field.set = [&records, columns = std::move(columns)](const std::vector<std::vector<double>>& rows) {
        records.assign(rows.size(), {});
        for (std::size_t k = 0; k < rows.size(); ++k)
            for (std::size_t c = 0; c < columns.size(); ++c) columns[c].number(records[k]) = rows[k][c];
    };
    return field;
}

void add_general(Keys& keys, General& general);
void add_ice(Keys& keys, FloeShape& floe, Ice& ice, const Joint& joint);
void add_floe(Keys& keys, FloeShape& floe);
void add_elements(Keys& keys, Elements& elements, const Joint& joint);
void add_joint(Keys& keys, Joint& joint);
void add_field(Keys& keys, Field& field);
void add_arrangement(Keys& keys, ArrangementRule& arrangement);
void add_structure(Keys& keys, Structure& structure);
void add_hull(Keys& keys, Structure& structure);
void add_path(Keys& keys, Path& path);
void add_moorings(Keys& keys, Moorings& moorings);
void add_contact(Keys& keys, ContactLaw& contact);
void add_water(Keys& keys, Water& water);
void add_wind(Keys& keys, Wind& wind);
void add_analysis(Keys& keys, Analysis& analysis);
void add_sizes(Keys& keys, Sizes& sizes);
void add_shapes(Keys& keys, Shapes& shapes);
void add_spread(Keys& keys, IceSpread& spread);
void add_brine(Keys& keys, Brine& brine);
void add_paper(Keys& keys, Scenario& scenario);

}  // namespace floes
