// The only door from STL and OBJ. A reader of its own: what is far from the origin loses its digits in the single
// precision of libraries.

#include "campaign/surface_file.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "campaign/lost_digits.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/csv.hpp"

namespace floes {

namespace {

constexpr std::size_t most_triangles = 20'000;
constexpr std::size_t most_polygon_corners = 300;
constexpr std::string_view blanks = " \t\v\f";

/// A surface as it is read: points that are one by their places, groups by their names, and how it is rounded.
class SurfaceMaker {
  public:
    explicit SurfaceMaker(std::string file) : file_(std::move(file)) {}

    int number_of(const Vec3& point) {
        const auto [found, is_new] =
            numbers_.try_emplace({point.x(), point.y(), point.z()}, static_cast<int>(surface_.points.size()));
        if (is_new) surface_.points.push_back(point);
        return found->second;
    }

    const std::vector<Vec3>& points() const { return surface_.points; }

    /// Of one corner twice it has no area and goes. `solid`: -1 for the group's own number.
    void add(const std::array<int, 3>& corners, std::string_view name, int solid) {
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
        if (surface_.triangles.size() == most_triangles)
            throw InputError("{}: the surface has more than {} triangles; let the CAD program make a coarser one",
                             file_, most_triangles);
        surface_.triangles.push_back(corners);
        surface_.group.push_back(group_named(name));
        surface_.solid.push_back(solid < 0 ? surface_.group.back() : solid);
    }

    /// A coordinate as a text has it. `where`: its line.
    double number(std::string_view word, int axis, const std::string& where) {
        const std::optional<double> value = number_in(word);
        if (!value)
            throw InputError("{}: {:?} is not a finite number; export the file anew", where, beginning(word, 40));
        if (const std::size_t exponent = word.find_first_of("eE"); exponent != std::string_view::npos) {
            const std::string_view mantissa = word.substr(0, exponent);
            digits_ = std::max<std::ptrdiff_t>(
                digits_, std::ranges::count_if(mantissa, [](unsigned char c) { return std::isdigit(c) != 0; }));
            largest_[axis] = std::max(largest_[axis], std::abs(*value));
        }
        return *value + 0.0;
    }

    Surface made() && {
        if (surface_.triangles.empty()) throw InputError("{}: the file has no triangles", file_);
        refuse_lost_digits();
        return std::move(surface_);
    }

  private:
    int group_named(std::string_view name) {
        std::string known = is_utf8(name) ? std::string(name) : "";
        std::ranges::replace_if(
            known, [](unsigned char c) { return c == ',' || c < ' '; }, ' ');
        const auto [found, is_new] = groups_.try_emplace(known, static_cast<int>(surface_.groups.size()));
        if (is_new) surface_.groups.push_back(known);
        return found->second;
    }

    /// How far apart its numbers along an axis are, where they were rounded: to single precision, or to the digits
    /// before an exponent, of which programs write six or more.
    double step_along(int axis, std::span<const double> numbers) const {
        constexpr std::ptrdiff_t fewest_digits = 6;
        const double single = single_precision_step(numbers);
        if (!(largest_[axis] > 0)) return single;
        const auto shown = static_cast<double>(std::max(digits_, fewest_digits));
        return std::max(single, std::pow(10, std::floor(std::log10(largest_[axis])) + 1 - shown));
    }

    /// Each side may have moved by half a step, so lengths may be off by one.
    void refuse_lost_digits() const {
        constexpr double most_off = 0.01;
        double off = 0;
        double widest = 0;
        double largest = 0;
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> numbers;
            for (const Vec3& point : surface_.points) numbers.push_back(point[axis]);
            const auto [low, high] = std::ranges::minmax(numbers);
            const double step = step_along(axis, numbers);
            if (step == 0 || low == high) continue;
            off += step / (high - low);
            widest = std::max(widest, step);
            largest = std::max({largest, std::abs(low), std::abs(high)});
        }
        if (off <= most_off) return;
        throw InputError(
            "{}: its points lie up to {:.4g} from the origin, where the numbers of this file are {:.3g} apart, so that "
            "the volume may be off by {:.2g} %; move the hull to the origin in the CAD program, or export a text with "
            "all digits (STL text or OBJ)",
            file_, largest, widest, 100 * off);
    }

    std::string file_;
    Surface surface_;
    std::map<std::array<double, 3>, int> numbers_;
    std::map<std::string, int> groups_;
    std::ptrdiff_t digits_ = 0;    // the most of a number with an exponent
    Vec3 largest_ = Vec3::Zero();  // such number along each axis
};

/// A text by its words and lines, which end as on any system.
class TextWords {
  public:
    TextWords(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
    }

    std::string where() const { return fmt::format("{}:{}", file_, line_); }

    /// Empty at the end.
    std::string_view word() {
        while (!text_.empty() && (blanks.find(text_.front()) != blanks.npos || at_end_of_line()))
            if (!take_end_of_line()) text_.remove_prefix(1);
        return taken(text_.find_first_of(" \t\v\f\r\n"));
    }

    /// What the line still has, without outer blanks.
    std::string_view rest_of_line() { return trimmed(taken(text_.find_first_of("\r\n")), blanks); }

    /// The next line that has anything in it; nothing at the end.
    std::optional<std::string_view> line() {
        while (take_end_of_line()) {
        }
        if (text_.empty()) return std::nullopt;
        return rest_of_line();
    }

  private:
    bool at_end_of_line() const { return text_.starts_with('\r') || text_.starts_with('\n'); }

    bool take_end_of_line() {
        if (!at_end_of_line()) return false;
        text_.remove_prefix(text_.starts_with("\r\n") ? 2 : 1);
        ++line_;
        return true;
    }

    std::string_view taken(std::size_t length) {
        const std::string_view found = text_.substr(0, length);
        text_.remove_prefix(found.size());
        return found;
    }

    std::string_view text_;
    std::string file_;
    int line_ = 1;
};

class StlText {
  public:
    StlText(std::string_view text, const std::string& file) : words_(text, file), maker_(file) {}

    Surface read() && {
        int solids = 0;
        for (std::string_view word = words_.word(); !word.empty(); word = words_.word()) {
            if (lower(word) != "solid") refuse(word, "solid");
            take_solid(words_.rest_of_line(), solids++);
        }
        return std::move(maker_).made();
    }

  private:
    void take_solid(std::string_view name, int number) {
        std::string word = lower(next());
        for (; word == "facet"; word = lower(next())) {
            expect("normal");
            for (int k = 0; k < 3; ++k) static_cast<void>(next());  // corners say where outside is
            expect("outer");
            expect("loop");
            std::array<int, 3> corners{};
            for (int& corner : corners) {
                expect("vertex");
                Vec3 point;
                for (int axis = 0; axis < 3; ++axis) point[axis] = maker_.number(next(), axis, words_.where());
                corner = maker_.number_of(point);
            }
            expect("endloop");
            expect("endfacet");
            maker_.add(corners, name, number);
        }
        if (word != "endsolid") refuse(word, "facet or endsolid");
        static_cast<void>(words_.rest_of_line());  // its name again
    }

    std::string_view next() {
        const std::string_view word = words_.word();
        if (word.empty())
            throw InputError("{}: the file ends before endsolid, so it was cut off; export it anew", words_.where());
        return word;
    }

    void expect(std::string_view keyword) {
        if (const std::string_view word = next(); lower(word) != keyword) refuse(word, keyword);
    }

    [[noreturn]] void refuse(std::string_view word, std::string_view wanted) const {
        throw InputError("{}: {:?} stands where an STL text has {}; export the file anew", words_.where(),
                         beginning(word, 40), wanted);
    }

    TextWords words_;
    SurfaceMaker maker_;
};

template <typename Number>
Number little_endian(const char* bytes) {
    static_assert(std::endian::native == std::endian::little);
    Number number{};
    std::memcpy(&number, bytes, sizeof(number));
    return number;
}

Surface read_stl_bytes(const std::string& bytes, const std::string& file) {
    constexpr std::size_t header = 84;
    constexpr std::size_t each = 50;
    const std::size_t count = bytes.size() < header ? 0 : little_endian<std::uint32_t>(bytes.data() + 80);
    const std::size_t wanted = header + each * count;
    if (bytes.size() < wanted)
        throw InputError(
            "{}: it says that it has {} triangles, for which it needs {} bytes, and it has {}, so it was cut off; "
            "export it anew",
            file, count, wanted, bytes.size());
    if (bytes.find_first_not_of(std::string_view("\0 \t\r\n", 5), wanted) != std::string::npos)
        throw InputError(
            "{}: it says that it has {} triangles, which are {} bytes, and {} bytes follow; if it is several files in "
            "one, export them as one",
            file, count, wanted, bytes.size() - wanted);
    SurfaceMaker maker(file);
    for (std::size_t t = 0; t < count; ++t) {
        std::array<int, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const char* const from = bytes.data() + header + each * t + 12 * (k + 1);  // behind the normal
            Vec3 point;
            for (int axis = 0; axis < 3; ++axis)
                point[axis] = static_cast<double>(little_endian<float>(from + 4 * axis)) + 0.0;
            if (!point.allFinite())
                throw InputError("{}: a corner of triangle {} is not a number; export the file anew", file, t + 1);
            corners[k] = maker.number_of(point);
        }
        maker.add(corners, "", 0);
    }
    return std::move(maker).made();
}

/// Bytes may begin with "solid" too, but a text has no zeros.
Surface read_stl(const std::string& bytes, const std::string& file) {
    if (bytes.find('\0') != std::string::npos) return read_stl_bytes(bytes, file);
    if (lower(TextWords(bytes, file).word()) == "solid") return StlText(bytes, file).read();
    throw InputError("{}: this is no readable .stl file: as a text it would begin with solid; export it anew", file);
}

/// Across the way from a to b to c, as seen along `normal`.
double turn_at(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) {
    return normal.dot((b - a).cross(c - b));
}

/// A polygon, which may bend inwards, cut into triangles, ears first.
class Ears {
  public:
    Ears(const std::vector<Vec3>& points, std::vector<int> corners) : points_(points), left_(std::move(corners)) {
        for (std::size_t k = 1; k + 1 < left_.size(); ++k) normal_ += (at(k) - at(0)).cross(at(k + 1) - at(0));
    }

    std::vector<std::array<int, 3>> triangles() && {
        std::vector<std::array<int, 3>> found;
        while (left_.size() > 3) {
            std::size_t ear = 0;
            while (ear < left_.size() && !is_ear(ear)) ++ear;
            ear %= left_.size();  // where none is left the rest has no area
            found.push_back(corners_at(ear));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        found.push_back(corners_at(1));
        return found;
    }

  private:
    const Vec3& at(std::size_t k) const { return points_[static_cast<std::size_t>(left_[k % left_.size()])]; }

    std::array<int, 3> corners_at(std::size_t k) const {
        return {left_[(k + left_.size() - 1) % left_.size()], left_[k], left_[(k + 1) % left_.size()]};
    }

    bool is_ear(std::size_t k) const {
        const std::array<int, 3> own = corners_at(k);
        const Vec3& a = at(k + left_.size() - 1);
        const Vec3& b = at(k);
        const Vec3& c = at(k + 1);
        if (!(turn_at(normal_, a, b, c) > 0)) return false;
        return std::ranges::none_of(left_, [&](int other) {
            if (std::ranges::find(own, other) != own.end()) return false;
            const Vec3& p = points_[static_cast<std::size_t>(other)];
            return turn_at(normal_, a, b, p) >= 0 && turn_at(normal_, b, c, p) >= 0 && turn_at(normal_, c, a, p) >= 0;
        });
    }

    const std::vector<Vec3>& points_;
    std::vector<int> left_;
    Vec3 normal_ = Vec3::Zero();
};

class ObjText {
  public:
    ObjText(std::string_view text, const std::string& file) : lines_(text, file), maker_(file) {}

    Surface read() && {
        std::string continued;
        for (std::optional<std::string_view> line = lines_.line(); line; line = lines_.line()) {
            std::string_view own = trimmed(line->substr(0, line->find('#')), blanks);
            const bool goes_on = own.ends_with('\\');
            if (goes_on) own.remove_suffix(1);
            continued += own;
            continued += ' ';
            if (goes_on) continue;
            take(continued);
            continued.clear();
        }
        return std::move(maker_).made();
    }

  private:
    void take(std::string_view line) {
        TextWords words(line, "");
        const std::string keyword = lower(words.word());
        if (keyword == "v") {
            take_point(words);
        } else if (keyword == "f") {
            take_face(words);
        } else if (keyword == "g" || keyword == "o") {
            name_ = words.rest_of_line();
        } else if (constexpr std::array others{"", "vn", "vt", "s", "l", "p", "usemtl", "mtllib"};
                   std::ranges::find(others, keyword) == others.end()) {
            throw InputError("{}: {:?} is no statement of an OBJ file of polygons; export it anew, as a mesh",
                             lines_.where(), beginning(keyword, 40));
        }
    }

    void take_point(TextWords& words) {
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis) point[axis] = maker_.number(words.word(), axis, lines_.where());
        points_.push_back(point);
    }

    int number_of(std::string_view word) {
        const std::string_view first = word.substr(0, word.find('/'));
        int number = 0;
        const char* const end = first.data() + first.size();
        const auto [stop, fault] = std::from_chars(first.data(), end, number);
        const auto count = static_cast<std::ptrdiff_t>(points_.size());
        const std::ptrdiff_t index = number < 0 ? count + number : std::ptrdiff_t{number} - 1;
        if (fault != std::errc{} || stop != end || number == 0 || index < 0 || index >= count)
            throw InputError("{}: {:?} is none of the {} points above this face; export the file anew", lines_.where(),
                             beginning(word, 40), count);
        return maker_.number_of(points_[static_cast<std::size_t>(index)]);
    }

    void take_face(TextWords& words) {
        std::vector<int> corners;
        std::size_t given = 0;
        for (std::string_view word = words.word(); !word.empty(); word = words.word(), ++given)
            if (const int number = number_of(word); corners.empty() || corners.back() != number)
                corners.push_back(number);
        if (given < 3 || given > most_polygon_corners)
            throw InputError("{}: this face has {} corners; allowed: 3 to {}; export the file anew, as triangles",
                             lines_.where(), given, most_polygon_corners);
        while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        if (corners.size() < 3) return;
        for (const std::array<int, 3>& one : Ears(maker_.points(), std::move(corners)).triangles())
            maker_.add(one, name_, -1);
    }

    TextWords lines_;
    SurfaceMaker maker_;
    std::vector<Vec3> points_;
    std::string name_;
};

}  // namespace

Surface read_surface(const std::string& bytes, const std::string& file) {
    if (has_ending(file, ".stl")) return read_stl(bytes, file);
    if (has_ending(file, ".obj")) return ObjText(bytes, file).read();
    throw InputError("{}: hulls are read from .stl and .obj files; export one of these", file);
}

}  // namespace floes
