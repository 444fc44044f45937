#pragma once
// The whole state of an object as bytes, and set again. One function lists it for both ways:
//
//     void Lee::archive(StateArchive& state) {
//         auto& [draughts, ..., due] = *this;    // does not compile until a new member is thought of
//         state(ahead, seen, due);               // what its next steps depend on, and it is not made with
//     }
//
//     StateArchive out;                 StateArchive in(bytes);
//     lee.archive(out);                 other.archive(in);    // made with the same arguments
//     out.take();                       in.end();
//
// Numbers, enumerations, vectors of Eigen, arrays, vectors and optional values of these, classes with such a function,
// and aggregates of at most 16 of all these, field by field. Bytes are those of this machine: a state is set again by
// the program that saved it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/bytes.hpp"
#include "core/error.hpp"

namespace floes {

class StateArchive;

namespace archived {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// Initialises any field.
struct Anything {
    template <class T>
    requires(!is_optional<T>)  // which is made of its value
    operator T() const;
};

template <class T, std::size_t... field>
constexpr bool has_fields(std::index_sequence<field...>) {
    return requires {
        T{(static_cast<void>(field), Anything{})...};
    };
}

template <class T, std::size_t most = 16>
constexpr std::size_t field_count() {
    if constexpr (most == 0 || has_fields<T>(std::make_index_sequence<most>{}))
        return most;
    else
        return field_count<T, most - 1>();
}

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class T>
concept Listed = requires(T& item, StateArchive& state) {
    item.archive(state);
};

template <class T>
concept Coefficients = std::is_base_of_v<Eigen::PlainObjectBase<T>, T> && T::SizeAtCompileTime != Eigen::Dynamic;

}  // namespace archived

class StateArchive {
  public:
    /// Of what it is given from now on.
    StateArchive() = default;
    /// Sets what it is given from now on to what is in the bytes, which must stay.
    explicit StateArchive(std::span<const std::byte> saved) : rest_(saved), sets_(true) {}

    bool sets() const { return sets_; }

    template <class... Items>
    void operator()(Items&... items) {
        (item(items), ...);
    }

    /// The same for elements that are not made of nothing.
    template <class T>
    void list(std::vector<T>& items, const T& blank) {
        items.resize(count_of(items), blank);
        contents(items);
    }
    template <class T>
    void maybe(std::optional<T>& value, const T& blank) {
        bool is_there = value.has_value();
        item(is_there);
        if (!is_there) value.reset();
        if (is_there && !value) value = blank;
        if (value) item(*value);
    }

    /// What must be equal in the object that is set. Throws RunError where it is not.
    template <class T>
    void same(T known) {
        T value = known;
        item(value);
        if (value != known) refuse();
    }

    /// Everything so far.
    Bytes take() { return std::move(saved_); }
    /// To be called when all is set. Throws RunError if there are more bytes.
    void end() const {
        if (!rest_.empty()) refuse();
    }

  private:
    [[noreturn]] static void refuse() { throw RunError("The saved state is not one of this simulation."); }

    void bytes(void* at, std::size_t size) {
        if (size == 0) return;
        if (sets_) {
            if (size > rest_.size()) refuse();
            std::memcpy(at, rest_.data(), size);
            rest_ = rest_.subspan(size);
            return;
        }
        const auto* first = static_cast<const std::byte*>(at);
        saved_.insert(saved_.end(), first, first + size);
    }

    template <class T>
    std::size_t count_of(const std::vector<T>& items) {
        std::uint64_t count = items.size();
        item(count);
        if (sets_ && count > rest_.size()) refuse();
        return static_cast<std::size_t>(count);
    }
    template <class T>
    void contents(std::vector<T>& items) {
        if constexpr (std::is_arithmetic_v<T>)
            bytes(items.data(), items.size() * sizeof(T));
        else
            for (T& one : items) item(one);
    }

    template <archived::Number T>
    void item(T& number) {
        bytes(&number, sizeof number);
    }
    template <archived::Listed T>
    void item(T& object) {
        object.archive(*this);
    }
    template <archived::Coefficients T>
    void item(T& matrix) {
        bytes(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(typename T::Scalar));
    }
    void item(Eigen::Quaterniond& turn) { item(turn.coeffs()); }
    template <class T, std::size_t count>
    void item(std::array<T, count>& items) {
        for (T& one : items) item(one);
    }
    template <class T, std::size_t count>
    void item(T (&items)[count]) {
        for (T& one : items) item(one);
    }
    template <class A, class B>
    void item(std::pair<A, B>& two) {
        (*this)(two.first, two.second);
    }
    template <class T>
    void item(std::vector<T>& items) {
        items.resize(count_of(items));
        contents(items);
    }
    void item(std::vector<bool>& items) {
        std::vector<std::uint8_t> each(items.begin(), items.end());
        item(each);
        items.assign(each.begin(), each.end());
    }
    template <class T>
    void item(std::optional<T>& value) {
        maybe(value, T());
    }
    template <class T>
    requires(std::is_aggregate_v<T> && !archived::Listed<T> && !std::is_array_v<T>) void item(T& fields) {
        each(fields);
    }

    template <class T>
    void each(T& of) {
        constexpr std::size_t count = archived::field_count<T>();
        static_assert(count > 0, "A field is of no kind that an archive knows.");
        if constexpr (count == 1) {
            auto& [a] = of;
            (*this)(a);
        } else if constexpr (count == 2) {
            auto& [a, b] = of;
            (*this)(a, b);
        } else if constexpr (count == 3) {
            auto& [a, b, c] = of;
            (*this)(a, b, c);
        } else if constexpr (count == 4) {
            auto& [a, b, c, d] = of;
            (*this)(a, b, c, d);
        } else if constexpr (count == 5) {
            auto& [a, b, c, d, e] = of;
            (*this)(a, b, c, d, e);
        } else if constexpr (count == 6) {
            auto& [a, b, c, d, e, f] = of;
            (*this)(a, b, c, d, e, f);
        } else if constexpr (count == 7) {
            auto& [a, b, c, d, e, f, g] = of;
            (*this)(a, b, c, d, e, f, g);
        } else if constexpr (count == 8) {
            auto& [a, b, c, d, e, f, g, h] = of;
            (*this)(a, b, c, d, e, f, g, h);
        } else if constexpr (count == 9) {
            auto& [a, b, c, d, e, f, g, h, i] = of;
            (*this)(a, b, c, d, e, f, g, h, i);
        } else if constexpr (count == 10) {
            auto& [a, b, c, d, e, f, g, h, i, j] = of;
            (*this)(a, b, c, d, e, f, g, h, i, j);
        } else if constexpr (count == 11) {
            auto& [a, b, c, d, e, f, g, h, i, j, k] = of;
            (*this)(a, b, c, d, e, f, g, h, i, j, k);
        } else if constexpr (count == 12) {
            auto& [a, b, c, d, e, f, g, h, i, j, k, l] = of;
            (*this)(a, b, c, d, e, f, g, h, i, j, k, l);
        } else if constexpr (count == 13) {
            auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = of;
            (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m);
        } else if constexpr (count == 14) {
            auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = of;
            (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
        } else if constexpr (count == 15) {
            auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = of;
            (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o);
        } else {
            auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = of;
            (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p);
        }
    }

    Bytes saved_;
    std::span<const std::byte> rest_;
    bool sets_ = false;
};

}  // namespace floes
