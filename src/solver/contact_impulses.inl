// How the impulses of a contact are updated: a normal row by itself, or with both friction rows in Coulomb's cone. The
// same for contacts of bodies (contact_kernels.inl) and of whole pieces (direct_contacts.inl).

/// Factor that brings (x, y) into the circle about 0, along the line to its centre; 1 inside. Radius >= 0.
inline Pack in_circle(Pack x, Pack y, Pack radius) {
    const Pack square = x * x + y * y;
    return square > radius * radius ? radius / square_root(square) : Pack{} + 1.0;
}

/// New impulse of normal row i, whose impulse was `old`: it stops the approach, up to the row's limit.
template <bool limited>
[[gnu::always_inline]] inline Pack normal_impulse(const double* target, const LimitArrays& limits, int i, Pack old,
                                                  Pack velocity) {
    const Pack none{};
    const Pack stops = old + (load(target, i) - velocity);
    if constexpr (!limited) {
        return stops > 0.0 ? stops : none;
    } else {
        const Pack yields = load(limits.yield, i) + load(limits.give, i) * (old - velocity);
        const Pack total = stops < yields ? stops : yields;
        return total > 0.0 ? total : none;
    }
}

/// Rows of cones: normal, first and second friction direction.
struct ConeArrays {
    const double* target[3];
    double* impulse[3];
};

/// Sliding velocity along the two friction rows, scaled like them.
struct Sliding {
    Pack first, second;
};

/// Coulomb's cone: the normal row, then an explicit step of both friction rows together and back to the circle of the
/// normal impulse. With one effective mass for both this is a projected gradient step: where it comes to rest, friction
/// points against the sliding velocity or nothing slides, whatever the basis. A 2 x 2 solve scaled back would turn
/// friction off that line. The three rows see what they do to each other through their coupling.
///
/// `contact` is that of rows i: approach() is the velocity along its normal row; sliding(pressed) that along its
/// friction rows once the normal row has exerted `pressed`; bound(normal) the radius of the circle; press(pressed)
/// moves its bodies by an impulse of the normal row alone, push(pressed, first, second) by those of all rows.
template <bool limited, class Contact>
[[gnu::always_inline]] inline void solve_cone(const ConeArrays& all, const LimitArrays& limits, int i,
                                              Contact&& contact) {
    const Pack old = load(all.impulse[0], i);
    const Pack normal = normal_impulse<limited>(all.target[0], limits, i, old, contact.approach());
    const Pack pressed = normal - old;
    store(all.impulse[0], i, normal);
    const Pack old_first = load(all.impulse[1], i);
    const Pack old_second = load(all.impulse[2], i);
    const Pack held = absolute(old_first) + absolute(old_second);
    if (!any_positive(normal + held)) {  // no friction, neither before nor now
        contact.press(pressed);
        return;
    }
    const Sliding sliding = contact.sliding(pressed);
    const Pack first_total = old_first + (load(all.target[1], i) - sliding.first);
    const Pack second_total = old_second + (load(all.target[2], i) - sliding.second);
    const Pack cut = in_circle(first_total, second_total, contact.bound(normal));
    const Pack first = first_total * cut;
    const Pack second = second_total * cut;
    store(all.impulse[1], i, first);
    store(all.impulse[2], i, second);
    contact.push(pressed, first - old_first, second - old_second);
}
