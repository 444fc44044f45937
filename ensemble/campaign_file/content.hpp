#pragma once
// A campaign file as it is written: where the values of members lie in its rows, which are as wide as all cases
// together need, and the datasets that take one member after another. For this module only.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/campaign_table.hpp"
#include "campaign_file/pieces.hpp"
#include "core/units.hpp"
#include "hdf5/columns.hpp"
#include "hdf5/dataset.hpp"
#include "member/array_output.hpp"
#include "store/member_record.hpp"
#include "store/session.hpp"

namespace floes {

// Columns of what a file lists beside its members, with the field that each holds, as they are written and read again.

template <class Row, class Value>
struct FiledColumn {
    const char* name;
    const char* unit;
    const char* long_name;
    Value Row::*field;
};
template <class Row, class Value>
FiledColumn(const char*, const char*, const char*, Value Row::*) -> FiledColumn<Row, Value>;

/// In /provenance, beside session_software, which is made of several fields.
inline constexpr std::tuple session_columns{
    FiledColumn{"session_started", "1", "begin of the session, UTC", &Session::started},
    FiledColumn{"session_ended", "1", "end of the session, UTC; empty when killed or at work", &Session::ended},
    FiledColumn{"session_outcome", "1", "how the session ended", &Session::outcome},
    FiledColumn{"session_host", "1", "host of rank 0", &Session::host},
    FiledColumn{"session_machine", "1", "system and processor of rank 0", &Session::machine},
    FiledColumn{"session_job", "1", "batch job", &Session::job},
    FiledColumn{"session_ranks", "1", "ranks of the session", &Session::ranks},
    FiledColumn{"session_threads", "1", "threads over all ranks of the session", &Session::threads},
    FiledColumn{"session_reused", "1", "members that had their result, or stood aside, before the session",
                &Session::reused},
    FiledColumn{"session_retried", "1", "members that failed or were lost before and were tried again",
                &Session::retried},
    FiledColumn{"session_computed", "1", "members done in the session", &Session::computed},
    FiledColumn{"session_set_aside", "1", "members given up in the session", &Session::set_aside}};

/// In /calibration, beside case.
inline constexpr std::tuple calibration_columns{
    FiledColumn{"sheet", "m", "side of the square sheet", &CurvePoint::sheet},
    FiledColumn{"element", "m", "side of its elements", &CurvePoint::element},
    FiledColumn{"thickness", "m", "thickness of the sheet", &CurvePoint::thickness},
    FiledColumn{"time_step", "s", "time step", &CurvePoint::time_step},
    FiledColumn{"erp", "1", "error reduction parameter of the joints (Gamma)", &CurvePoint::erp},
    FiledColumn{"iterations", "1", "iterations of the solver a step", &CurvePoint::iterations},
    FiledColumn{"cfm", "1", "constraint force mixing of the joints (Sigma)", &CurvePoint::cfm},
    FiledColumn{"slope", "N m-1", "load over deflection at the centre", &CurvePoint::slope},
    FiledColumn{"elastic_modulus", "Pa", "elastic modulus shown, load on a patch", &CurvePoint::elastic_modulus},
    FiledColumn{"elastic_modulus_point", "Pa", "elastic modulus shown, as if the load were a point",
                &CurvePoint::elastic_modulus_point}};

/// In /provenance of a file over pieces, beside their names.
inline constexpr std::tuple piece_columns{
    FiledColumn{"piece_digest", "1", "contents_digest of the piece", &FilePiece::digest},
    FiledColumn{"piece_first", "1", "first arrangement number in the piece", &FilePiece::first},
    FiledColumn{"piece_count", "1", "arrangement numbers in the piece", &FilePiece::count}};

/// A column of what `of` says of each of the rows.
template <class Rows, class Of>
void write_column(hid_t group, const hdf5::Label& label, const hdf5::Scale& scale, const Rows& rows, Of of) {
    std::vector<std::decay_t<std::invoke_result_t<Of, const std::ranges::range_value_t<Rows>&>>> values;
    for (const auto& row : rows) values.push_back(std::invoke(of, row));
    hdf5::write_values(group, label, {scale}, values);
}

template <class Rows, class Columns>
void write_columns(hid_t group, const hdf5::Scale& scale, const Rows& rows, const Columns& columns) {
    const auto write = [&](const auto& column) {
        write_column(group, {column.name, column.unit, column.long_name}, scale, rows, column.field);
    };
    std::apply([&](const auto&... column) { (write(column), ...); }, columns);
}

template <class Row, class Value>
void read_column(hid_t file, const std::string& group, const FiledColumn<Row, Value>& column, std::vector<Row>& rows) {
    const std::string name = group + "/" + column.name;
    std::vector<Value> all;
    if constexpr (std::is_same_v<Value, std::string>)
        all = hdf5::read_texts(file, name, rows.size());
    else
        all = hdf5::read_column<Value>(file, name, rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].*column.field = all[k];
}

/// Fills the columns' fields of the rows, of which there are as many as the file has.
template <class Row, class Columns>
void read_columns(hid_t file, const std::string& group, const Columns& columns, std::vector<Row>& rows) {
    std::apply([&](const auto&... column) { (read_column(file, group, column, rows), ...); }, columns);
}

/// An axis in a file.
struct FiledAxis {
    std::vector<double> places;                       ///< none of axes that members find
    std::vector<std::size_t> own_sizes;               ///< by case; likewise
    std::vector<std::vector<std::size_t>> positions;  ///< by case: of its own places; empty: they are the first ones
    bool alike = true;                                ///< the places of each case are the first ones
};

class ArrayPlaces {
  public:
    explicit ArrayPlaces(const Campaign& campaign);

    const FiledAxis& axis(const ArrayAxis& axis) const { return axes_.at(&axis); }

    /// Sizes of the array in a member of the case; 0 along the axes that members find.
    std::vector<std::size_t> own_sizes(const ArrayOutput& array, int case_index) const;

    /// The member's values in a row of these sizes, NaN elsewhere.
    std::vector<double> row(const ArrayOutput& array, int case_index, const ArrayValues& own,
                            std::span<const std::size_t> sizes) const;

    /// The way back. Where all are NaN, the member does not have the array.
    ArrayValues own(const ArrayOutput& array, int case_index, std::span<const double> row,
                    std::span<const std::size_t> sizes) const;

  private:
    template <class Use>
    void for_each_place(const ArrayOutput& array, int case_index, std::span<const std::size_t> own,
                        std::span<const std::size_t> sizes, const Use& use) const;

    std::map<const ArrayAxis*, FiledAxis> axes_;
};

// What of a campaign file has to do with single members: datasets that take one member after another, so that only one
// record is in memory at a time. For this module only.

/// A member on its way into the file.
struct FiledMember {
    std::size_t number = 0;
    std::size_t place = 0;                 ///< row of the file
    const MemberRecord* record = nullptr;  ///< nullptr where there is none
    const MemberRow& row;
};

class MemberTables {
  public:
    /// A table with a finish(), and what it takes: write(table, member) is called for each member, in member order.
    template <class Table, class Write>
    void add(std::shared_ptr<Table> table, Write write) {
        tables_.push_back({[table, write](const FiledMember& member) mutable { write(*table, member); },
                           [table] { table->finish(); }});
    }
    /// The same of a table with a write(member) of its own.
    template <class Table>
    void add(std::shared_ptr<Table> table) {
        add(table, [](Table& own, const FiledMember& member) { own.write(member); });
    }

    /// A dataset of numbers: of(member) is a value, or a row of them. `missing`: a value, or flags.
    template <class Value, class Missing, class Function>
    void add_numbers(hid_t group, const hdf5::Label& label, const hdf5::Dimensions& dimensions, const Missing& missing,
                     Function of) {
        add(std::make_shared<hdf5::Column<Value>>(group, label, dimensions, missing),
            [of](hdf5::Column<Value>& column, const FiledMember& member) { column.add(of(member)); });
    }

    /// A dataset of texts.
    template <class Function>
    void add_texts(hid_t group, const hdf5::Label& label, const hdf5::Dimensions& dimensions, Function of) {
        add(std::make_shared<hdf5::TextColumn>(group, label, dimensions),
            [of](hdf5::TextColumn& column, const FiledMember& member) { column.add(of(member)); });
    }

    void write(const FiledMember& member) const {
        for (const Table& table : tables_) table.write(member);
    }

    /// After the last member.
    void finish() const {
        for (const Table& table : tables_) table.finish();
    }

  private:
    struct Table {
        std::function<void(const FiledMember&)> write;
        std::function<void()> finish;
    };
    std::vector<Table> tables_;
};

// What the parts of a campaign file are made of, and the functions that write them. For this module only.

struct CampaignContent {
    /// Of a whole campaign.
    CampaignContent(const Campaign& of, const StoredMembers& all_members);
    /// Of a piece.
    CampaignContent(const Campaign& of, const StoredMembers& its_members, PieceRows piece);
    /// Of a file whose rows lie in these pieces, which have all arrangements in order. `most`: as PieceRows has it.
    CampaignContent(const Campaign& of, std::span<const FilePiece> its_pieces, const FoundSizes& most);

    const Campaign& campaign;
    const StoredMembers* members = nullptr;           ///< none where the rows lie in pieces
    std::span<const FilePiece> pieces;                ///< none of a file with its own rows
    int first = 0;                                    ///< arrangement of the first row
    int count = 0;                                    ///< of the arrangements in rows
    std::vector<std::optional<std::size_t>> records;  ///< by row: number of its record; none where there is none
    std::vector<int> attempts;                        ///< by row
    MemberRows rows;
    ArrayPlaces places;

    const CampaignCases& table() const { return rows.cases(); }
    bool is_piece() const { return is_piece_; }
    /// Of members.
    std::size_t first_row() const { return static_cast<std::size_t>(first) * campaign.cases.size(); }
    std::size_t member_rows() const { return static_cast<std::size_t>(count) * campaign.cases.size(); }
    /// The note of the member in that row, which has a record.
    const MemberNote& note(std::size_t row) const { return members->notes()[*records[row]]; }
    /// For an axis that members find: how far it goes in the file.
    std::size_t found(const ArrayAxis& axis) const;
    /// Where the rows lie along that axis, by the rows of each piece.
    template <class Rows>
    void lies_in_pieces(hdf5::Scale& scale, const Rows& rows_of) const {
        std::vector<hdf5::RowSource> sources;
        for (const FilePiece& piece : pieces) sources.push_back({piece.file, rows_of(piece)});
        scale.lies_in(std::move(sources));
    }
    /// Whether the file has the array: none of its axes is without places.
    bool has(const ArrayOutput& array) const;

  private:
    /// Of the members in rows of its own.
    void find_sizes();

    bool is_piece_ = false;
    FoundSizes found_{};
};

/// The dimensions at the root: only there do netCDF readers find them from every group.
class CampaignScales {
  public:
    CampaignScales(hid_t file, const CampaignContent& content);

    const hdf5::Scale& along(const ArrayAxis& axis) const { return axes_.at(&axis); }

    hdf5::Scale member;
    hdf5::Scale case_;
    hdf5::Scale arrangement;
    hdf5::Scale profile_point;

  private:
    std::map<const ArrayAxis*, hdf5::Scale> axes_;
};

// These make datasets that are filled as `tables` get one member after another.

/// Quantities and states, a row for each member.
void add_members(hid_t group, const CampaignScales& scales, MemberTables& tables);
/// Those arrays of members that lie in the group of that name. `checksums`: the group that takes those of rows, in a
/// piece; else nullptr.
void add_arrays(hid_t group, std::string_view name, const CampaignContent& content, const CampaignScales& scales,
                MemberTables& tables, const std::shared_ptr<const hdf5::Handle>& checksums);
/// The group of a piece that has the checksums of rows, and what they are called there.
inline constexpr const char* checksums_group = "row_checksums";
std::string checksums_name(std::string_view path);
/// The number of each arrangement.
void add_arrangement_numbers(hid_t group, const CampaignContent& content, const CampaignScales& scales,
                             MemberTables& tables);
/// /provenance, with all that is not of members.
void add_provenance(hid_t file, const CampaignContent& content, std::span<const Session> sessions,
                    MemberTables& tables);

// These write what is not of members.

void write_cases(hid_t file, const CampaignContent& content, const CampaignScales& scales);
/// Nothing where no case was calibrated.
void write_calibration(hid_t file, const CampaignContent& content, std::span<const CalibrationRecord> calibrations);

}  // namespace floes
