// Series: exp(A h) = sum of (A h)^k / k!. Event functions are c.s(t), coefficients c.A^k h^k/k! s over tau = t/h.
//
// Bernstein form: the polynomial of degree 7 through eight Chebyshev points of [0, 1] misses a function of rate 2 by
// 2 (2/4)^8 / 8! = 2e-7 of its amplitude; written with Bernstein's polynomials its smallest coefficient
// bounds it from below.
//
// Accuracy in the drive's numbers: V and W turn by omega h per step, a rotation like any other column of A.

#include "stridor/integration/exact/flow.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

constexpr int bernstein_degree = 7;
// Omega h: longer steps cost accuracy of the series (2^24/24! = 3e-17) and of the bounds, shorter ones time
constexpr double reach = 2.0;

using Rows = std::array<Lanes, lanes>;  // a matrix by rows

Matrix8 columns_of(const Rows& rows) {
    Matrix8 m;
    for (int i = 0; i < lanes; ++i)
        for (int j = 0; j < lanes; ++j)
            m.column[j].at[i] = rows[static_cast<std::size_t>(i)].at[j];
    return m;
}

// inverse of a small well-conditioned matrix, Gauss-Jordan with row exchange
std::array<std::array<double, 8>, 8> inverse(std::array<std::array<double, 8>, 8> a) {
    std::array<std::array<double, 8>, 8> b{};
    for (std::size_t i = 0; i < 8; ++i)
        b[i][i] = 1.0;
    for (std::size_t k = 0; k < 8; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < 8; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        const double scale = 1.0 / a[k][k];
        for (std::size_t j = 0; j < 8; ++j) {
            a[k][j] *= scale;
            b[k][j] *= scale;
        }
        for (std::size_t i = 0; i < 8; ++i) {
            const double factor = a[i][k];
            if (i == k || factor == 0.0) continue;
            for (std::size_t j = 0; j < 8; ++j) {
                a[i][j] -= factor * a[k][j];
                b[i][j] -= factor * b[k][j];
            }
        }
    }
    return b;
}

double power(double x, int exponent) {
    double result = 1.0;
    for (int k = 0; k < exponent; ++k)
        result *= x;
    return result;
}

const Quadrature& quadrature() {
    // Gauss-Legendre with 8 points, Abramowitz and Stegun, table 25.4
    static const Quadrature rule = [] {
        constexpr std::array<double, 4> point{0.1834346424956498049395, 0.5255324099163289858177,
                                              0.7966664774136267395916, 0.9602898564975362316836};
        constexpr std::array<double, 4> weight{0.3626837833783619829652, 0.3137066458778872873380,
                                               0.2223810344533744705444, 0.1012285362903762591525};
        Quadrature q{};
        for (int i = 0; i < 4; ++i) {
            const auto k = static_cast<std::size_t>(i);
            q.node.at[3 - i] = 0.5 - 0.5 * point[k];
            q.node.at[4 + i] = 0.5 + 0.5 * point[k];
            q.weight.at[3 - i] = q.weight.at[4 + i] = 0.5 * weight[k];
        }
        return q;
    }();
    return rule;
}

// values at the nodes, and Bernstein coefficients of the interpolating polynomial, of each monomial tau^k; shape [k][8]
struct Monomials {
    std::array<Lanes, terms> at_nodes;
    std::array<Lanes, terms> bernstein;
};

Monomials make_monomials() {
    constexpr std::array<double, 8> binomial{1, 7, 21, 35, 35, 21, 7, 1};
    std::array<double, 8> chebyshev{};
    std::array<std::array<double, 8>, 8> basis{};
    for (std::size_t i = 0; i < 8; ++i) {
        chebyshev[i] = 0.5 - 0.5 * base::sine_cosine_of_turns((2.0 * static_cast<double>(i) + 1.0) / 32.0).cosine;
        for (std::size_t j = 0; j < 8; ++j)
            basis[i][j] = binomial[j] * power(chebyshev[i], static_cast<int>(j)) *
                          power(1.0 - chebyshev[i], bernstein_degree - static_cast<int>(j));
    }
    const auto from_values = inverse(basis);
    Monomials m{};
    for (int k = 0; k < terms; ++k) {
        const auto place = static_cast<std::size_t>(k);
        for (int i = 0; i < lanes; ++i) {
            m.at_nodes[place].at[i] = power(quadrature().node.at[i], k);
            for (std::size_t j = 0; j < 8; ++j)
                m.bernstein[place].at[i] += from_values[static_cast<std::size_t>(i)][j] * power(chebyshev[j], k);
        }
    }
    return m;
}

const Monomials& monomials() {
    static const Monomials table = make_monomials();
    return table;
}

// rows c.A^k h^k/k!, k = 0..terms-1
using Series = std::array<Lanes, terms>;

void store(const Series& series, Matrix8 (&blocks)[term_blocks]) {
    for (int block = 0; block < term_blocks; ++block)
        for (int i = 0; i < lanes; ++i)
            for (int j = 0; j < lanes; ++j)
                blocks[block].column[j].at[i] = series[static_cast<std::size_t>(block * lanes + i)].at[j];
}

Lanes sum(const Lanes& a, const Lanes& b, double factor) {
    Lanes result{};
    for (int i = 0; i < lanes; ++i)
        result.at[i] = a.at[i] + factor * b.at[i];
    return result;
}

Lanes scaled(const Lanes& a, double factor) {
    return sum(Lanes{}, a, factor);
}

// prepares all flows of one structure
template <int dofs>
class Preparation {
public:
    Preparation(const ContactCoordinates<dofs>& c, const model::FrictionLaw& friction, double drive_frequency,
                const Kernel& loops)
        : c_(c),
          friction_(friction),
          loops_(loops),
          omega_(base::two_pi * drive_frequency) {}

    Flows run() {
        describe();
        set_open(flows_.flow[static_cast<int>(ContactMode::open)]);
        set_stick(flows_.flow[static_cast<int>(ContactMode::stick)]);
        for (const model::Slip way : model::slips)
            set_slip(flows_.flow[static_cast<int>(slip_mode(way))], way);
        return flows_;
    }

private:
    static constexpr int closed = dofs - 1;

    static Lanes unit(int lane) {
        Lanes row{};
        row.at[lane] = 1.0;
        return row;
    }

    // K z + C z' - f0 of one coordinate while closed: the force that its acceleration or the contact must balance
    Lanes internal_force(int coordinate) const {
        Lanes row{};
        for (int j = 0; j < closed; ++j) {
            row.at[j] = c_.stiffness(coordinate, j);
            row.at[velocity_lane(closed, j)] = c_.damping(coordinate, j);
        }
        row.at[load_lane(closed)] = -c_.load(coordinate);
        return row;
    }

    Lanes surface_acceleration() const { return scaled(unit(surface_lane(closed) + 1), omega_ > 0.0 ? -omega_ : 1.0); }

    void describe() {
        flows_.dofs = dofs;
        for (int i = 0; i < dofs; ++i) {
            flows_.mass[i] = c_.mass(i);
            for (int j = 0; j < dofs; ++j) {
                flows_.basis[i][j] = c_.basis(i, j);
                flows_.damping[i][j] = c_.damping(i, j);
            }
        }
        flows_.tangent_on_gap = c_.tangent_on_gap;
    }

    // largest rate [1/s] of z'' = -M^-1 (K z + C z'): norms of the matrices scaled by the square roots of the masses
    double rate(int count, double friction_in_x) const {
        double stiff = 0.0, damped = 0.0;
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) {
                const double mass = c_.mass(i) * c_.mass(j);
                const double from_friction = i == 0 ? friction_in_x : 0.0;
                const double k = c_.stiffness(i, j) + from_friction * c_.stiffness(closed, j);
                const double d = c_.damping(i, j) + from_friction * c_.damping(closed, j);
                stiff += k * k / mass;
                damped += d * d / mass;
            }
        return std::sqrt(std::sqrt(stiff)) + std::sqrt(damped);
    }

    // rows of A that all closed states share; the accelerations are left to the caller
    Rows closed_generator() const {
        Rows a{};
        for (int i = 0; i < closed; ++i)
            a[static_cast<std::size_t>(i)] = unit(velocity_lane(closed, i));
        for (int i = 1; i < closed; ++i)
            a[static_cast<std::size_t>(velocity_lane(closed, i))] = scaled(internal_force(i), -1.0 / c_.mass(i));
        a[static_cast<std::size_t>(surface_lane(closed))] = surface_acceleration();
        a[static_cast<std::size_t>(surface_lane(closed)) + 1] = scaled(unit(surface_lane(closed)), omega_);
        return a;
    }

    // A h, and its transpose for rows
    void set_powers(Flow& flow, ContactMode mode, Rows generator, double fastest) {
        flow.mode = mode;
        flow.step = reach / fastest;
        flow.surface_rate = omega_;
        flow.quadrature = quadrature();
        for (int i = 0; i < dofs; ++i)
            for (int j = 0; j < dofs; ++j)
                flow.basis[i][j] = c_.basis(i, j);
        for (Lanes& row : generator)
            for (double& entry : row.at)
                entry *= flow.step;
        const Matrix8 step = columns_of(generator);
        for (int j = 0; j < lanes; ++j)
            transposed_.column[j] = generator[static_cast<std::size_t>(j)];
        for (int j = 0; j < lanes; ++j)
            flow.power[0].column[j].at[j] = 1.0;
        for (int k = 1; k < terms; ++k)
            for (int j = 0; j < lanes; ++j) {
                Lanes& column = flow.power[k].column[j];
                loops_.apply(&step, 1, flow.power[k - 1].column[j], &column);
                for (double& entry : column.at)
                    entry /= k;
            }
        for (int k = terms - 1; k >= 0; --k)  // small terms first
            for (int j = 0; j < lanes; ++j)
                for (int i = 0; i < lanes; ++i)
                    flow.advance.column[j].at[i] += flow.power[k].column[j].at[i];
    }

    Series series_of(const Lanes& row) const {
        Series series;
        series[0] = row;
        for (std::size_t k = 1; k < terms; ++k) {
            loops_.apply(&transposed_, 1, series[k - 1], &series[k]);
            for (double& entry : series[k].at)
                entry /= static_cast<double>(k);
        }
        return series;
    }

    void set_test(Flow& flow, const Lanes& row) {
        EventFunction& test = flow.test[flow.test_count++];
        const Series series = series_of(row);
        test.row = row;
        store(series, test.series);
        loops_.combine(monomials().bernstein.data(), series.data(), terms, test.bernstein);
    }

    // the last event function, where it may begin at a root: an impact, a lift-off, a slip that has just begun
    void set_divided(Flow& flow) {
        const Series series = series_of(flow.test[flow.test_count - 1].row);
        for (int m = 1; m <= most_multiplicity; ++m)
            loops_.combine(monomials().bernstein.data(), series.data() + m, terms - m, flow.divided[m - 1]);
    }

    void set_sampled(const Lanes& row, Matrix8& at_nodes, Matrix8 (&blocks)[term_blocks]) const {
        const Series series = series_of(row);
        store(series, blocks);
        loops_.combine(monomials().at_nodes.data(), series.data(), terms, at_nodes);
    }

    void set_velocities(Flow& flow, int count) {
        flow.velocity_count = count;
        for (int j = 0; j < count; ++j) {
            const int lane = j < closed ? velocity_lane(closed, j) : gap_lane(closed) + 1;
            set_sampled(unit(lane), flow.velocity[j], flow.velocity_series[j]);
        }
    }

    void set_open(Flow& flow) {
        Rows a{};
        for (int i = 0; i < dofs; ++i) {
            const int place = i < closed ? i : gap_lane(closed);
            const int speed = i < closed ? velocity_lane(closed, i) : gap_lane(closed) + 1;
            Lanes force = internal_force(i);
            force.at[gap_lane(closed)] = c_.stiffness(i, closed);
            force.at[gap_lane(closed) + 1] = c_.damping(i, closed);
            a[static_cast<std::size_t>(place)] = unit(speed);
            a[static_cast<std::size_t>(speed)] = scaled(force, -1.0 / c_.mass(i));
        }
        set_powers(flow, ContactMode::open, a, rate(dofs, 0.0));
        set_test(flow, unit(gap_lane(closed)));
        set_divided(flow);
        set_velocities(flow, dofs);
    }

    void set_stick(Flow& flow) {
        Rows a = closed_generator();
        a[static_cast<std::size_t>(velocity_lane(closed, 0))] = surface_acceleration();
        set_powers(flow, ContactMode::stick, a, std::max(rate(closed, 0.0), omega_));
        flow.friction_force = sum(internal_force(0), surface_acceleration(), c_.mass(0));
        flow.normal_force = sum(internal_force(closed), flow.friction_force, -c_.tangent_on_gap);
        set_test(flow, sum(scaled(flow.normal_force, stick_limit(friction_, model::Slip::backward)),
                           flow.friction_force, -1.0));
        set_test(flow, sum(scaled(flow.normal_force, stick_limit(friction_, model::Slip::forward)), flow.friction_force,
                           1.0));
        set_velocities(flow, closed);
        set_sampled(flow.friction_force, flow.force, flow.force_series);
        set_sampled(unit(surface_lane(closed)), flow.surface, flow.surface_series);
    }

    void set_slip(Flow& flow, model::Slip way) {
        const ContactMode mode = slip_mode(way);
        const double friction = slip_ratio(friction_, way);  // T/N
        const double sign = way == model::Slip::forward ? 1.0 : -1.0;
        flows_.slip_ratio[static_cast<int>(mode)] = friction;
        flow.normal_force = scaled(internal_force(closed), 1.0 / (1.0 + friction * c_.tangent_on_gap));
        flow.friction_force = scaled(flow.normal_force, friction);
        Rows a = closed_generator();
        a[static_cast<std::size_t>(velocity_lane(closed, 0))] =
            scaled(sum(internal_force(0), flow.friction_force, -1.0), -1.0 / c_.mass(0));
        const double in_x = -friction / (1.0 + friction * c_.tangent_on_gap);
        set_powers(flow, mode, a, std::max(rate(closed, in_x), omega_));
        set_test(flow, flow.normal_force);
        set_test(flow, scaled(sum(unit(velocity_lane(closed, 0)), unit(surface_lane(closed)), -1.0), sign));
        set_divided(flow);
        set_velocities(flow, closed);
        set_sampled(flow.normal_force, flow.force, flow.force_series);
        set_sampled(unit(surface_lane(closed)), flow.surface, flow.surface_series);
    }

    const ContactCoordinates<dofs>& c_;
    const model::FrictionLaw& friction_;
    const Kernel& loops_;
    double omega_;          // [rad/s]
    Matrix8 transposed_{};  // of A h
    Flows flows_{};
};

}  // namespace

template <int dofs>
Flows prepare_flows(const ContactCoordinates<dofs>& coordinates, const model::FrictionLaw& friction,
                    double drive_frequency, const Kernel& loops) {
    return Preparation<dofs>(coordinates, friction, drive_frequency, loops).run();
}

template Flows prepare_flows<2>(const ContactCoordinates<2>&, const model::FrictionLaw&, double, const Kernel&);
template Flows prepare_flows<3>(const ContactCoordinates<3>&, const model::FrictionLaw&, double, const Kernel&);

}  // namespace stridor::integration
