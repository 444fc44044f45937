// The arrays of members in a campaign file, by their list.

#include <algorithm>
#include <memory>
#include <set>

#include "campaign_file/campaign_content.hpp"
#include "hdf5/rows.hpp"

namespace floes {
namespace {

/// An array that lies in a row for each member.
class MemberArray {
  public:
    MemberArray(hid_t group, const ArrayOutput& array, const CampaignContent& content, const hdf5::Label& label,
                const hdf5::Scale& member, const hdf5::Dimensions& axes)
        : array_(array), number_(array_number(array.path)), places_(content.places) {
        for (const hdf5::Scale& one : axes) sizes_.push_back(one.size());
        if (array.chunks == ArrayChunks::of_its_own) {
            rows_.emplace(group, label, member, axes);
        } else {
            hdf5::Dimensions all{member};
            all.insert(all.end(), axes.begin(), axes.end());
            column_.emplace(group, label, all, nan);
        }
    }

    void write(const FiledMember& member) {
        const PackedArray packed = member.row.done() ? member.record->array(number_) : PackedArray{};
        if (rows_ && packed.empty()) return;
        if (rows_ && packed.sizes == sizes_) return rows_->write(member.number, packed.numbers);
        const std::vector<double> row = places_.row(array_, member.row.case_index, unpack(packed), sizes_);
        if (rows_) return rows_->write(member.number, row);
        column_->add(row);
    }

    void finish() {
        if (rows_) rows_->finish();
        if (column_) column_->finish();
    }

  private:
    const ArrayOutput& array_;
    std::size_t number_;
    const ArrayPlaces& places_;
    std::vector<std::size_t> sizes_;
    std::optional<hdf5::Rows> rows_;
    std::optional<hdf5::Column<double>> column_;
};

/// An array that is the same in all members of an arrangement: they come one after another.
class ArrangementArray {
  public:
    ArrangementArray(hid_t group, const ArrayOutput& array, const CampaignContent& content, const hdf5::Label& label,
                     const hdf5::Scale& arrangement, const hdf5::Dimensions& axes)
        : array_(array),
          number_(array_number(array.path)),
          places_(content.places),
          rows_(content.rows.arrangements()),
          column_(group, label, with(arrangement, axes), nan) {
        for (const hdf5::Scale& one : axes) {
            sizes_.push_back(one.size());
            width_ *= one.size();
        }
        begin(0);
    }

    void write(const FiledMember& member) {
        const int row = member.row.arrangement;
        if (rows_.number(row) != rows_.number(first_)) {
            column_.add(values_);
            begin(row - row % rows_.groups());
        }
        if (member.record == nullptr || member.record->array(poses_).empty()) return;
        const ArrayValues own = unpack(member.record->array(number_));
        const std::vector<double> placed = places_.row(array_, member.row.case_index, own, sizes_);
        std::ranges::copy(
            placed, values_.begin() + static_cast<std::ptrdiff_t>(width_ * static_cast<std::size_t>(row - first_)));
    }

    void finish() {
        column_.add(values_);
        column_.finish();
    }

  private:
    static hdf5::Dimensions with(const hdf5::Scale& first, const hdf5::Dimensions& others) {
        hdf5::Dimensions all{first};
        all.insert(all.end(), others.begin(), others.end());
        return all;
    }

    void begin(int row) {
        first_ = row;
        values_.assign(static_cast<std::size_t>(rows_.groups()) * width_, nan);
    }

    static constexpr std::size_t poses_ = array_number("arrangements/pose");

    const ArrayOutput& array_;
    std::size_t number_;
    const ArrayPlaces& places_;
    const ArrangementRows& rows_;
    std::vector<std::size_t> sizes_;
    std::size_t width_ = 1;
    hdf5::Column<double> column_;
    int first_ = 0;  ///< row of the present arrangement number
    std::vector<double> values_;
};

/// An array of which a member has any number of values, listed one member after another.
template <class Value>
class ListedArray {
  public:
    template <class Missing>
    ListedArray(hid_t group, const ArrayOutput& array, const hdf5::Label& label, const hdf5::Scale& axis,
                const Missing& missing)
        : number_(array_number(array.path)), column_(group, label, {axis}, missing) {}

    void write(const FiledMember& member) {
        if (!member.row.done()) return;
        for (const double value : unpack(member.record->array(number_)).values) column_.add(static_cast<Value>(value));
    }

    void finish() { column_.finish(); }

  private:
    std::size_t number_;
    hdf5::Column<Value> column_;
};

/// To which member each row of a list belongs.
class ListOwners {
  public:
    ListOwners(hid_t group, const ArrayAxis& axis, const hdf5::Scale& scale)
        : axis_(axis), column_(group, {"member", "1", std::string(axis.owner)}, {scale}) {}

    void write(const FiledMember& member, const CampaignContent& content) {
        if (!member.row.done()) return;
        const MemberNote& note = content.members.notes()[*content.records[member.number]];
        for (int k = 0; k < found_along(note, axis_); ++k) column_.add(static_cast<std::int32_t>(member.number));
    }

    void finish() { column_.finish(); }

  private:
    const ArrayAxis& axis_;
    hdf5::Column<std::int32_t> column_;
};

void add_listed(hid_t group, const ArrayOutput& array, const hdf5::Label& label, const hdf5::Scale& scale,
                MemberTables& tables) {
    const auto add = [&]<class Value>(Value, const auto& missing) {
        tables.add(std::make_shared<ListedArray<Value>>(group, array, label, scale, missing),
                   [](ListedArray<Value>& list, const FiledMember& member) { list.write(member); });
    };
    switch (array.numbers) {
        case ArrayNumbers::real:
            return add(double{}, nan);
        case ArrayNumbers::index:
            return add(std::int32_t{}, std::optional<std::int32_t>{});
        case ArrayNumbers::flag:
            return add(std::int8_t{}, hdf5::flags_of(array.words));
    }
}

}  // namespace

void add_arrays(hid_t group, std::string_view name, const CampaignContent& content, const CampaignScales& scales,
                MemberTables& tables) {
    std::set<const ArrayAxis*> owned;
    for (const ArrayOutput& array : array_outputs) {
        if (array.group() != name || !content.has(array)) continue;
        const hdf5::Label label{std::string(array.name()), std::string(array.unit), std::string(array.long_name)};
        hdf5::Dimensions axes;
        for (const ArrayAxis* axis : array.axes)
            if (axis != nullptr) axes.push_back(scales.along(*axis));
        if (const ArrayAxis* listed = array.axis_of(AxisKind::listed)) {
            const hdf5::Scale& scale = scales.along(*listed);
            if (owned.insert(listed).second)
                tables.add(
                    std::make_shared<ListOwners>(group, *listed, scale),
                    [&content](ListOwners& owners, const FiledMember& member) { owners.write(member, content); });
            add_listed(group, array, label, scale, tables);
        } else if (array.of_arrangement) {
            tables.add(std::make_shared<ArrangementArray>(group, array, content, label, scales.arrangement, axes),
                       [](ArrangementArray& one, const FiledMember& member) { one.write(member); });
        } else {
            tables.add(std::make_shared<MemberArray>(group, array, content, label, scales.member, axes),
                       [](MemberArray& one, const FiledMember& member) { one.write(member); });
        }
    }
}

}  // namespace floes
