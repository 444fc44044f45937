// A pack of FLOES_LANES doubles and 3-vectors of packs. Included once for each instruction set, in an unnamed
// namespace, so that code made for one instruction set cannot be linked into another. Only operations that IEEE 754
// rounds exactly
// (+ - * / sqrt, comparisons): hence the same bits at every width.

#if FLOES_LANES == 1
using Pack = double;
inline Pack square_root(Pack x) {
    return __builtin_sqrt(x);
}
inline bool any_positive(Pack x) {
    return x > 0.0;
}
#else
using Pack [[gnu::vector_size(8 * FLOES_LANES)]] = double;
#if FLOES_LANES == 2
inline Pack square_root(Pack x) {
    return _mm_sqrt_pd(x);
}
inline bool any_positive(Pack x) {
    return _mm_movemask_pd(_mm_cmpgt_pd(x, _mm_setzero_pd())) != 0;
}
#elif FLOES_LANES == 4
inline Pack square_root(Pack x) {
    return _mm256_sqrt_pd(x);
}
inline bool any_positive(Pack x) {
    return _mm256_movemask_pd(_mm256_cmp_pd(x, _mm256_setzero_pd(), _CMP_GT_OQ)) != 0;
}
#else
inline Pack square_root(Pack x) {
    return _mm512_maskz_sqrt_pd(0xff, x);
}
inline bool any_positive(Pack x) {
    return _mm512_cmp_pd_mask(x, _mm512_setzero_pd(), _CMP_GT_OQ) != 0;
}
#endif
#endif

inline constexpr int lanes = FLOES_LANES;

template <int... lane>
struct Sequence {};
#if FLOES_LANES == 1
using EveryLane = Sequence<0>;
#elif FLOES_LANES == 2
using EveryLane = Sequence<0, 1>;
#elif FLOES_LANES == 4
using EveryLane = Sequence<0, 1, 2, 3>;
#else
using EveryLane = Sequence<0, 1, 2, 3, 4, 5, 6, 7>;
#endif

inline Pack load(const double* group, int field) {
    return *reinterpret_cast<const Pack*>(group + field * lanes);
}

inline void store(double* group, int field, Pack value) {
    *reinterpret_cast<Pack*>(group + field * lanes) = value;
}

inline Pack absolute(Pack x) {
    return x < 0.0 ? -x : x;
}

inline Pack least(Pack x, Pack y) {
    return x < y ? x : y;
}

inline Pack most(Pack x, Pack y) {
    return x > y ? x : y;
}

/// Where a group begins in an array of `fields` a group.
template <class Number>
inline Number* group_of(Number* array, int fields, std::size_t group) {
    return array + group * static_cast<std::size_t>(fields * lanes);
}

struct V3 {
    Pack x, y, z;
};

inline V3 load3(const double* group, int field) {
    return {load(group, field), load(group, field + 1), load(group, field + 2)};
}

inline void store3(double* group, int field, const V3& v) {
    store(group, field, v.x);
    store(group, field + 1, v.y);
    store(group, field + 2, v.z);
}

inline V3 operator+(const V3& a, const V3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline V3 operator-(const V3& a, const V3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline V3 operator*(const V3& a, Pack s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Pack dot(const V3& a, const V3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline V3 cross(const V3& a, const V3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline V3 unit(const V3& a) {
    return a * (1.0 / square_root(dot(a, a)));
}

/// Symmetric 3x3.
struct S3 {
    Pack xx, xy, xz, yy, yz, zz;
};

inline S3 load_symmetric(const double* group, int field) {
    return {load(group, field),     load(group, field + 1), load(group, field + 2),
            load(group, field + 3), load(group, field + 4), load(group, field + 5)};
}

inline V3 operator*(const S3& m, const V3& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

inline S3 operator+(const S3& a, const S3& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}

/// 3x3 by columns.
struct M3 {
    V3 x, y, z;
};

inline M3 load_matrix(const double* group, int field) {
    M3 m;
    m.x = {load(group, field), load(group, field + 3), load(group, field + 6)};
    m.y = {load(group, field + 1), load(group, field + 4), load(group, field + 7)};
    m.z = {load(group, field + 2), load(group, field + 5), load(group, field + 8)};
    return m;
}

inline V3 operator*(const M3& m, const V3& v) {
    return m.x * v.x + m.y * v.y + m.z * v.z;
}

inline M3 operator*(const M3& a, const M3& b) {
    return {a * b.x, a * b.y, a * b.z};
}

inline V3 transposed_times(const M3& m, const V3& v) {
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
