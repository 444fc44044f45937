#include "campaign_file/content.hpp"

#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/write.hpp"

namespace floes {

namespace {

std::vector<const ArrayAxis*> all_axes() {
    std::vector<const ArrayAxis*> axes;
    for (const ArrayOutput& array : array_outputs)
        for (const ArrayAxis* axis : array.axes)
            if (axis != nullptr && std::ranges::find(axes, axis) == axes.end()) axes.push_back(axis);
    return axes;
}

FiledAxis filed(const ArrayAxis& axis, const Campaign& campaign) {
    FiledAxis filed;
    if (axis.places == nullptr) return filed;
    std::vector<std::vector<double>> of_cases;
    for (const Case& one : campaign.cases) of_cases.push_back(axis.places(one.scenario));
    for (const std::vector<double>& own : of_cases) filed.own_sizes.push_back(own.size());
    if (axis.kind == AxisKind::placed) {
        filed.places = of_all_cases(campaign, axis.places);
        for (const std::vector<double>& own : of_cases) {
            std::vector<std::size_t>& positions = filed.positions.emplace_back();
            for (const double place : own)
                positions.push_back(
                    static_cast<std::size_t>(std::ranges::lower_bound(filed.places, place) - filed.places.begin()));
        }
        return filed;
    }
    filed.places = *std::ranges::max_element(of_cases, {}, &std::vector<double>::size);
    filed.alike = std::ranges::all_of(of_cases, [&](const std::vector<double>& own) {
        return std::equal(own.begin(), own.end(), filed.places.begin());
    });
    return filed;
}

}  // namespace

ArrayPlaces::ArrayPlaces(const Campaign& campaign) {
    for (const ArrayAxis* axis : all_axes()) axes_.emplace(axis, filed(*axis, campaign));
}

std::vector<std::size_t> ArrayPlaces::own_sizes(const ArrayOutput& array, int case_index) const {
    std::vector<std::size_t> sizes;
    for (const ArrayAxis* one : array.axes) {
        if (one == nullptr) break;
        const std::vector<std::size_t>& of_cases = axis(*one).own_sizes;
        sizes.push_back(of_cases.empty() ? 0 : of_cases.at(static_cast<std::size_t>(case_index)));
    }
    return sizes;
}

/// Calls use(index in own values, index in the row) for each value, in order.
template <class Use>
void ArrayPlaces::for_each_place(const ArrayOutput& array, int case_index, std::span<const std::size_t> own,
                                 std::span<const std::size_t> sizes, const Use& use) const {
    const auto position = [&](std::size_t k, std::size_t index) {
        const auto& positions = axis(*array.axes[k]).positions;
        return positions.empty() ? index : positions.at(static_cast<std::size_t>(case_index)).at(index);
    };
    const std::size_t count = hdf5::product(own);
    std::vector<std::size_t> index(own.size(), 0);
    for (std::size_t value = 0; value < count; ++value) {
        std::size_t place = 0;
        bool inside = true;
        for (std::size_t k = 0; k < own.size(); ++k) {
            const std::size_t at = position(k, index[k]);
            inside = inside && at < sizes[k];
            place = place * sizes[k] + at;
        }
        if (inside) use(value, place);
        for (std::size_t k = own.size(); k-- > 0 && ++index[k] == own[k];) index[k] = 0;
    }
}

std::vector<double> ArrayPlaces::row(const ArrayOutput& array, int case_index, const ArrayValues& own,
                                     std::span<const std::size_t> sizes) const {
    std::vector<double> row(hdf5::product(sizes), undefined);
    if (!own.empty())
        for_each_place(array, case_index, own.sizes, sizes,
                       [&](std::size_t value, std::size_t place) { row[place] = own.values[value]; });
    return row;
}

ArrayValues ArrayPlaces::own(const ArrayOutput& array, int case_index, std::span<const double> row,
                             std::span<const std::size_t> sizes) const {
    ArrayValues own{own_sizes(array, case_index), {}};
    for (std::size_t k = 0; k < own.sizes.size(); ++k)
        if (array.axes[k]->kind == AxisKind::longest) own.sizes[k] = sizes[k];
    own.values.resize(hdf5::product(std::span<const std::size_t>(own.sizes)), undefined);
    for_each_place(array, case_index, own.sizes, sizes,
                   [&](std::size_t value, std::size_t place) { own.values[value] = row[place]; });
    if (std::ranges::all_of(own.values, [](double value) { return std::isnan(value); })) own.values.clear();
    return own;
}

namespace {

using hdf5::Label;
using hdf5::Scale;

std::vector<std::int32_t> counted_to(std::size_t count) {
    std::vector<std::int32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

Scale make_scale(hid_t file, const ArrayAxis& axis, const CampaignContent& content) {
    const Label label{std::string(axis.key), std::string(axis.unit), std::string(axis.long_name)};
    const FiledAxis& filed = content.places.axis(axis);
    if (axis.places == nullptr) return hdf5::write_scale(file, label, counted_to(content.found(axis)));
    if (!axis.words.empty())
        return hdf5::write_scale(file, label, std::vector<std::string>(axis.words.begin(), axis.words.end()));
    if (axis.whole_numbers) return hdf5::write_scale(file, label, counted_to(filed.places.size()));
    if (filed.alike) return hdf5::write_scale(file, label, filed.places);
    std::vector<double> numbers(filed.places.size());
    std::iota(numbers.begin(), numbers.end(), 1.0);
    return hdf5::write_scale(file, Label{std::string(axis.key), "1", std::string(axis.unlike)}, numbers);
}

std::size_t most_profile_points(const Campaign& campaign) {
    std::size_t most = 1;
    for (const Case& one : campaign.cases) most = std::max(most, one.scenario.structure.shape.profile().size());
    return most;
}

}  // namespace

CampaignContent::CampaignContent(const Campaign& of, const StoredMembers& all_members)
    : campaign(of),
      members(&all_members),
      count(of.arrangements),
      records(match_records(of, all_members.notes())),
      attempts(last_attempts(of, all_members.notes())),
      rows(of),
      places(of) {
    find_sizes();
}

CampaignContent::CampaignContent(const Campaign& of, const StoredMembers& its_members, PieceRows piece)
    : campaign(of),
      members(&its_members),
      first(piece.first),
      count(static_cast<int>(piece.records.size() / of.cases.size())),
      records(std::move(piece.records)),
      attempts(std::move(piece.attempts)),
      rows(of),
      places(of),
      is_piece_(true) {
    find_sizes();
    for (std::size_t k = 0; k < found_axes.size(); ++k)
        if (found_axes[k]->kind != AxisKind::listed) found_[k] = piece.most[k];
}

CampaignContent::CampaignContent(const Campaign& of, std::span<const FilePiece> its_pieces, const FoundSizes& most)
    : campaign(of), pieces(its_pieces), count(of.arrangements), rows(of), places(of), found_(most) {
    for (std::size_t k = 0; k < found_axes.size(); ++k) {
        if (found_axes[k]->kind != AxisKind::listed) continue;
        found_[k] = 0;
        for (const FilePiece& piece : pieces) found_[k] += piece.found[k];
    }
}

void CampaignContent::find_sizes() {
    for (std::size_t row = 0; row < records.size(); ++row)
        if (records[row] && note(row).done()) add_found(found_, note(row));
}

void add_found(FoundSizes& sizes, const MemberNote& note) {
    for (std::size_t k = 0; k < found_axes.size(); ++k) {
        const auto own = static_cast<std::size_t>(note.found[k]);
        sizes[k] = found_axes[k]->kind == AxisKind::listed ? sizes[k] + own : std::max(sizes[k], own);
    }
}

std::size_t CampaignContent::found(const ArrayAxis& axis) const {
    return found_.at(static_cast<std::size_t>(std::ranges::find(found_axes, &axis) - found_axes.begin()));
}

bool CampaignContent::has(const ArrayOutput& array) const {
    return std::ranges::none_of(array.axes, [&](const ArrayAxis* axis) {
        if (axis == nullptr) return false;
        return ((axis->kind == AxisKind::placed || axis->kind == AxisKind::counted) &&
                places.axis(*axis).places.empty()) ||
               (axis->kind == AxisKind::longest && found(*axis) == 0);
    });
}

CampaignScales::CampaignScales(hid_t file, const CampaignContent& content)
    : member(hdf5::write_index_scale(file, "member", "member: arrangement number times cases plus case",
                                     content.member_rows(), content.first_row())),
      case_(hdf5::write_index_scale(file, "case", "case, a row of /cases", content.campaign.cases.size())),
      arrangement(
          hdf5::write_index_scale(file, "arrangement", "arrangement, a row of /arrangements",
                                  static_cast<std::size_t>(content.count * content.rows.arrangements().groups()),
                                  static_cast<std::size_t>(content.first * content.rows.arrangements().groups()))),
      profile_point(hdf5::write_index_scale(file, "profile_point", "point of the structure's profile, from below",
                                            most_profile_points(content.campaign))) {
    for (const ArrayOutput& array : array_outputs) {
        if (!array.in_file() || !content.has(array)) continue;
        for (const ArrayAxis* axis : array.axes)
            if (axis != nullptr && !axes_.contains(axis)) axes_.emplace(axis, make_scale(file, *axis, content));
    }
    const std::size_t cases = content.campaign.cases.size();
    const auto groups = static_cast<std::size_t>(content.rows.arrangements().groups());
    const auto of = [](const FilePiece& piece) { return static_cast<std::size_t>(piece.count); };
    content.lies_in_pieces(member, [&](const FilePiece& piece) { return of(piece) * cases; });
    content.lies_in_pieces(arrangement, [&](const FilePiece& piece) { return of(piece) * groups; });
    for (std::size_t k = 0; k < found_axes.size(); ++k)
        if (found_axes[k]->kind == AxisKind::listed && axes_.contains(found_axes[k]))
            content.lies_in_pieces(axes_.at(found_axes[k]), [k](const FilePiece& piece) { return piece.found[k]; });
}

void write_calibration(hid_t file, const CampaignContent& content, std::span<const CalibrationRecord> calibrations) {
    std::vector<std::int32_t> cases;
    std::vector<CurvePoint> points;
    const std::vector<const Calibration*> of_case = match_calibrations(content.campaign, calibrations);
    for (std::size_t k = 0; k < of_case.size(); ++k) {
        if (of_case[k] == nullptr) continue;
        cases.resize(cases.size() + of_case[k]->curve.size(), static_cast<std::int32_t>(k));
        points.insert(points.end(), of_case[k]->curve.begin(), of_case[k]->curve.end());
    }
    if (points.empty()) return;
    const hdf5::Scale scale =
        hdf5::write_index_scale(file, "calibration_point", "plate test, a row of /calibration", points.size());
    const hdf5::Handle group = hdf5::create_group(file, "calibration");
    hdf5::write_values(group.id(), {"case", "1", "case that the test calibrated"}, {scale}, cases);
    write_columns(group.id(), scale, points, calibration_columns);
}

namespace {

using hdf5::Handle;

/// A column each of the rows of the cases' shapes, filled up with NaN.
void write_shapes(hid_t group, const CampaignContent& content, const CampaignScales& scales) {
    const std::size_t points = scales.profile_point.size();
    for (std::size_t column = 0; column < Shape::columns.size(); ++column) {
        const auto& [name, unit, text, low, high] = Shape::columns[column];
        std::vector<double> values(scales.case_.size() * points, undefined);
        for (std::size_t k = 0; k < content.table().cases.size(); ++k) {
            const std::vector<std::vector<double>> rows = content.table().cases[k].shape.profile();
            for (std::size_t p = 0; p < rows.size(); ++p) values[k * points + p] = rows[p][column];
        }
        hdf5::write_values(group, {fmt::format("profile_{}", name), std::string(unit), std::string(text)},
                           {scales.case_, scales.profile_point}, values);
    }
}

}  // namespace

void write_cases(hid_t file, const CampaignContent& content, const CampaignScales& scales) {
    const Handle group = hdf5::create_group(file, "cases");
    const hid_t id = group.id();
    const auto column = [&](const char* name, const char* unit, const char* long_name, auto of) {
        write_column(id, {name, unit, long_name}, scales.case_, content.campaign.cases,
                     [&](const Case& one) { return of(one.scenario); });
    };
    write_column(id, {"name", "1", "name of the case"}, scales.case_, content.table().cases, &CaseRow::name);
    column("hull", "1", "shape of the structure, in words",
           [](const Scenario& s) { return s.structure.shape.words().text(); });
    column("parts", "1", "parts of the structure in the order of /parts, divided by commas",
           [](const Scenario& s) { return fmt::format("{}", fmt::join(s.structure.shape.parts(), ",")); });
    column("cfm", "1", "constraint force mixing of the joints (Sigma); NaN for beam joints",
           [](const Scenario& s) { return followed_cfm(s.joint); });
    column("elastic_modulus", "Pa", "elastic modulus that the case stands for",
           [](const Scenario& s) { return s.mean_ice().elastic_modulus; });
    column("contact_erp", "1", "error reduction parameter of contacts (Gamma)",
           [](const Scenario& s) { return s.contact.erp; });
    column("crushing_pressure", "Pa", "pressure at which edges crush, where they do",
           [](const Scenario& s) { return s.contact_law().crushing_pressure; });
    const auto choice = [&](const char* name, const char* long_name, const std::string& words, auto of) {
        std::vector<std::int8_t> values(1 + static_cast<std::size_t>(std::ranges::count(words, ' ')));
        std::iota(values.begin(), values.end(), std::int8_t{0});
        std::vector<std::int8_t> numbers;
        for (const Case& one : content.campaign.cases) numbers.push_back(static_cast<std::int8_t>(of(one.scenario)));
        hdf5::write_values(id, {name, "1", long_name}, {scales.case_}, numbers, hdf5::Flags{values, words});
    };
    choice("friction", "where friction points", fmt::format("{}", fmt::join(friction_words, " ")),
           [](const Scenario& s) { return s.contact.friction; });
    choice("contact_law", "what bounds the force along the normal", fmt::format("{}", fmt::join(normal_law_words, " ")),
           [](const Scenario& s) { return s.contact.normal; });
    choice("internal_edges", "whether edges inside a body act", "do_not_act act",
           [](const Scenario& s) { return s.contact.internal_edges; });
    column("time_step", "s", "time step", [](const Scenario& s) { return s.general.time_step; });
    column("steady_start", "s", "begin of the analysis window",
           [](const Scenario& s) { return s.analysis.steady_start; });
    column("window", "s", "length of the analysis window", [](const Scenario& s) { return s.analysis.window; });
    column("peak_separation", "s", "time between peaks of the averaged load that count as two",
           [](const Scenario& s) { return s.analysis.peak_separation; });
    column("segments", "1", "equal parts of the analysis window",
           [](const Scenario& s) { return s.analysis.segments; });
    column("history_stride", "1", "successive steps whose mean is one value of /history",
           [](const Scenario& s) { return s.analysis.history_stride; });
    choice("far_end", "what stands behind the ice field", "ice_sheet open never",
           [](const Scenario& s) { return s.field.far_end; });
    write_shapes(id, content, scales);
}

void add_members(hid_t id, const CampaignScales& scales, MemberTables& tables) {
    const hdf5::Dimensions member{scales.member};
    const auto integers = [&](const char* name, const char* long_name, auto of) {
        tables.add_numbers<std::int32_t>(id, {name, "1", long_name}, member, std::nullopt, of);
    };
    const auto flags = [&](const char* name, const char* long_name, const hdf5::Flags& meanings, auto of) {
        tables.add_numbers<std::int8_t>(id, {name, "1", long_name}, member, meanings, of);
    };
    integers("case", "case of the member, a row of /cases", [](const FiledMember& m) { return m.row.case_index; });
    integers("arrangement", "arrangement of the member, a row of /arrangements",
             [](const FiledMember& m) { return m.row.arrangement; });
    flags("status", "whether the member was computed", hdf5::Flags{{-1, 0, 1}, "missing done failed"},
          [](const FiledMember& m) { return static_cast<std::int8_t>(m.row.status); });
    // Counts are doubles too, so that every reader sees NaN where there is none.
    for (const Quantity& one : quantities)
        tables.add_numbers<double>(id, {std::string{one.key.view()}, std::string{one.unit}, std::string{one.long_name}},
                                   member, undefined, [&one](const FiledMember& m) { return m.row.value(one); });
    flags("steady", "whether the trend of the surge load does not differ from zero",
          hdf5::Flags{{0, 1}, "not_steady steady", -1},
          [](const FiledMember& m) { return static_cast<std::int8_t>(m.row.done() ? m.row.load.steady : -1); });
    tables.add_texts(id, {"reason", "1", "why the member failed; empty unless it did"}, member,
                     [](const FiledMember& m) { return m.row.reason; });
}

void add_arrangement_numbers(hid_t group, const CampaignContent& content, const CampaignScales& scales,
                             MemberTables& tables) {
    // Members come in the order of their arrangements, so each row begins where its number is first seen.
    const ArrangementRows& rows = content.rows.arrangements();
    using Numbers = hdf5::Column<std::int32_t>;
    tables.add(std::make_shared<Numbers>(group, hdf5::Label{"number", "1", "arrangement number"},
                                         hdf5::Dimensions{scales.arrangement}),
               [&rows, next = content.first * rows.groups()](Numbers& column, const FiledMember& member) mutable {
                   const int last = rows.number(member.row.arrangement) * rows.groups() + rows.groups();
                   for (; next < last; ++next) column.add(rows.number(next));
               });
}

namespace {

using hdf5::Handle;
using hdf5::Scale;

// Not the root's scale: a scale refers to what it is attached to, and comparing two files follows the reference.
void add_members(hid_t group, const CampaignContent& content, MemberTables& tables) {
    Scale member = hdf5::write_index_scale(group, "member", "member", content.member_rows(), content.first_row());
    content.lies_in_pieces(member, [&](const FilePiece& piece) {
        return static_cast<std::size_t>(piece.count) * content.campaign.cases.size();
    });
    const hdf5::Dimensions one{member};
    const auto reals = [&](const char* name, const char* unit, const char* long_name, auto of) {
        tables.add_numbers<double>(group, {name, unit, long_name}, one, undefined, [of](const FiledMember& m) {
            return m.record != nullptr ? static_cast<double>(of(*m.record)) : undefined;
        });
    };
    reals("wall_time", "s", "wall time of the member", [](const MemberRecord& r) { return r.result.wall_time; });
    reals("cpu_time", "s", "processor time of the member", [](const MemberRecord& r) { return r.result.cpu_time; });
    reals("peak_memory", "byte", "largest resident set of the process by the member's end",
          [](const MemberRecord& r) { return r.peak_memory; });
    tables.add_numbers<std::int32_t>(group, {"rank", "1", "rank that computed the member"}, one, std::int32_t{-1},
                                     [](const FiledMember& m) { return m.record != nullptr ? m.record->rank : -1; });
    tables.add_texts(group, {"host", "1", "host that computed the member"}, one,
                     [](const FiledMember& m) { return m.record != nullptr ? m.record->host : ""; });
    tables.add_numbers<std::int32_t>(group, {"attempts", "1", "attempts at the member"}, one, std::nullopt,
                                     [&content](const FiledMember& m) { return content.attempts[m.place]; });
}

void write_sessions(hid_t group, std::span<const Session> sessions) {
    const Scale scale =
        hdf5::write_index_scale(group, "session", "start of the program on the campaign", sessions.size());
    write_columns(group, scale, sessions, session_columns);
    write_column(group, {"session_software", "1", "software and versions"}, scale, sessions, [](const Session& s) {
        std::string text;
        for (const Software& software : s.software)
            text += fmt::format("{}{} {}", text.empty() ? "" : "; ", software.name, software.version);
        return text;
    });
}

std::string lower_case(std::string text) {
    for (char& letter : text)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return text;
}

}  // namespace

void add_provenance(hid_t file, const CampaignContent& content, std::span<const Session> sessions,
                    MemberTables& tables) {
    const Handle group = hdf5::create_group(file, "provenance");
    const hid_t id = group.id();
    hdf5::write_attribute(id, "date", utc_now());
    hdf5::write_attribute(id, "seed", content.campaign.seed);
    if (!sessions.empty()) {
        hdf5::write_attribute(id, "machine", sessions.back().machine);
        for (const Software& software : sessions.back().software)
            hdf5::write_attribute(id, lower_case(software.name), software.version);
    }
    hdf5::write_text(id, {"configuration", "1", "resolved configuration, TOML"}, write_campaign(content.campaign));
    add_members(id, content, tables);
    write_sessions(id, sessions);
}

std::string checksums_name(std::string_view path) {
    std::string name(path);
    std::ranges::replace(name, '/', '_');
    return name;
}

namespace {

hdf5::Dimensions with(const hdf5::Scale& first, const hdf5::Dimensions& others) {
    hdf5::Dimensions all{first};
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

/// An array that lies in a row for each member.
class MemberArray {
  public:
    /// `checksums`: where those of its rows are kept beside them, in a piece; nullptr elsewhere.
    MemberArray(hid_t group, const ArrayOutput& array, const CampaignContent& content, const hdf5::Label& label,
                const hdf5::Scale& member, const hdf5::Dimensions& axes, std::shared_ptr<const hdf5::Handle> checksums)
        : array_(array),
          number_(array_number(array.path)),
          places_(content.places),
          member_(member),
          checksums_(std::move(checksums)) {
        for (const hdf5::Scale& one : axes) sizes_.push_back(one.size());
        if (array.chunks == ArrayChunks::of_its_own) {
            rows_.emplace(group, label, with(member, axes));
        } else {
            column_.emplace(group, label, with(member, axes), undefined);
        }
    }

    void write(const FiledMember& member) {
        const PackedArray packed = member.row.done() ? member.record->array(number_) : PackedArray{};
        if (rows_ && packed.empty()) return;
        if (rows_ && packed.sizes == sizes_) return rows_->write(member.place, packed.numbers);
        const std::vector<double> row = places_.row(array_, member.row.case_index, unpack(packed), sizes_);
        if (rows_) return rows_->write(member.place, row);
        column_->add(row);
    }

    void finish() {
        if (rows_) rows_->finish();
        if (rows_ && checksums_) {
            const std::vector<std::uint32_t>& all = rows_->checksums();
            hdf5::write_values(
                checksums_->id(),
                {checksums_name(array_.path), "1", fmt::format("Adler-32 of each row of /{}", array_.path)}, {member_},
                std::vector<std::int32_t>(all.begin(), all.end()));
        }
        if (column_) column_->finish();
    }

  private:
    const ArrayOutput& array_;
    std::size_t number_;
    const ArrayPlaces& places_;
    const hdf5::Scale& member_;
    std::shared_ptr<const hdf5::Handle> checksums_;
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
          column_(group, label, with(arrangement, axes), undefined) {
        for (const hdf5::Scale& one : axes) sizes_.push_back(one.size());
        width_ = hdf5::product(std::span<const std::size_t>(sizes_));
        begin(content.first * rows_.groups());
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
    void begin(int row) {
        first_ = row;
        values_.assign(static_cast<std::size_t>(rows_.groups()) * width_, undefined);
    }

    static constexpr std::size_t poses_ = array_number("arrangements/pose");

    const ArrayOutput& array_;
    std::size_t number_;
    const ArrayPlaces& places_;
    const ArrangementRows& rows_;
    std::vector<std::size_t> sizes_;
    std::size_t width_;
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
    ListOwners(hid_t group, const ArrayAxis& axis, const CampaignContent& content, const hdf5::Scale& scale)
        : axis_(axis), content_(content), column_(group, {"member", "1", std::string(axis.owner)}, {scale}) {}

    void write(const FiledMember& member) {
        if (!member.row.done()) return;
        for (int k = 0; k < found_along(content_.note(member.place), axis_); ++k)
            column_.add(static_cast<std::int32_t>(member.number));
    }

    void finish() { column_.finish(); }

  private:
    const ArrayAxis& axis_;
    const CampaignContent& content_;
    hdf5::Column<std::int32_t> column_;
};

void add_listed(hid_t group, const ArrayOutput& array, const hdf5::Label& label, const hdf5::Scale& scale,
                MemberTables& tables) {
    const auto add = [&]<class Value>(Value, const auto& missing) {
        tables.add(std::make_shared<ListedArray<Value>>(group, array, label, scale, missing));
    };
    switch (array.numbers) {
        case ArrayNumbers::real:
            return add(double{}, undefined);
        case ArrayNumbers::index:
            return add(std::int32_t{}, std::optional<std::int32_t>{});
        case ArrayNumbers::flag:
            return add(std::int8_t{}, hdf5::flags_of(array.words));
    }
}

}  // namespace

void add_arrays(hid_t group, std::string_view name, const CampaignContent& content, const CampaignScales& scales,
                MemberTables& tables, const std::shared_ptr<const hdf5::Handle>& checksums) {
    std::set<const ArrayAxis*> owned;
    for (const ArrayOutput& array : array_outputs) {
        if (array.group() != name || !content.has(array)) continue;
        const hdf5::Label label{std::string(array.name()), std::string(array.unit), std::string(array.long_name)};
        hdf5::Dimensions axes;
        for (const ArrayAxis* axis : array.axes)
            if (axis != nullptr) axes.push_back(scales.along(*axis));
        if (const ArrayAxis* listed = array.axis_of(AxisKind::listed)) {
            const hdf5::Scale& scale = scales.along(*listed);
            if (owned.insert(listed).second) tables.add(std::make_shared<ListOwners>(group, *listed, content, scale));
            add_listed(group, array, label, scale, tables);
        } else if (array.of_arrangement) {
            tables.add(std::make_shared<ArrangementArray>(group, array, content, label, scales.arrangement, axes));
        } else {
            tables.add(std::make_shared<MemberArray>(group, array, content, label, scales.member, axes, checksums));
        }
    }
}

}  // namespace floes
