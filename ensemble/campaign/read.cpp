// read_campaign(): text, overrides and pose files to checked cases.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>

#include "campaign/campaign.hpp"
#include "campaign/campaign_keys.hpp"
#include "campaign/pose_file.hpp"
#include "core/error.hpp"
#include "keys/literal.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace {

/// Where each key was last set, for messages: path -> "table3.toml:12".
using Origins = std::map<std::string, std::string>;

constexpr std::string_view case_prefix = "case.";

bool is_case_path(const std::string& path) {
    return path == "case" || path.starts_with(case_prefix);
}

class Reader {
  public:
    Reader(const CampaignSource& source, LoadFile load_file)
        : source_(source), load_file_(load_file), document_(parse_document(source.text, source.file)) {
        for (const std::string& text : source.overrides) overrides_.push_back(parse_override(text, "--set"));
    }

    Campaign read() {
        read_tables();
        std::vector<Block> blocks = case_blocks();
        std::vector<std::string> names;
        for (const Block& block : blocks) names.push_back(case_name(block, names));
        refuse_strangers(names);
        if (head_.name.empty()) head_.name = std::filesystem::path(source_.file).stem().string();
        Campaign campaign{head_.name, head_.seed, head_.arrangements, {}, stop_, rules_};
        for (std::size_t i = 0; i < blocks.size(); ++i) campaign.cases.push_back(read_case(blocks[i], names, i));
        return campaign;
    }

  private:
    /// The tables and the overrides that are not for one case.
    void read_tables() {
        Keys keys = describe(head_);
        for (Key& key : describe(stop_)) keys.push_back(std::move(key));
        for (Key& key : describe(rules_)) keys.push_back(std::move(key));
        for (Key& key : describe(base_)) keys.push_back(std::move(key));
        for (const Entry& entry : document_.entries) {
            if (is_case_path(entry.path)) {
                throw InputError(
                    fmt::format("{}: {} = {} is not in a case; begin each case with [[case]], in double brackets",
                                entry.where, entry.path, to_text(entry.value)));
            }
            set(keys, entry, origins_);
        }
        for (const Entry& entry : overrides_) {
            if (is_case_path(entry.path)) continue;
            refuse_hidden(entry);
            set(keys, entry, origins_);
        }
    }

    static void set(const Keys& keys, const Entry& entry, Origins& origins) {
        const std::string path = assign_known(keys, entry);
        if (!path.empty()) origins[full_path(path)] = entry.where;
    }

    /// An override that every case would override again does nothing: worse than an error.
    void refuse_hidden(const Entry& override_entry) const {
        for (const Block& block : document_.blocks) {
            for (const Entry& entry : block.entries) {
                if (full_path(entry.path) != override_entry.path) continue;
                throw InputError(
                    fmt::format("{}: the [[case]] at {} sets {} itself; override it there, --set case.NAME.{}={}",
                                override_entry.where, block.where, override_entry.path, override_entry.path,
                                to_text(override_entry.value)));
            }
        }
    }

    /// The [[case]] blocks; without any, an empty one.
    std::vector<Block> case_blocks() const {
        std::vector<Block> blocks = document_.blocks;
        for (const Block& block : blocks) {
            if (block.path != "case") {
                throw InputError(fmt::format("{}: [[{}]] is not a table of a configuration; did you mean [[case]]?",
                                             block.where, block.path));
            }
        }
        if (blocks.empty()) {
            const std::string name = fmt::format("E{:.6g}", base_.ice.elastic_modulus / unit::megapascal);
            blocks.push_back({"case", source_.file, {{"name", {name}, source_.file}}});
        }
        return blocks;
    }

    /// The block's name, checked: present, plain, and none of `earlier`.
    static std::string case_name(const Block& block, const std::vector<std::string>& earlier) {
        const auto entry = std::ranges::find(block.entries, "name", &Entry::path);
        if (entry == block.entries.end()) {
            throw InputError(fmt::format("{}: this [[case]] has no name; begin it with name = \"E60\"", block.where));
        }
        Case one;
        assign(describe(one).front(), *entry);
        const auto plain = [](unsigned char c) {
            return std::isalnum(c) || c == '_' || c == '-' || c == '+' || c == '.';
        };
        if (one.name.empty() || !std::ranges::all_of(one.name, plain)) {
            throw InputError(
                fmt::format("{}: name = {} cannot name a case; allowed: letters, digits and any of _ - + .",
                            entry->where, text_literal(one.name)));
        }
        if (std::ranges::find(earlier, one.name) != earlier.end()) {
            throw InputError(fmt::format("{}: name = {} names an earlier case too; give each case its own name",
                                         entry->where, text_literal(one.name)));
        }
        return one.name;
    }

    /// Which case the override "case.NAME.key" is for. Names may contain dots, so the longest that fits.
    static std::optional<std::size_t> target(const std::string& path, const std::vector<std::string>& names) {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool fits = path.starts_with(fmt::format("{}{}.", case_prefix, names[i]));
            if (fits && (!best || names[i].size() > names[*best].size())) best = i;
        }
        return best;
    }

    void refuse_strangers(const std::vector<std::string>& names) const {
        for (const Entry& entry : overrides_) {
            if (is_case_path(entry.path) && !target(entry.path, names)) {
                throw InputError(fmt::format("{}: {} names no case; the cases are {}, written case.{}.KEY", entry.where,
                                             entry.path, fmt::join(names, ", "), names.front()));
            }
        }
    }

    Case read_case(const Block& block, const std::vector<std::string>& names, std::size_t index) const {
        Case one{names[index], base_};
        const Keys keys = describe(one);
        Origins own;
        for (const Entry& entry : block.entries) {
            refuse_campaign_key(entry);
            if (own.contains(full_path(entry.path))) {
                throw InputError(fmt::format("{}: {} is given twice in this [[case]]; keep one", entry.where,
                                             full_path(entry.path)));
            }
            set(keys, entry, own);
        }
        for (Entry entry : overrides_) {
            if (!is_case_path(entry.path) || target(entry.path, names) != index) continue;
            entry.path.erase(0, case_prefix.size() + names[index].size() + 1);
            refuse_campaign_key(entry);
            if (entry.path == "name")
                throw InputError(
                    fmt::format("{}: a case cannot be renamed here; rename it in {}", entry.where, source_.file));
            set(keys, entry, own);
        }
        own.insert(origins_.begin(), origins_.end());  // what the case does not set comes from the tables
        one.calibrate = own.contains("ice.elastic_modulus_MPa") && !own.contains("joint.cfm");
        const std::string label = names.size() > 1 ? fmt::format("case {}: ", one.name) : "";
        resolve_poses(one.scenario, own, label);
        refuse_contradictions(one.scenario, own, label);
        return one;
    }

    static void refuse_campaign_key(const Entry& entry) {
        const std::string table = entry.path.substr(0, entry.path.find('.'));
        if (table != "campaign" && table != "stop") return;
        throw InputError(fmt::format("{}: {} = {} is for all cases; write it in [{}]", entry.where, entry.path,
                                     to_text(entry.value), table));
    }

    /// Loads arrangement.file into the poses.
    void resolve_poses(Scenario& scenario, const Origins& origins, const std::string& label) const {
        std::string& file = scenario.arrangement.file;
        if (file.empty()) return;
        const std::string given_file = given(scenario, "arrangement.file");
        const auto refuse = [&](const std::string& what) {
            return InputError(fmt::format("{}: {}{} {}", origins.at("arrangement.file"), label, given_file, what));
        };
        if (scenario.arrangement.method != ArrangementMethod::file) {
            throw refuse(fmt::format("is not used by {}; write arrangement.method = \"file\"",
                                     given(scenario, "arrangement.method")));
        }
        if (!scenario.arrangement.poses.empty()) throw refuse("and arrangement.poses are both given; keep one");
        if (load_file_ == nullptr) throw refuse("cannot be read here; give arrangement.poses");
        const std::string path = (std::filesystem::path(source_.file).parent_path() / file).string();
        const Keys keys = describe(scenario);
        assign(*find_key(keys, "arrangement.poses"), {"arrangement.poses", read_poses(load_file_(path), path), path});
        file.clear();
    }

    /// Begins with the place of the first of the keys involved that the text sets.
    void refuse_contradictions(const Scenario& scenario, const Origins& origins, const std::string& label) const {
        const std::vector<Contradiction> found = find_contradictions(scenario);
        if (found.empty()) return;
        const auto& keys = found.front().keys;
        const auto set_key = std::ranges::find_if(keys, [&](const std::string& key) { return origins.contains(key); });
        const std::string& where = set_key == keys.end() ? source_.file : origins.at(*set_key);
        throw InputError(fmt::format("{}: {}{}", where, label, found.front().sentence));
    }

    const CampaignSource& source_;
    LoadFile load_file_;
    Document document_;
    std::vector<Entry> overrides_;
    CampaignHead head_;
    StopRule stop_;
    RunRules rules_;
    Scenario base_;
    Origins origins_;
};

}  // namespace

Campaign read_campaign(const CampaignSource& source, LoadFile load_file) {
    return Reader(source, load_file).read();
}

}  // namespace floes
