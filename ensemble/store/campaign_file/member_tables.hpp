#pragma once
// What of a campaign file has to do with single members: datasets that take one member after another, so that only one
// record is in memory at a time. For this room only.

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "hdf5/column.hpp"

namespace floes {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A member on its way into the file.
struct FiledMember {
    std::size_t number = 0;
    const MemberRecord* record = nullptr;  ///< nullptr where there is none
    const MemberRow& row;

    /// The result of a done member, else nullptr: of a failed one nothing stands in the file but that it failed.
    const MemberResult* done() const { return row.done() ? &record->result : nullptr; }
};

class MemberTables {
  public:
    /// A table with a finish(), and what it takes: write(table, member) is called for each member, in member order.
    template <class Table, class Write>
    void add(std::shared_ptr<Table> table, Write write) {
        tables_.push_back(
            {[table, write](const FiledMember& member) { write(*table, member); }, [table] { table->finish(); }});
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

}  // namespace floes
