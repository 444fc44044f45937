#include "hydro/mooring_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {

namespace {

struct Row {
    std::size_t line;  ///< of the file, from 1
    std::vector<std::string> words;
};

struct Section {
    std::string name;
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

/// What the line begins: "types", "points", "lines", "rods", "options", another section; nothing if it begins none.
std::optional<std::string> section_of(const std::string& line) {
    if (line.find("---") == std::string::npos) return {};
    const std::string text = upper(line);
    const auto has = [&](const char* words) { return text.find(words) != std::string::npos; };
    if (has("LINE TYPES") || has("LINE DICTIONARY")) return "types";
    if (has("ROD TYPES") || has("ROD DICTIONARY")) return "rod types";
    if (has("RODS") || has("ROD LIST") || has("ROD PROPERTIES")) return "rods";
    if (has("BODIES") || has("BODY LIST") || has("BODY PROPERTIES")) return "bodies";
    if (has("POINT") || has("CONNECTION") || has("NODE PROPERTIES")) return "points";
    if (has("OPTIONS")) return "options";
    if (has("LINES") || has("LINE PROPERTIES") || has("LINE LIST")) return "lines";
    return "other";
}

std::vector<Section> sections_of(std::string_view text) {
    std::vector<Section> found;
    std::istringstream stream{std::string(text)};
    std::size_t number = 0;
    std::size_t header = 0;  // lines of names and units still to come
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (const std::optional<std::string> name = section_of(line)) {
            found.push_back({*name, {}, {}});
            header = *name == "options" || *name == "other" ? 0 : 2;
            continue;
        }
        if (found.empty()) continue;
        std::vector<std::string> words = words_of(line);
        if (words.empty()) continue;
        if (header > 0) {
            if (header-- == 2)
                for (std::string& word : words) found.back().columns.push_back(upper(word));
            continue;
        }
        found.back().rows.push_back({number, std::move(words)});
    }
    return found;
}

class Reader {
  public:
    Reader(std::string_view text, std::string file) : file_(std::move(file)), sections_(sections_of(text)) {}

    InputError wrong(const Row& row, const std::string& what) const {
        return InputError(fmt::format("{}:{}: {}", file_, row.line, what));
    }

    double number(const Row& row, std::size_t column, const char* name) const {
        if (column >= row.words.size()) throw wrong(row, fmt::format("has {} words and no {}", row.words.size(), name));
        const std::string& word = row.words[column];
        const char* first = word.data() + (word.front() == '+' ? 1 : 0);
        double value = 0;
        const auto [rest, error] = std::from_chars(first, word.data() + word.size(), value);
        if (error != std::errc{} || rest != word.data() + word.size() || !std::isfinite(value))
            throw wrong(row, fmt::format("has {} for {}, which is no number", word, name));
        return value;
    }

    /// All rows of sections of a name; `needed`: which there must be.
    std::vector<const Section*> all(const std::string& name, bool needed) const {
        std::vector<const Section*> found;
        for (const Section& section : sections_)
            if (section.name == name) found.push_back(&section);
        if (found.empty() && needed)
            throw InputError(fmt::format("{}: has no section of {}; it is to be a file of MoorDyn or MoorPy", file_,
                                         name == "types" ? "line types" : name));
        return found;
    }

    void refuse(const std::string& name, const char* why) const {
        for (const Section* section : all(name, false))
            if (!section->rows.empty()) throw wrong(section->rows.front(), why);
    }

    const std::string& file() const { return file_; }

  private:
    std::string file_;
    std::vector<Section> sections_;
};

struct Point {
    bool anchor;
    Vec3 place;  ///< floes' axes, m
};

struct Type {
    double diameter, mass, stiffness;
};

std::map<std::string, Point> points_of(const Reader& reader) {
    std::map<std::string, Point> found;
    for (const Section* section : reader.all("points", true)) {
        for (const Row& row : section->rows) {
            if (row.words.size() < 5) throw reader.wrong(row, "is no point: number, kind, x, y and z");
            const std::string kind = upper(row.words[1]);
            const auto is = [&](std::initializer_list<const char*> names) {
                return std::ranges::any_of(names, [&](const char* name) { return kind == name; });
            };
            const bool anchor = is({"FIX", "FIXED", "ANCHOR"});
            if (!anchor && !is({"VESSEL", "COUPLED", "FAIRLEAD", "BODY1", "VES", "CPLD"}))
                throw reader.wrong(row,
                                   fmt::format("has a point that is {}; lines go from a fairlead on the vessel to a "
                                               "fixed anchor here",
                                               row.words[1]));
            // x ahead, y to port, z up: floes has z to starboard and y up.
            found[row.words[0]] = {
                anchor, {reader.number(row, 2, "x"), reader.number(row, 4, "z"), 0 - reader.number(row, 3, "y")}};
        }
    }
    return found;
}

std::map<std::string, Type> types_of(const Reader& reader) {
    std::map<std::string, Type> found;
    for (const Section* section : reader.all("types", true)) {
        for (const Row& row : section->rows) {
            if (row.words.size() < 4) throw reader.wrong(row, "is no line type: name, diameter, mass and EA");
            Row plain = row;
            plain.words[3] = row.words[3].substr(0, row.words[3].find('|'));  // static | dynamic
            found[row.words[0]] = {reader.number(row, 1, "the diameter"), reader.number(row, 2, "the mass"),
                                   reader.number(plain, 3, "EA")};
        }
    }
    return found;
}

struct Options {
    double density, gravity;
    double friction = 0;
};

Options options_of(const Reader& reader, double density, double gravity) {
    Options found{density, gravity};
    for (const Section* section : reader.all("options", false)) {
        for (const Row& row : section->rows) {
            if (row.words.size() < 2) continue;
            const std::string name = upper(row.words[1]);
            if (name == "WTRDNSTY" || name == "RHO" || name == "RHOW") found.density = reader.number(row, 0, "density");
            if (name == "G" || name == "GRAVITY") found.gravity = reader.number(row, 0, "gravity");
            if (name == "FRICTIONCOEFFICIENT" || name == "MU_KA" || name == "MU_KT")
                found.friction = reader.number(row, 0, "friction");
        }
    }
    return found;
}

}  // namespace

MooringFile read_moorings(std::string_view text, const std::string& file, double density, double gravity) {
    const Reader reader(text, file);
    reader.refuse("rods", "has rods, and lines alone are read");
    reader.refuse("bodies", "has bodies, and one vessel alone is read");
    const std::map<std::string, Type> types = types_of(reader);
    const std::map<std::string, Point> points = points_of(reader);
    const Options options = options_of(reader, density, gravity);
    MooringFile found;
    for (const Section* section : reader.all("lines", true)) {
        const auto column = [&](std::initializer_list<const char*> names) {
            for (const char* name : names) {
                const auto at = std::ranges::find(section->columns, name);
                if (at != section->columns.end()) return static_cast<std::size_t>(at - section->columns.begin());
            }
            throw InputError(fmt::format("{}: the section of lines has no column {}", file, *names.begin()));
        };
        const std::size_t from = column({"ATTACHA", "NODEANCH", "NODEA", "ENDA"});
        const std::size_t to = column({"ATTACHB", "NODEFAIR", "NODEB", "ENDB"});
        const std::size_t length = column({"UNSTRLEN", "LENGTH"});
        for (const Row& row : section->rows) {
            if (row.words.size() <= std::max({from, to, length}))
                throw reader.wrong(row, "is no line: words are missing");
            const auto type = types.find(row.words[1]);
            if (type == types.end()) throw reader.wrong(row, fmt::format("has no line type {} above it", row.words[1]));
            const auto a = points.find(row.words[from]);
            const auto b = points.find(row.words[to]);
            if (a == points.end() || b == points.end())
                throw reader.wrong(row, fmt::format("ends at {} and {}, of which one is no point above it",
                                                    row.words[from], row.words[to]));
            if (a->second.anchor == b->second.anchor)
                throw reader.wrong(row,
                                   a->second.anchor ? "goes from anchor to anchor" : "goes from fairlead to fairlead");
            const Vec3& anchor = a->second.anchor ? a->second.place : b->second.place;
            const Vec3& fairlead = a->second.anchor ? b->second.place : a->second.place;
            const Vec3 way = anchor - fairlead;
            const double area = std::numbers::pi / 4 * type->second.diameter * type->second.diameter;
            const double weight = options.gravity * (type->second.mass - options.density * area);
            if (!(weight > 0)) throw reader.wrong(row, fmt::format("floats: it weighs {:.4g} N/m in water", weight));
            found.lines.push_back({.fairlead = fairlead,
                                   .azimuth = std::atan2(way.z(), way.x()),
                                   .distance = std::hypot(way.x(), way.z()),
                                   .depth = -anchor.y(),
                                   .cable = {reader.number(row, length, "the length"), weight, type->second.stiffness,
                                             options.friction}});
        }
    }
    if (found.lines.empty()) throw InputError(fmt::format("{}: has no lines", file));
    found.remarks.push_back(
        fmt::format("{}: density {:g} kg/m³, gravity {:g} m/s², friction {:g}; lines have no break load", file,
                    options.density, options.gravity, options.friction));
    return found;
}

}  // namespace floes
