// Contact rows, one after the other, three coordinates of a body side by side. Rows come ordered so that neighbours
// touch different bodies where the order of solving allows it: the machine then works on several at once.

using Quad [[gnu::vector_size(32)]] = double;
using QuadMask [[gnu::vector_size(32)]] = long long;

inline Quad load_quad(const double* p) {
    return *reinterpret_cast<const Quad*>(p);
}

inline void store_quad(double* p, Quad value) {
    *reinterpret_cast<Quad*>(p) = value;
}

/// The three coordinates; 0 in the place of the scalar.
inline Quad coordinates(Quad v) {
    return QuadMask{-1, -1, -1, 0} ? v : Quad{0, 0, 0, 0};
}

inline double sum(Quad p) {
    return (p[0] + p[2]) + (p[1] + p[3]);
}

/// Relative velocity change along the scaled row. The fourth place of a body's change is 0.
inline double along(const ContactRow& row, const double* a, const double* b) {
    return sum(load_quad(row.axis) * (load_quad(a) - load_quad(b)) +
               (load_quad(row.torque_a) * load_quad(a + 4) - load_quad(row.torque_b) * load_quad(b + 4)));
}

inline void push(const ContactRow& row, double* a, double* b, double impulse) {
    const Quad axis = coordinates(load_quad(row.axis));
    store_quad(a, load_quad(a) + axis * (row.spin_a[3] * impulse));
    store_quad(a + 4, load_quad(a + 4) + coordinates(load_quad(row.spin_a)) * impulse);
    store_quad(b, load_quad(b) - axis * (row.spin_b[3] * impulse));
    store_quad(b + 4, load_quad(b + 4) - coordinates(load_quad(row.spin_b)) * impulse);
}

// The impulse applied is the difference of the accumulated ones, clamped or not: no branch, and it rounds to the same.

void solve_normals(double* delta, ContactRow* rows, const ContactBodies* bodies, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        ContactRow& row = rows[i];
        double* a = delta + 8 * static_cast<std::size_t>(bodies[i].a);
        double* b = delta + 8 * static_cast<std::size_t>(bodies[i].b);
        const double old = row.torque_a[3];
        const double total = old + (row.axis[3] - along(row, a, b));
        const double next = total > 0.0 ? total : 0.0;
        row.torque_a[3] = next;
        push(row, a, b, next - old);
    }
}

void solve_frictions(double* delta, ContactRow* rows, const ContactRow* normals, const ContactBodies* bodies,
                     std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double normal = normals[i].torque_a[3];
        if (!(normal > 0.0)) {
            continue;  // as in Bullet, friction keeps its impulse while the normal row has none
        }
        ContactRow& row = rows[i];
        double* a = delta + 8 * static_cast<std::size_t>(bodies[i].a);
        double* b = delta + 8 * static_cast<std::size_t>(bodies[i].b);
        const double bound = row.torque_b[3] * normal;
        const double old = row.torque_a[3];
        const double total = old + (row.axis[3] - along(row, a, b));
        const double capped = total < bound ? total : bound;
        const double next = capped > -bound ? capped : -bound;
        row.torque_a[3] = next;
        push(row, a, b, next - old);
    }
}
