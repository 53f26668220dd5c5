#include "stridor/integration/kernels/series_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace stridor::integration {
namespace {

constexpr std::size_t order = 10;

std::vector<Lanes> table(std::size_t rows, std::size_t columns, double seed) {
    std::vector<Lanes> numbers(rows * registers_for(columns));
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c)
            number_in(&numbers[r * registers_for(columns)], c) =
                std::sin(seed + static_cast<double>(r) * 1.7 + static_cast<double>(c) * 0.61);
    return numbers;
}

enum class Damping { by_mode, whole };
enum class Forces { plain, eliminated };

// a problem of numbers without meaning, and its series
struct Expansion {
    Expansion(std::size_t mode_count, std::size_t row_count, Damping damping_kind, Forces forces)
        : modes(mode_count),
          rows(row_count),
          is_whole(damping_kind == Damping::whole),
          square(table(1, modes, 1.0)),
          damping(table(is_whole ? modes : 1, modes, 2.0)),
          load(table(1, modes, 3.0)),
          constraint(table(rows, modes, 4.0)),
          push(table(rows, modes, 5.0)),
          inverse(table(rows, rows, 6.0)),
          q(table(order + 2, modes, 8.0)),
          v(table(order + 2, modes, 9.0)),
          force((order + 1) * registers_for(rows)),
          acceleration(registers_for(modes)),
          right(2 * registers_for(rows)) {
        for (std::size_t r = 0; r < rows; ++r)
            drive.push_back(0.1 * static_cast<double>(r));
        for (std::size_t m = 0; m <= order + 1; ++m)
            surface.push_back(std::cos(static_cast<double>(m)));
        if (forces == Forces::eliminated) eliminate();
    }

    void expand(InstructionSet set) {
        series_kernel(set).expand({registers_for(modes), rows, square.data(), damping.data(), is_whole ? modes : 0,
                                   load.data(), constraint.data(), push.data(), inverse.data(), drive.data(),
                                   surface.data(), 0.5, eliminated.empty() ? nullptr : eliminated.data(), modes},
                                  static_cast<int>(order),
                                  {q.data(), v.data(), force.data(), acceleration.data(), right.data()});
    }

    // what each number of q, of v, the surface and the load give, one after the other
    void eliminate() {
        for (std::size_t column = 0; column < 2 * modes + 2; ++column) {
            const bool is_surface = column == 2 * modes, is_load = column > 2 * modes;
            const std::size_t k = column % modes;
            Lanes acceleration_of{}, force_of{};
            for (std::size_t j = 0; j < modes; ++j)
                acceleration_of.at[j] = is_surface             ? 0.0
                                        : is_load              ? at(load, 0, modes, j)
                                        : column < modes       ? (j == k ? -at(square, 0, modes, j) : 0.0)
                                        : is_whole || (j == k) ? -at(damping, is_whole ? k : 0, modes, j)
                                                               : 0.0;
            for (std::size_t c = 0; c < rows; ++c) {
                double right_of = is_surface ? drive[c] : 0.0;
                for (std::size_t j = 0; j < modes; ++j)
                    right_of -= at(constraint, c, modes, j) * acceleration_of.at[j];
                for (std::size_t r = 0; r < rows; ++r)
                    force_of.at[r] += at(inverse, c, rows, r) * right_of;
            }
            for (std::size_t r = 0; r < rows; ++r)
                for (std::size_t j = 0; j < modes; ++j)
                    acceleration_of.at[j] += at(push, r, modes, j) * force_of.at[r];
            eliminated.push_back(acceleration_of);
            eliminated.push_back(force_of);
        }
    }

    double at(const std::vector<Lanes>& numbers, std::size_t row, std::size_t columns, std::size_t column) const {
        return number_in(&numbers[row * registers_for(columns)], column);
    }

    std::size_t modes, rows;
    bool is_whole;
    std::vector<Lanes> square, damping, load, constraint, push, inverse, q, v, force, acceleration, right, eliminated;
    std::vector<double> drive, surface;
};

// number by number, from the equations
void expect_recurrence(const Expansion& e) {
    for (std::size_t m = 0; m <= order; ++m) {
        const double per_step = static_cast<double>(m + 1) / 0.5;
        std::vector<double> a(e.modes), right(e.rows), force(e.rows);
        for (std::size_t j = 0; j < e.modes; ++j) {
            a[j] =
                (m == 0 ? e.at(e.load, 0, e.modes, j) : 0.0) - e.at(e.square, 0, e.modes, j) * e.at(e.q, m, e.modes, j);
            for (std::size_t k = 0; k < e.modes; ++k)
                if (e.is_whole || k == j)
                    a[j] -= e.at(e.damping, e.is_whole ? k : 0, e.modes, j) * e.at(e.v, m, e.modes, k);
        }
        // the constraints of the first coefficient are held twice
        for (int pass = 0; pass < (m == 0 ? 2 : 1); ++pass) {
            for (std::size_t r = 0; r < e.rows; ++r) {
                right[r] = e.drive[r] * per_step * e.surface[m + 1];
                for (std::size_t j = 0; j < e.modes; ++j)
                    right[r] -= e.at(e.constraint, r, e.modes, j) * a[j];
            }
            for (std::size_t r = 0; r < e.rows; ++r) {
                double more = 0.0;
                for (std::size_t c = 0; c < e.rows; ++c)
                    more += e.at(e.inverse, c, e.rows, r) * right[c];
                force[r] += more;
                for (std::size_t j = 0; j < e.modes; ++j)
                    a[j] += e.at(e.push, r, e.modes, j) * more;
            }
        }
        for (std::size_t r = 0; r < e.rows; ++r)
            EXPECT_NEAR(e.at(e.force, m, e.rows, r), force[r], 1e-9 * (1.0 + std::abs(force[r])));
        for (std::size_t j = 0; j < e.modes; ++j) {
            EXPECT_EQ(e.at(e.q, m + 1, e.modes, j), 1.0 / per_step * e.at(e.v, m, e.modes, j));
            const double next = e.at(e.v, m + 1, e.modes, j);
            EXPECT_NEAR(next, a[j] / per_step, 1e-9 * (1.0 + std::abs(next)));
        }
    }
}

TEST(SeriesKernel, FollowsTheRecurrenceOfTheEquations) {
    for (const std::size_t modes : {1U, 5U, 8U, 13U, 40U})
        for (const std::size_t rows : {0U, 1U, 4U, 11U}) {
            Expansion plain(modes, rows, Damping::by_mode, Forces::plain);
            plain.expand(InstructionSet::baseline);
            expect_recurrence(plain);
            Expansion whole(modes, rows, Damping::whole, Forces::plain);
            whole.expand(InstructionSet::baseline);
            expect_recurrence(whole);
        }
}

TEST(SeriesKernel, EliminatesForcesOfSmallStructures) {
    for (const std::size_t modes : {1U, 5U, 8U})
        for (const std::size_t rows : {1U, 4U, 8U})
            for (const Damping damping : {Damping::by_mode, Damping::whole}) {
                Expansion e(modes, rows, damping, Forces::eliminated);
                e.expand(InstructionSet::baseline);
                expect_recurrence(e);
            }
}

void expect_same_bits(std::size_t modes, std::size_t rows, Damping damping, Forces forces) {
    Expansion wanted(modes, rows, damping, forces);
    wanted.expand(InstructionSet::baseline);
    for (const InstructionSet set : available_instruction_sets()) {
        Expansion got(modes, rows, damping, forces);
        got.expand(set);
        for (std::size_t k = 0; k < got.v.size() * lanes; ++k) {
            EXPECT_EQ(number_in(got.q.data(), k), number_in(wanted.q.data(), k));
            EXPECT_EQ(number_in(got.v.data(), k), number_in(wanted.v.data(), k));
        }
        for (std::size_t k = 0; k < got.force.size() * lanes; ++k)
            EXPECT_EQ(number_in(got.force.data(), k), number_in(wanted.force.data(), k));
    }
}

TEST(SeriesKernel, HasTheSameBitsForEveryInstructionSet) {
    for (const Damping damping : {Damping::by_mode, Damping::whole}) {
        for (const std::size_t modes : {3U, 16U, 43U})
            expect_same_bits(modes, 9, damping, Forces::plain);
        expect_same_bits(7, 5, damping, Forces::eliminated);
    }
}

TEST(SeriesKernel, EvaluatesPolynomialsByHornersRuleInEverySet) {
    constexpr std::size_t count = 12, modes = 19;
    const std::vector<Lanes> c = table(count, modes, 1.0), d = table(count, modes, 2.0);
    const std::size_t registers = registers_for(modes);
    const BlockPlaces places{0.0, 0.1, 0.25, 0.3, 0.5, 0.75, 0.9, 1.0};
    for (const InstructionSet set : available_instruction_sets()) {
        std::vector<Lanes> values(block_places * registers), one(registers), other(registers);
        series_kernel(set).evaluate(c.data(), count, registers, places, values.data());
        series_kernel(set).evaluate_state(c.data(), d.data(), count, registers, 0.3, one.data(), other.data());
        for (std::size_t j = 0; j < modes; ++j) {
            const auto horner = [&](const std::vector<Lanes>& from, double x) {
                double value = 0.0;
                for (std::size_t m = count; m-- > 0;)
                    value = value * x + number_in(&from[m * registers], j);
                return value;
            };
            for (std::size_t i = 0; i < block_places; ++i)
                EXPECT_EQ(number_in(&values[i * registers], j), horner(c, places[i]));
            EXPECT_EQ(number_in(one.data(), j), horner(c, 0.3));
            EXPECT_EQ(number_in(other.data(), j), horner(d, 0.3));
        }
    }
}

}  // namespace
}  // namespace stridor::integration
