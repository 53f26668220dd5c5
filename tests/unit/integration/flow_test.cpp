#include "stridor/integration/exact/flow.hpp"

#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor::integration {
namespace {

using Matrix = Eigen::Matrix<double, lanes, lanes>;
using State = Eigen::Matrix<double, lanes, 1>;

Matrix matrix_of(const Matrix8& m) {
    Matrix result;
    for (int i = 0; i < lanes; ++i)
        for (int j = 0; j < lanes; ++j)
            result(i, j) = m.column[j].at[i];
    return result;
}

// by scaling and squaring: Taylor's series of a 16th of the time, four times squared
Matrix exponential(const Matrix& a) {
    Matrix sum = Matrix::Identity(), term = Matrix::Identity();
    for (int k = 1; k < 20; ++k) {
        term = term * a / (16.0 * k);
        sum += term;
    }
    for (int k = 0; k < 4; ++k)
        sum = sum * sum;
    return sum;
}

const Flow& in(const Flows& flows, ContactMode mode) {
    return flows.flow[static_cast<int>(mode)];
}

Flows table_1_flows(double drive_frequency) {
    const model::Structure structure = model::rubbing_system(parameters::paper_case(parameters::PaperCase::squeal));
    return prepare_flows(contact_coordinates(model::SizedStructure<3>(structure, structure.contacts[0])),
                         structure.contacts[0].friction, drive_frequency, kernel(InstructionSet::baseline, 3));
}

constexpr ContactMode all_modes[]{ContactMode::open, ContactMode::stick, ContactMode::slip_forward,
                                  ContactMode::slip_backward};

// m x'' + c x' + k x = mu_d F around x = mu_d F/k, slipping backward: a damped vibration
TEST(ExactFlow, AdvancesTheDampedOscillatorByItsClosedForm) {
    const double m = 0.3, k = 2e5, c = 17.0, F = 90.0, mu = 0.4;
    const model::Structure belt = model::mass_on_belt({m, k, c, F, {0.5, mu}});
    const Flows flows = prepare_flows(contact_coordinates(model::SizedStructure<2>(belt, belt.contacts[0])),
                                      belt.contacts[0].friction, 0.0, kernel(InstructionSet::baseline, 3));
    const Flow& flow = in(flows, ContactMode::slip_backward);
    const double decay = c / (2.0 * m), rate = std::sqrt(k / m - decay * decay);
    const double x0 = 1e-3, v0 = -0.2, rest = mu * F / k;
    const double b = (v0 + decay * (x0 - rest)) / rate;
    State s;
    s << x0, v0, F, 0.1, 0.0, 0.0, 0.0, 0.0;
    const Matrix advance = matrix_of(flow.advance);
    for (int step = 1; step <= 50; ++step) {
        s = advance * s;
        const double t = step * flow.step;
        const double x = rest + std::exp(-decay * t) * ((x0 - rest) * std::cos(rate * t) + b * std::sin(rate * t));
        ASSERT_NEAR(s(0), x, 1e-15 * step * (x0 + std::abs(v0) / rate)) << step;  // rounding of each step
    }
    EXPECT_NEAR(s(3), 0.1, 1e-16);
}

TEST(ExactFlow, AdvancesByTheMatrixExponential) {
    for (const double frequency : {0.0, 5.0, 5000.0}) {
        const Flows flows = table_1_flows(frequency);
        for (const ContactMode mode : all_modes) {
            const Flow& flow = in(flows, mode);
            // units in which all numbers of the state count alike: lengths 1, velocities 1/h, forces m/h^2
            State unit = State::Constant(1.0 / flow.step);
            unit(0) = unit(1) = 1.0;
            if (mode == ContactMode::open) unit(5) = 1.0;
            unit(4) = 0.1 / (flow.step * flow.step);
            const Matrix to_units = unit.cwiseInverse().asDiagonal(), from_units = unit.asDiagonal();
            const Matrix known = exponential(to_units * matrix_of(flow.power[1]) * from_units);
            const Matrix found = to_units * matrix_of(flow.advance) * from_units;
            // squaring doubles the rounding of the 16th four times
            EXPECT_LT((found - known).cwiseAbs().maxCoeff(), 32.0 * 2.2e-16 * known.norm());
        }
    }
}

// the step is a fraction of the shortest period: no rate of the flow turns by more than two radians in it
TEST(ExactFlow, StepsNoFurtherThanItsFastestRate) {
    const Flows flows = table_1_flows(5.0);
    for (const ContactMode mode : all_modes) {
        Matrix power = matrix_of(in(flows, mode).power[1]);
        for (int k = 0; k < 8; ++k)
            power = power * power;
        // |A^256|^(1/256) is the largest rate, but for the 256th root of the units' sizes (1e10)
        const double rate = std::pow(power.norm(), 1.0 / 256.0);
        EXPECT_LE(rate, 2.2);
        EXPECT_GE(rate, 0.2);
    }
}

// the smallest and largest Bernstein coefficients bound each event function over the step, to a tenth of what a glide
// allows: the form misses 2e-7 of the vibration, of which the event function may show a small part
RC_GTEST_PROP(ExactFlow, BoundsItsEventFunctions, ()) {
    static const Flows flows = table_1_flows(*support::whole_between(0, 1) == 0 ? 0.0 : 5.0);
    const Flow& flow = in(flows, all_modes[*support::whole_between(0, 3)]);
    State s;
    s << 1e-4, 1e-4, 0.1, 0.1, 20.0, 0.1, 0.1, 0.0;  // usual sizes; open: gap 0.1 m, which only scales
    for (double& number : s)
        number *= *support::signed_fraction();
    for (int test = 0; test < flow.test_count; ++test) {
        const State b = matrix_of(flow.test[test].bernstein) * s;
        double begin = 0.0, size = 0.0;
        for (int i = 0; i < lanes; ++i) {
            begin += flow.test[test].row.at[i] * s(i);
            size += std::abs(flow.test[test].row.at[i] * s(i));
        }
        const double rounding = 1e-13 * (size + b.cwiseAbs().maxCoeff());
        const double slack = 1e-5 * b.cwiseAbs().maxCoeff() + rounding;
        for (int k = 0; k <= 20; ++k) {
            const double tau = k / 20.0;
            double sum = 0.0, power = 1.0;
            for (int term = 0; term < terms; ++term, power *= tau)
                sum += (matrix_of(flow.test[test].series[term / lanes]) * s)(term % lanes) * power;
            RC_ASSERT(sum >= b.minCoeff() - slack);
            RC_ASSERT(sum <= b.maxCoeff() + slack);
            if (k == 0) RC_ASSERT(std::abs(begin - sum) <= rounding);
        }
    }
}

}  // namespace
}  // namespace stridor::integration
