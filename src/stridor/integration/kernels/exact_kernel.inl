// The loops of kernel.hpp, part of kernels/loops.inl. One cell across the lanes of a vector: the eight numbers of its
// state.

#include "stridor/integration/kernels/lanes_vector.inl"

namespace stridor::integration::STRIDOR_ISA {

namespace {

// how near zero a Bernstein coefficient may come, as a share of the largest: degree 7 misses 2e-7 of the vibration, of
// which an event function may show a small part
constexpr double nearness = 1e-4;

// a matrix times a state; the eighth number of a state is unused
STRIDOR_INLINE Vector times(const Matrix8& m, const double* s) {
    const Vector a = load(m.column[0]) * s[0] + load(m.column[1]) * s[1];
    const Vector b = load(m.column[2]) * s[2] + load(m.column[3]) * s[3];
    const Vector c = load(m.column[4]) * s[4] + load(m.column[5]) * s[5];
    return (a + b) + (c + load(m.column[6]) * s[6]);
}

// what must be positive if no event function comes near zero during the step
STRIDOR_INLINE double margin(const Flow& flow, const double* s) {
    const Vector b = times(flow.test[0].bernstein, s);
    Vector least = b + -nearness * largest(b);
    if (flow.test_count > 1) {
        const Vector c = times(flow.test[1].bernstein, s);
        least = smaller(least, c + -nearness * largest(c));
    }
    return smallest(least);
}

// velocities and powers at nodes, added up
template <int dofs>
class Meter {
public:
    explicit Meter(const Sums& sums) {
        for (int k = 0; k < products; ++k)
            product_[k] = load(sums.product[k]);
        for (int i = 0; i < bodies; ++i)
            peak_[i] = load(sums.peak[i]);
        on_slip_ = load(sums.on_slip);
        on_surface_ = load(sums.on_surface);
    }

    // `weigh` puts the weights of the nodes in, or leaves that for later
    template <typename Weigh>
    void add(const Vector* velocity, int count, const Vector& force, const Vector& surface, bool slips, Weigh weigh) {
        int k = 0;
        for (int j = 0; j < count; ++j)
            for (int i = 0; i <= j; ++i, ++k)
                product_[k] = product_[k] + weigh(velocity[i] * velocity[j]);
        if (count == dofs) return;
        on_surface_ = on_surface_ + weigh(force * surface);
        if (slips) on_slip_ = on_slip_ + weigh(force * (velocity[0] - surface));
    }

    void watch(const Vector* velocity, int count, const double (&basis)[most_coordinates][most_coordinates]) {
        Vector square[dofs];
        for (int i = 0; i < dofs; ++i) {
            Vector u = velocity[0] * basis[i][0];
            for (int j = 1; j < count; ++j)
                u = u + velocity[j] * basis[i][j];
            square[i] = u * u;
        }
        peak_[0] = larger(peak_[0], square[0] + square[1]);
        for (int i = 1; i < bodies; ++i)
            peak_[i] = larger(peak_[i], square[i + 1]);
    }

    void save_to(Sums& sums) const {
        for (int k = 0; k < products; ++k)
            save(product_[k], sums.product[k]);
        for (int i = 0; i < bodies; ++i)
            save(peak_[i], sums.peak[i]);
        save(on_slip_, sums.on_slip);
        save(on_surface_, sums.on_surface);
    }

private:
    static constexpr int products = dofs * (dofs + 1) / 2;
    static constexpr int bodies = dofs - 1;  // the rubbing one moves along and across, any other along one direction
    Vector product_[products];
    Vector peak_[bodies];
    Vector on_slip_, on_surface_;
};

template <int dofs, ContactMode mode>
STRIDOR_INLINE void step(const Flow& flow, double* s, Meter<dofs>& meter) {
    constexpr int count = mode == ContactMode::open ? dofs : dofs - 1;
    Vector velocity[count];
    for (int j = 0; j < count; ++j)
        velocity[j] = times(flow.velocity[j], s);
    Vector force{}, surface{};
    if constexpr (mode != ContactMode::open) {
        force = times(flow.force, s);
        surface = load(flow.surface.column[2 * dofs - 1]) * s[2 * dofs - 1] +
                  load(flow.surface.column[2 * dofs]) * s[2 * dofs];
    }
    meter.add(velocity, count, force, surface, mode != ContactMode::stick, [](const Vector& sum) { return sum; });
    meter.watch(velocity, count, flow.basis);
    const Vector next = times(flow.advance, s);
    save(next, s);
}

template <int dofs, ContactMode mode>
long glide_in(const Flow& flow, Lanes& s, long steps, Sums& sums) {
    Meter<dofs> meter(sums);
    alignas(64) double state[lanes];
    __builtin_memcpy(state, s.at, sizeof state);
    long taken = 0;
    for (; taken < steps; ++taken) {
        if (!(margin(flow, state) > 0.0)) break;
        step<dofs, mode>(flow, state, meter);
    }
    __builtin_memcpy(s.at, state, sizeof state);
    meter.save_to(sums);
    return taken;
}

template <int dofs, ContactMode mode>
void leap_in(const Flow& flow, Lanes& s, Sums& sums) {
    Meter<dofs> meter(sums);
    step<dofs, mode>(flow, s.at, meter);
    meter.save_to(sums);
}

template <int dofs>
long glide(const Flow& flow, Lanes& s, long steps, Sums& sums) {
    if (flow.mode == ContactMode::open) return glide_in<dofs, ContactMode::open>(flow, s, steps, sums);
    if (flow.mode == ContactMode::stick) return glide_in<dofs, ContactMode::stick>(flow, s, steps, sums);
    return glide_in<dofs, ContactMode::slip_forward>(flow, s, steps, sums);
}

template <int dofs>
void leap(const Flow& flow, Lanes& s, Sums& sums) {
    if (flow.mode == ContactMode::open) return leap_in<dofs, ContactMode::open>(flow, s, sums);
    if (flow.mode == ContactMode::stick) return leap_in<dofs, ContactMode::stick>(flow, s, sums);
    return leap_in<dofs, ContactMode::slip_forward>(flow, s, sums);
}

unsigned look(const Flow& flow, const Lanes& s, int multiplicity, Lanes* bernstein) {
    unsigned near = 0;
    for (int k = 0; k < flow.test_count; ++k) {
        const bool begins_at_root = multiplicity > 0 && k == flow.test_count - 1;
        const Vector b = times(begins_at_root ? flow.divided[multiplicity - 1] : flow.test[k].bernstein, s.at);
        save(b, bernstein[k]);
        if (!(smallest(b + -nearness * largest(b)) > 0.0)) near |= 1U << static_cast<unsigned>(k);
    }
    return near;
}

void combine(const Lanes* what, const Lanes* series, int count, Matrix8& result) {
    Vector column[lanes]{};
    for (int k = count - 1; k >= 0; --k) {  // small terms first
        const Vector weights = load(what[k]);
        for (int j = 0; j < lanes; ++j)
            column[j] = column[j] + weights * series[k].at[j];
    }
    for (int j = 0; j < lanes; ++j)
        save(column[j], result.column[j]);
}

// value (lanes 0 to 3) and slope (4 to 7) of a polynomial, each in four interleaved chains
class Quotient {
public:
    Quotient(const Lanes* series, int multiplicity) {
        double c[terms + most_multiplicity + 1]{};
        __builtin_memcpy(c, series, sizeof(double) * terms);
        const double* a = c + multiplicity;
        for (int k = 0; k < chain; ++k, a += 4) {
            const double n = 4.0 * k;
            const Vector both = of(a[0], a[1], a[2], a[3], a[1], a[2], a[3], a[4]);
            term_[k] = both * of(1.0, 1.0, 1.0, 1.0, n + 1.0, n + 2.0, n + 3.0, n + 4.0);
        }
    }

    void at(double x, double& value, double& slope) const {
        const double x2 = x * x;
        const double x3 = x2 * x;
        const double x4 = x2 * x2;
        Vector p = term_[chain - 1];
        for (int k = chain - 2; k >= 0; --k)
            p = p * x4 + term_[k];
        sums_of_four(p * of(1.0, x, x2, x3, 1.0, x, x2, x3), value, slope);
    }

private:
    static constexpr int chain = terms / 4;
    Vector term_[chain];
};

double root(const Lanes* series, int multiplicity, double from, double to, double start, Falling falls) {
    // a step this small leaves an error of its square
    constexpr double close = 1e-9;
    const Quotient q(series, multiplicity);
    double value = 0.0, slope = 0.0;
    if (falls == Falling::perhaps) {
        q.at(to, value, slope);
        if (!(value <= 0.0)) return no_crossing;
    }
    double x = start;
    for (int k = 0; k < 80; ++k) {
        q.at(x, value, slope);
        if (value > 0.0)
            from = x;
        else
            to = x;
        double next = x - value / slope;
        if (!(next >= from && next <= to)) next = 0.5 * (from + to);
        const double change = next > x ? next - x : x - next;
        x = next;
        if (change <= close * x || change < 0x1p-70) break;
    }
    return x;
}

// terms of a series over a part of a step: (2 tau)^n / n! is far below rounding
STRIDOR_INLINE int terms_for(double tau) {
    return tau <= 0.25 ? 16 : tau <= 0.5 ? 20 : terms;
}

// Horner's rule on the columns of the series, side by side: eight independent chains
void move(const Flow& flow, const Lanes& s, double tau, Lanes& result) {
    const int count = terms_for(tau);
    Vector column[lanes - 1];
    for (int j = 0; j < lanes - 1; ++j)
        column[j] = load(flow.power[count - 1].column[j]);
    for (int k = count - 2; k >= 0; --k)
        for (int j = 0; j < lanes - 1; ++j)
            column[j] = column[j] * tau + load(flow.power[k].column[j]);
    const Vector a = column[0] * s.at[0] + column[1] * s.at[1];
    const Vector b = column[2] * s.at[2] + column[3] * s.at[3];
    const Vector c = column[4] * s.at[4] + column[5] * s.at[5];
    save((a + b) + (c + column[6] * s.at[6]), result);
}

void apply(const Matrix8* blocks, int count, const Lanes& s, Lanes* result) {
    for (int k = 0; k < count; ++k)
        save(times(blocks[k], s.at), result[k]);
}

// values at the nodes of a part of a step of a functional given by its series
STRIDOR_INLINE Vector series_at(const Matrix8 (&series)[term_blocks], const double* s, const Vector& tau, int count) {
    alignas(64) double coefficient[terms];
    for (int block = 0; block < (count + lanes - 1) / lanes; ++block) {
        const Vector part = times(series[block], s);
        save(part, coefficient + block * lanes);
    }
    Vector value = Vector{} + coefficient[count - 1];
    for (int k = count - 2; k >= 0; --k)
        value = value * tau + coefficient[k];
    return value;
}

template <int dofs>
void add_part(const Flow& flow, const Lanes& s, double tau_0, double tau_1, Sums& sums) {
    const Vector tau = load(flow.quadrature.node) * (tau_1 - tau_0) + tau_0;
    const Vector weight = load(flow.quadrature.weight) * ((tau_1 - tau_0) * flow.step);
    const bool is_open = flow.mode == ContactMode::open;
    const int count = is_open ? dofs : dofs - 1;
    Vector velocity[dofs];
    const int length = terms_for(tau_1);
    for (int j = 0; j < count; ++j)
        velocity[j] = series_at(flow.velocity_series[j], s.at, tau, length);
    Vector force{}, surface{};
    if (!is_open) {
        force = series_at(flow.force_series, s.at, tau, length);
        // V in stick is x'; a straight V needs no series
        const bool is_straight = flow.surface_rate == 0.0;
        surface = is_straight ? tau * (s.at[2 * dofs] * flow.step) + s.at[2 * dofs - 1]
                              : series_at(flow.surface_series, s.at, tau, length);
    }
    Meter<dofs> meter(sums);
    meter.add(velocity, count, force, surface, flow.mode != ContactMode::stick,
              [&](const Vector& sum) { return sum * weight; });
    meter.watch(velocity, count, flow.basis);
    meter.save_to(sums);
}

}  // namespace

}  // namespace stridor::integration::STRIDOR_ISA
