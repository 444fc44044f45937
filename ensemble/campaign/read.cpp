#include "campaign/read.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "campaign/campaign_keys.hpp"
#include "campaign/case_blocks.hpp"
#include "campaign/hull_file.hpp"
#include "campaign/outline_file.hpp"
#include "campaign/refusals.hpp"
#include "campaign/stop_rule.hpp"
#include "campaign/write.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/csv.hpp"
#include "keys/key.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"
#include "scenario/layout.hpp"
#include "scenario/validate.hpp"

namespace floes {

namespace {

constexpr std::string_view header = "x_m,z_m,yaw_deg";

/// Its numbers; empty when a cell is anything else.
std::vector<Value> numbers_of(const CsvLine& line) {
    std::vector<Value> numbers;
    for (const std::string& cell : line.cells) {
        const std::optional<double> number = number_in(cell);
        if (!number) return {};
        numbers.emplace_back(*number);
    }
    return numbers;
}

}  // namespace

PoseFile read_poses(const std::string& text, const std::string& file) {
    const std::vector<CsvLine> lines = csv_lines(text, file);
    const std::string columns = lines.empty() ? "" : joined(lines.front());
    if (!lines.empty() && columns != header && !columns.starts_with(std::string{header} + ","))
        throw InputError(
            "{}:{}: {} is not the header of a pose file; write {}, and behind it keys of which each floe has a value "
            "of its own, such as ice.thickness_m",
            file, lines.front().number, text_literal(columns), header);
    if (lines.size() < 2) throw InputError("{}: there are no poses; write {} and a line for each floe", file, header);
    std::vector<Value> poses;
    std::vector<int> places;
    for (const CsvLine& line : std::span(lines).subspan(1)) {
        std::vector<Value> numbers = numbers_of(line);
        if (numbers.size() != lines.front().cells.size())
            throw InputError("{}:{}: {} is not a pose; write {} numbers, {}", file, line.number,
                             text_literal(joined(line)), lines.front().cells.size(), columns);
        if (poses.size() == std::size_t{most_floes})
            throw InputError("{}:{}: there are more than {} poses, the most floes of a field", file, line.number,
                             most_floes);
        poses.emplace_back(std::move(numbers));
        places.push_back(line.number);
    }
    return {file, columns.substr(std::min(columns.size(), header.size() + 1)), {std::move(poses)}, std::move(places)};
}

namespace {

/// As a value of TOML, to which numbers such as 10. or .5 are none.
Value value_in(const std::string& cell, const std::string& key, const std::string& where) {
    Value value = parse_override(key + "=" + cell, where).value;
    if (!std::holds_alternative<std::string>(value.data)) return value;
    const std::optional<double> number = number_in(cell);
    return number ? Value{*number} : value;
}

/// The axes of a design that a CSV file lists: keys in its first line, a point in each other one.
struct PointFile {
    std::vector<Block> axes;          ///< [[design.axis]] with a value for each point
    std::vector<std::string> places;  ///< file and line of each point
};

/// `file` names the text in messages. Throws InputError with file and line.
PointFile read_points(const std::string& text, const std::string& file) {
    const std::vector<CsvLine> lines = csv_lines(text, file);
    if (lines.size() < 2)
        throw InputError(
            "{}: there are no points; write keys, such as ice.thickness_m, in the first line and a line for each point",
            file);
    const CsvLine& keys = lines.front();
    Scenario scratch;
    const Keys known = describe(scratch);
    PointFile points;
    for (const CsvLine& line : std::span(lines).subspan(1))
        points.places.push_back(fmt::format("{}:{}", file, line.number));
    for (std::size_t k = 0; k < keys.cells.size(); ++k) {
        const std::string where = fmt::format("{}:{}", file, keys.number);
        const Key* key = find_key(known, full_path(keys.cells[k]));  // none: refused as that of any axis
        std::vector<Value> values;
        for (const CsvLine& line : std::span(lines).subspan(1)) {
            if (line.cells.size() != keys.cells.size())
                throw InputError("{}:{}: {} is not a point; write {} values, of {}", file, line.number,
                                 text_literal(joined(line)), keys.cells.size(), joined(keys));
            if (line.cells[k].empty()) throw InputError("{}:{}: {} has no value", file, line.number, keys.cells[k]);
            values.push_back(value_in(line.cells[k], keys.cells[k], where));
            if (key != nullptr)
                assign(*key, {std::string(key->path), values.back(), fmt::format("{}:{}", file, line.number)});
        }
        points.axes.push_back(
            {axis_block, where, {{"key", {keys.cells[k]}, where}, {"values", {std::move(values)}, where}}});
    }
    return points;
}

// What a configuration gives in files beside it.

auto as_given(const HullFile& file) {
    return std::tie(file.path, file.unit, file.up, file.forward, file.waterline);
}

/// What a field has to be for outlines that lie as they were traced.
std::string room_for_traced(const Scenario& scenario) {
    const TracedOutlines& traced = scenario.shapes.traced;
    Outline corners;
    for (const Outline& one : traced.outlines) corners.insert(corners.end(), one.begin(), one.end());
    const Corner size = traced.scale * size_of(corners);
    const double clearance = scenario.arrangement.clearance;
    const double covered = scenario.field.concentration * scenario.field_length();  // per width of the field
    return fmt::format(
        "; the outlines reach over {:.4g} m x {:.4g} m, for which field.concentration_percent is at most {:.3g} and "
        "field.half_width_m at least {:.4g}",
        size.x, size.z, 100 * covered / (size.x + 2 * clearance), size.z / 2 + clearance);
}

/// A case that is read: where its keys are given, and what names it in messages.
struct OriginCase {
    Scenario& scenario;
    const Origins& origins;
    const std::string& label;
};

class GivenFiles {
  public:
    /// `configuration`: the file beside which they lie. `load_file`: nullptr where none can be read.
    GivenFiles(std::string configuration, LoadFile load_file)
        : configuration_(std::move(configuration)), load_file_(load_file) {}

    // Each loads the file that a key names, where there is one, into the values of another key. They throw InputError.

    /// hull.file, a CAD file, into the shape's convex pieces.
    void resolve_hull(const OriginCase& of) {
        Structure& structure = of.scenario.structure;
        if (structure.hull_file.path.empty()) return;
        const std::string path =
            path_of(structure.hull_file.path, {"hull.file", "hull.pieces"}, !structure.shape.piece_rows().empty(), of,
                    structure.shape.kind() == HullKind::file ? "" : "hull.shape");
        if (!cut_ || as_given(*cut_) != as_given(structure.hull_file)) {
            Structure fresh;
            fresh.hull_file = structure.hull_file;
            take_hull(fresh, load_file_(path), path);
            cut_ = structure.hull_file;
            pieces_ = fresh;
        }
        structure.shape.set_pieces(pieces_.shape.piece_rows());
        structure.shape.set_faces(pieces_.shape.face_rows());
        structure.shape.part_list() = pieces_.shape.part_list();
        structure.hull_file = {
            .path = "", .most_added = structure.hull_file.most_added, .volume = pieces_.hull_file.volume};
    }

    /// shapes.file into the outlines of floes.
    void resolve_outlines(const OriginCase& of) {
        TracedOutlines& traced = of.scenario.shapes.traced;
        if (traced.path.empty()) return;
        if (!of.scenario.shapes.from_file())
            return traced.path.clear();  // of another case; KeyEffects sees one of none
        const std::string path = path_of(traced.path, {"shapes.file", "shapes.outlines"}, !traced.outlines.empty(), of);
        if (!read_ || read_path_ != traced.path || read_unit_ != traced.unit) {
            read_path_ = traced.path;
            read_unit_ = traced.unit;
            TracedOutlines fresh = traced;
            take_outlines(fresh, load_file_(path), path);
            read_ = std::move(fresh);
        }
        const double scale = traced.scale;
        const double most_added = traced.most_added;
        traced = *read_;
        traced.scale = scale;
        traced.most_added = most_added;
    }

    /// arrangement.file, CSV, into the poses.
    std::optional<PoseFile> resolve_poses(const OriginCase& of) const {
        ArrangementRule& arrangement = of.scenario.arrangement;
        if (arrangement.file.empty()) return {};
        const Named named{"arrangement.file", "arrangement.poses"};
        const std::string path = path_of(arrangement.file, named, !arrangement.poses.empty(), of,
                                         arrangement.method == ArrangementMethod::file ? "" : "arrangement.method");
        PoseFile read = read_poses(load_file_(path), path);
        if (!arrangement.columns.empty() && arrangement.columns != read.columns)
            throw refusal(named, of, "has its columns in its header; leave arrangement.columns out");
        arrangement.columns = read.columns;
        assign(*find_key(describe(of.scenario), "arrangement.poses"), {"arrangement.poses", read.poses, path});
        arrangement.file.clear();
        return read;
    }

    /// Given poses are input: what make_arrangement() would refuse in every member is refused here, with its place.
    void refuse_faults(const Scenario& scenario, const std::optional<PoseFile>& file, const Origins& origins,
                       const std::string& label) {
        if (!scenario.arrangement.given()) return;
        if (!looked_at_.insert(geometry_key(scenario)).second) return;  // of an earlier case
        const std::optional<Fault> fault = find_fault(scenario, floes_of(scenario));
        if (!fault) return;
        const bool traced = scenario.arrangement.method == ArrangementMethod::traced;
        std::string where = file ? file->path : origins.at(traced ? "arrangement.method" : "arrangement.poses");
        if (file && !fault->floes.empty()) {
            std::vector<int> lines;
            for (const std::size_t floe : fault->floes) lines.push_back(file->lines[floe]);
            where += fmt::format(", line{} {}", lines.size() == 1 ? "" : "s", fmt::join(lines, " and "));
        }
        const std::string instead = traced && fault->floes.size() == 1 ? room_for_traced(scenario) : "";
        throw InputError("{}: {}{}{}", where, label, fault->sentence, instead);
    }

  private:
    /// The key that names a file, and the key of the values that it has.
    struct Named {
        const char* file;
        const char* values;
    };

    static InputError refusal(const Named& named, const OriginCase& of, const std::string& what) {
        return InputError("{}: {}{} {}", of.origins.at(named.file), of.label, given(of.scenario, named.file), what);
    }

    /// Where the file lies. `both`: the values are given, too. `unused_by`: the key that would have to be "file"; "":
    /// it is.
    std::string path_of(const std::string& file, const Named& named, bool both, const OriginCase& of,
                        const std::string& unused_by = "") const {
        const auto refuse = [&](const std::string& what) { return refusal(named, of, what); };
        if (!unused_by.empty())
            throw refuse(
                fmt::format("is not used by {}; write {} = \"file\"", given(of.scenario, unused_by), unused_by));
        if (both) throw refuse(fmt::format("and {} are both given; keep one", named.values));
        if (load_file_ == nullptr) throw refuse(fmt::format("cannot be read here; give {}", named.values));
        return (std::filesystem::path(configuration_).parent_path() / file).string();
    }

    std::string configuration_;
    LoadFile load_file_;
    std::optional<HullFile> cut_;  ///< the last hull, as it was given
    Structure pieces_;             ///< of it
    std::string read_path_;        ///< of the last outlines, as it was given
    LengthUnit read_unit_ = LengthUnit::m;
    std::optional<TracedOutlines> read_;  ///< of it
    std::set<std::uint64_t> looked_at_;   ///< geometries of poses
};

/// Which keys of a text have an effect. One that is set and has none would be taken for one that has.
class KeyEffects {
  public:
    /// Notes the keys that are given (`origins` tells where) and have an effect in the case that `keys` are bound to,
    /// and those that have none though they are set to an unusual value.
    void note(const Keys& keys, const Origins& origins) {
        for (const Key& key : keys) {
            if (!key.in_force) continue;
            const std::string path(key.path);
            const auto origin = origins.find(path);
            if (origin == origins.end() || is_superfluous(key)) continue;
            if (key.idle())
                idle_.try_emplace(path, fmt::format("{}: {} = {}", origin->second, path, literal(key)), key.only_with);
            else
                effective_.insert(path);
        }
    }

    /// A sentence for each key without effect in any case.
    std::vector<std::string> without() const {
        std::vector<std::string> sentences;
        for (const auto& [path, given] : idle_)
            if (!effective_.contains(path))
                sentences.push_back(fmt::format("{} has no effect: it needs {}. Add that, or leave {} out.",
                                                given.first, given.second, path));
        return sentences;
    }

  private:
    std::map<std::string, std::pair<std::string, std::string>> idle_;  ///< by path: where and what, what it needs
    std::set<std::string> effective_;
};

constexpr std::string_view case_prefix = "case.";
constexpr std::string_view axis_prefix = "design.axis.";

bool is_case_path(const std::string& path) {
    return path == "case" || path.starts_with(case_prefix);
}

class CampaignReader {
  public:
    CampaignReader(const CampaignSource& source, LoadFile load_file)
        : source_(source),
          document_(parse_document(source.text, source.file)),
          load_file_(load_file),
          files_(source.file, load_file) {
        if (!source.from_user) tables_.scenario = paper_scenario();  // where it is silent
        for (const std::string& text : source.overrides) overrides_.push_back(parse_override(text, "--set"));
    }

    /// Throws InputError with all that is wrong: first with keys, each by itself, then with what they say together.
    Campaign read() {
        std::optional<Campaign> campaign;
        refusals_.gather([&] { campaign = read_all(); });
        refusals_.refuse();
        return *std::move(campaign);
    }

  private:
    Campaign read_all() {
        read_tables();
        if (source_.without_design) leave_design_out();
        read_points_file();
        axes_ = read_axes(document_.blocks, origins_, source_.file, tables_.design);
        if (source_.from_user && tables_.design.method == DesignMethod::list) refuse_points_twice();
        refuse_hidden();
        std::vector<CaseBlock> given = given_cases(document_, name_of_ice(), source_.file, tables_.design);
        find_case_overrides(given);
        if (tables_.head.name.empty()) tables_.head.name = name_of_file();
        Campaign campaign{tables_.head, {}, tables_.stop, tables_.run, tables_.design};
        const std::vector<CaseBlock> blocks =
            at_points(std::move(given), tables_.design, axes_, tables_.head.seed, source_.file);
        refuse_members(blocks.size(), campaign.arrangements, source_.file);
        read_cases(blocks, campaign.cases);
        if (!wrong_keys_)
            for (std::string& sentence : effects_.without()) refusals_.add(std::move(sentence));
        if (refusals_.any()) return campaign;
        check_points(campaign, source_.file);
        if (const auto fault = stop_quantity_fault(campaign)) throw InputError("{}: {}", place_of("stop.of"), *fault);
        refuse_base_case(campaign);
        if (source_.from_user)
            if (const auto fault = stop_case_fault(campaign))
                throw InputError("{}: {}", place_of(fault->key), fault->sentence);
        // The campaign is stored and sent as this text, so one that could not be read again is refused at once.
        if (source_.from_user) write_campaign(campaign, fmt::format("{}, with all keys written out", source_.file));
        return campaign;
    }

    /// The tables and the overrides that are not for one case.
    void read_tables() {
        const Keys& keys = tables_.keys;
        for (const Entry& entry : in_order_of_reading(keys, document_.entries)) {
            if (is_case_path(entry.path)) {
                refuse_key(
                    fmt::format("{}: {} = {} is not in a case; begin each case with [[case]], in double brackets",
                                entry.where, entry.path, to_text(entry.value)));
            } else if (entry.path.starts_with(axis_prefix)) {
                refuse_key(fmt::format(
                    "{}: {} = {} is not in an axis; begin each axis with [[design.axis]], in double brackets",
                    entry.where, entry.path, to_text(entry.value)));
            } else {
                set(keys, entry, origins_);
            }
        }
        for (const Entry& entry : in_order_of_reading(keys, overrides_)) {
            if (!is_case_path(entry.path)) set(keys, entry, origins_);
        }
        for (const Entry& entry : overrides_) {
            const Key* key = find_key(keys, full_path(entry.path));
            if (key != nullptr && !key->preset) overridden_.emplace_back(entry, exact_text(*key));
        }
    }

    void leave_design_out() {
        tables_.design = {};
        std::erase_if(document_.blocks, [](const Block& block) { return block.path == axis_block; });
    }

    /// Puts the axes of design.points_file among the blocks.
    void read_points_file() {
        if (tables_.design.points_file.empty()) return;
        const auto refuse = [&](const std::string& what) {
            return InputError("{}: design.points_file = {} {}", origins_.at("design.points_file"),
                              text_literal(tables_.design.points_file), what);
        };
        if (tables_.design.method != DesignMethod::list)
            throw refuse("is a list of points; write design.method = \"list\"");
        if (std::ranges::find(document_.blocks, axis_block, &Block::path) != document_.blocks.end())
            throw refuse("and [[design.axis]] are both given; keep one");
        if (load_file_ == nullptr) throw refuse("cannot be read here; give [[design.axis]] blocks");
        const std::string path =
            (std::filesystem::path(source_.file).parent_path() / std::exchange(tables_.design.points_file, {}))
                .string();
        PointFile points = read_points(load_file_(path), path);
        for (Block& axis : points.axes) document_.blocks.push_back(std::move(axis));
        point_places_ = std::move(points.places);
    }

    /// A point of a list that is there again would be the same members again.
    void refuse_points_twice() const {
        Scenario scratch;
        const Keys keys = describe(scratch);
        std::map<std::vector<std::string>, std::size_t> seen;
        const auto place = [&](std::size_t point) {
            return point < point_places_.size()
                       ? point_places_[point]
                       : fmt::format("{}, point {}", axes_.at(tables_.design.axes.front().key), point);
        };
        for (std::size_t point = 0; point < tables_.design.axes.front().values.size(); ++point) {
            std::vector<std::string> values;
            for (const DesignAxis& axis : tables_.design.axes) {
                const Key& key = *find_key(keys, axis.key);
                assign(key, {axis.key, axis.values[point], axes_.at(axis.key)});
                values.push_back(exact_text(key));
            }
            const auto [first, is_new] = seen.emplace(std::move(values), point);
            if (!is_new)
                throw InputError(
                    "{}: this point of the design is there already, at {}, and would give the same members; keep one",
                    place(point), place(first->second));
        }
    }

    /// Where the tables set a key; the file where they do not.
    const std::string& place_of(const std::string& key) const {
        const auto place = origins_.find(key);
        return place == origins_.end() ? source_.file : place->second;
    }

    void refuse_base_case(const Campaign& campaign) const {
        if (tables_.run.base_case.empty() || base_case(campaign)) return;
        throw InputError("{}: run.base_case = {} names no case; the cases are {}", origins_.at("run.base_case"),
                         text_literal(tables_.run.base_case), name_list(case_names(campaign)));
    }

    void refuse_key(std::string sentence) {
        wrong_keys_ = true;
        refusals_.add(std::move(sentence));
    }

    void set(const Keys& keys, const Entry& entry, Origins& origins) {
        try {
            const std::string path = assign_known(keys, entry);
            if (!path.empty()) origins[full_path(path)] = entry.where;
        } catch (const InputError& refused) {
            refuse_key(refused.what());
        }
    }

    /// Refuses an override that would have no effect because a case or an axis sets the same key.
    void refuse_hidden() const {
        for (const Entry& hidden : overrides_) {
            if (is_case_path(hidden.path)) continue;
            refuse_axis(hidden, axes_);
            for (const Block& block : document_.blocks)
                for (const Entry& entry : block.entries)
                    if (block.path != axis_block && full_path(entry.path) == hidden.path)
                        throw InputError(
                            "{}: the [[case]] at {} sets {} itself; override it there, --set case.NAME.{}={}",
                            hidden.where, block.where, hidden.path, hidden.path, to_text(hidden.value));
        }
    }

    /// Refuses an override that a preset of the case would undo. `keys`: of the case, after all its entries are set.
    void refuse_overruled(const Keys& keys, const CaseBlock& block) const {
        for (const auto& [entry, wanted] : overridden_) {
            const Key* here = find_key(keys, full_path(entry.path));
            if (here == nullptr || exact_text(*here) == wanted) continue;
            throw InputError("{}: the preset of case {} says {} = {}; override it there, --set case.{}.{}={}",
                             entry.where, block.name, entry.path, literal(*here), block.name, entry.path,
                             to_text(entry.value));
        }
    }

    /// Which case the override "case.NAME.key" is for. Names may contain dots, so the longest that fits.
    static const CaseBlock* target(const std::string& path, const std::vector<CaseBlock>& cases) {
        const CaseBlock* best = nullptr;
        for (const CaseBlock& one : cases) {
            const bool fits = path.starts_with(fmt::format("{}{}.", case_prefix, one.name));
            if (fits && (best == nullptr || one.name.size() > best->name.size())) best = &one;
        }
        return best;
    }

    InputError stranger(const Entry& entry, const std::vector<CaseBlock>& cases) const {
        if (cases.front().name.empty())
            return InputError(
                "{}: {} names no case; there are none but the points of the design, and what is for all of them needs "
                "no case",
                entry.where, entry.path);
        std::vector<std::string> names;
        for (const CaseBlock& one : cases) names.push_back(one.name);
        return InputError("{}: {} names no case; the cases are {}, written case.{}.KEY", entry.where, entry.path,
                          name_list(names), names.front());
    }

    void find_case_overrides(const std::vector<CaseBlock>& cases) {
        for (Entry entry : overrides_) {
            if (!is_case_path(entry.path)) continue;
            const CaseBlock* one = target(entry.path, cases);
            if (one == nullptr) throw stranger(entry, cases);
            entry.path.erase(0, case_prefix.size() + one->name.size() + 1);
            refuse_campaign_key(entry);
            refuse_axis(entry, axes_);
            if (entry.path == "name")
                throw InputError("{}: a case cannot be renamed here; rename it in {}", entry.where, source_.file);
            case_overrides_.emplace_back(one->given, std::move(entry));
        }
    }

    /// The name of the only case, if it has none: from its E, or from its Σ where that decides E.
    std::string name_of_ice() const {
        if (pairing(tables_.scenario, origins_) == Pairing::find_modulus)
            return fmt::format("cfm{:.6g}", tables_.scenario.joint.cfm);
        return fmt::format("E{:.6g}", tables_.scenario.ice.elastic_modulus / unit::megapascal);
    }

    std::string name_of_file() const {
        const std::string stem = std::filesystem::path(source_.file).stem().string();
        if (is_utf8(stem)) return stem;
        throw InputError(
            "The name of the configuration file is not UTF-8, so it cannot name the campaign; give campaign.name.");
    }

    /// A case whose values are known, but for what is laid.
    struct ReadCase {
        std::size_t block = 0;           ///< of the blocks
        std::optional<PoseFile> file{};  ///< that its poses came from; without them
        OpenKeys open{};
    };

    /// The cases of the blocks, laid and checked. What is refused is kept.
    void read_cases(const std::vector<CaseBlock>& blocks, std::vector<Case>& cases) {
        Case one;
        const Keys keys = describe(one);  // only once, because it takes longer than the rest of a case
        HeldNumbers held(source_.file);
        std::vector<ReadCase> read;
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            refusals_.gather([&] {
                ReadCase about{.block = k};
                read_case(blocks[k], label_of(blocks, k), one, keys, about);
                if (wrong_keys_) return;  // what the others say together is not what was meant
                cases.push_back(one);
                read.push_back(std::move(about));
            });
            if (!refusals_.any()) held.add(one.scenario);
        }
        if (wrong_keys_) return;
        if (source_.from_user) lay(cases, read);
        for (std::size_t k = 0; k < read.size(); ++k)
            refusals_.gather(
                [&] { check_case(blocks[read[k].block], label_of(blocks, read[k].block), cases[k], read[k]); });
    }

    /// Names the case in messages if it is one of many.
    static std::string label_of(const std::vector<CaseBlock>& blocks, std::size_t number) {
        return blocks.size() > 1 ? fmt::format("case {}: ", blocks[number].name) : "";
    }

    /// For one case.
    std::vector<Entry> overrides_of(const CaseBlock& block) const {
        std::vector<Entry> overrides;
        for (const auto& [of_case, entry] : case_overrides_)
            if (of_case == block.given) overrides.push_back(entry);
        return overrides;
    }

    /// Where each key of a case is given; what the case does not set comes from the tables.
    Origins origins_of(const CaseBlock& block) const {
        Origins own;
        for (const Entry& entry : block.block.entries) own[full_path(entry.path)] = entry.where;
        for (const Entry& entry : overrides_of(block)) own[full_path(entry.path)] = entry.where;
        own.insert(origins_.begin(), origins_.end());
        return own;
    }

    /// Reads a case into `one`, to which `keys` are bound.
    void read_case(const CaseBlock& block, const std::string& label, Case& one, const Keys& keys, ReadCase& about) {
        one = {block.name, tables_.scenario};
        Origins given;
        for (const Entry& entry : in_order_of_reading(keys, block.block.entries)) {
            refuse_campaign_key(entry);
            if (const auto first = given.find(full_path(entry.path)); first != given.end()) {
                throw InputError("{}: {} is given twice in this [[case]], first at {}; keep one", entry.where,
                                 first->first, first->second);
            }
            set(keys, entry, given);
        }
        refuse_overruled(keys, block);
        for (const Entry& entry : in_order_of_reading(keys, overrides_of(block))) set(keys, entry, given);
        one.name = block.name;
        if (block.point >= 0) {
            one.base = block.base;
            one.point = block.point;
        }
        if (wrong_keys_) return;
        const Origins own = origins_of(block);
        one.pairing = pairing(one.scenario, own);
        if (source_.from_user) effects_.note(keys, own);
        const OriginCase of{one.scenario, own, label};
        about.file = files_.resolve_poses(of);
        if (about.file) about.file->poses = {};
        files_.resolve_hull(of);
        files_.resolve_outlines(of);
        one.hull_stated = !source_.from_user || names_hull(one.scenario, own);
        for (std::size_t key = 0; key < laid_paths.size(); ++key)
            about.open.set(key, !own.contains(std::string(laid_paths[key])));
    }

    /// Whether a text says which hull, or that it is about the paper, whose hull is the default.
    static bool names_hull(const Scenario& scenario, const Origins& own) {
        const bool of_paper =
            scenario.joint.model == JointModel::cfm || preset_of(scenario.contact) == ContactPreset::paper;
        return of_paper || std::ranges::any_of(own, [](const auto& key) {
                   return key.first.starts_with("hull.") || key.first.starts_with("paper.") ||
                          key.first == "structure.profile_m" || key.first == "structure.keel_radius_m";
               });
    }

    /// Gives what the cases leave open its values: all fields alike where they share their arrangements.
    void lay(std::vector<Case>& cases, const std::vector<ReadCase>& read) const {
        std::vector<Unlaid> unlaid;
        for (std::size_t k = 0; k < cases.size(); ++k) unlaid.push_back({&cases[k].scenario, read[k].open});
        if (tables_.head.common_arrangements)
            floes::lay(unlaid);
        else
            for (Unlaid& one : unlaid) floes::lay({&one, 1});
        for (std::size_t k = 0; k < cases.size(); ++k) cases[k].laid = std::move(unlaid[k].laid);
    }

    /// The message of a contradiction begins with the place of the first key involved that the text sets.
    void check_case(const CaseBlock& block, const std::string& label, const Case& one, const ReadCase& about) {
        const Origins own = origins_of(block);
        for (const auto& [keys, sentence] : find_contradictions(one.scenario)) {
            const auto set_key = std::ranges::find_if(keys, [&](const std::string& key) { return own.contains(key); });
            const std::string& where = set_key == keys.end() ? source_.file : own.at(*set_key);
            refusals_.add(where + ": ", label, sentence);
        }
        if (source_.from_user && !refusals_.any()) files_.refuse_faults(one.scenario, about.file, own, label);
    }

    /// For joints that follow Σ. Stored texts leave out what is to be found; where they have both, both are settled.
    Pairing pairing(const Scenario& scenario, const Origins& own) const {
        if (scenario.joint.model != JointModel::cfm) return Pairing::settled;
        const bool modulus = own.contains("ice.elastic_modulus_MPa");
        if (!own.contains("joint.cfm")) return source_.from_user || modulus ? Pairing::find_cfm : Pairing::settled;
        if (!modulus) return Pairing::find_modulus;
        return source_.from_user && !tables_.run.nominal_modulus ? Pairing::check : Pairing::settled;
    }

    static void refuse_campaign_key(const Entry& entry) {
        const std::string table = entry.path.substr(0, entry.path.find('.'));
        if (table != "campaign" && table != "stop") return;
        throw InputError("{}: {} = {} is for all cases; write it in [{}]", entry.where, entry.path,
                         to_text(entry.value), table);
    }

    const CampaignSource& source_;
    Document document_;
    LoadFile load_file_;
    std::vector<Entry> overrides_;
    std::vector<std::pair<Entry, std::string>> overridden_;  ///< keys of a scenario, with the text that each then has
    CampaignTables tables_;
    Origins origins_;
    std::vector<std::string> point_places_;                      ///< of points from a file: where each is given
    Origins axes_;                                               ///< where each axis of the design is given
    std::vector<std::pair<std::size_t, Entry>> case_overrides_;  ///< for which [[case]], as if it stood there
    GivenFiles files_;
    KeyEffects effects_;
    Refusals refusals_;
    bool wrong_keys_ = false;  ///< whether a key by itself was refused
};

}  // namespace

Campaign read_campaign(const CampaignSource& source, LoadFile load_file) {
    return CampaignReader(source, load_file).read();
}

}  // namespace floes
