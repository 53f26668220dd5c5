// The loops of series_kernel.hpp, part of kernels/loops.inl. Each lane is computed by itself, so that all sets give the
// same bits.

#include "stridor/integration/kernels/lanes_vector.inl"

namespace stridor::integration::STRIDOR_ISA {

namespace {

constexpr Lanes no_numbers{};

STRIDOR_INLINE double sum_of(const Vector& v) {
    double first = 0.0, second = 0.0;
    sums_of_four(v, first, second);
    return first + second;
}

// without contact forces, one coefficient
STRIDOR_INLINE void accelerate_freely(const SeriesProblem& problem, std::size_t modes, const Lanes* q, const Lanes* v,
                                      Lanes* a, bool is_first) {
    for (std::size_t j = 0; j < modes; ++j) {
        Vector sum = load(no_numbers) - load(problem.square[j]) * load(q[j]);
        if (problem.damped_modes == 0) sum = sum - load(problem.damping[j]) * load(v[j]);
        for (std::size_t k = 0; k < problem.damped_modes; ++k)
            sum = sum - load(problem.damping[k * modes + j]) * number_in(v, k);
        if (is_first) sum = sum + load(problem.load[j]);
        save(sum, a[j]);
    }
}

// matrix, shape [column][row], times x; rows in registers
STRIDOR_INLINE void multiply(const Lanes* matrix, std::size_t columns, std::size_t rows, const Lanes* x,
                             Lanes* product) {
    for (std::size_t r = 0; r < rows; ++r) {
        Vector sum = load(no_numbers);
        for (std::size_t column = 0; column < columns; ++column)
            sum = sum + load(matrix[column * rows + r]) * number_in(x, column);
        save(sum, product[r]);
    }
}

// those that hold the constraints, of one coefficient: (R'B)^-1 (r - R'a)
STRIDOR_INLINE void find_forces(const SeriesProblem& problem, std::size_t modes, const Lanes* a, double surface_rate,
                                Lanes* right, Lanes* force) {
    for (std::size_t r = 0; r < problem.rows; ++r) {
        Vector sum = load(no_numbers);
        for (std::size_t j = 0; j < modes; ++j)
            sum = sum + load(problem.constraint[r * modes + j]) * load(a[j]);
        number_in(right, r) = problem.drive[r] * surface_rate - sum_of(sum);
    }
    multiply(problem.inverse, problem.rows, registers_for(problem.rows), right, force);
}

// the pushes of all rows on so many registers of modes at once
template <std::size_t count>
STRIDOR_INLINE void push(const SeriesProblem& problem, std::size_t modes, std::size_t first, const Lanes* force,
                         Lanes* a) {
    Vector sum[count];
    for (std::size_t j = 0; j < count; ++j)
        sum[j] = load(a[first + j]);
    for (std::size_t r = 0; r < problem.rows; ++r)
        for (std::size_t j = 0; j < count; ++j)
            sum[j] = sum[j] + load(problem.push[r * modes + first + j]) * number_in(force, r);
    for (std::size_t j = 0; j < count; ++j)
        save(sum[j], a[first + j]);
}

// the pushes of all rows on all modes
STRIDOR_INLINE void push_modes(const SeriesProblem& problem, std::size_t modes, const Lanes* force, Lanes* a) {
    constexpr std::size_t at_once = 4;
    std::size_t first = 0;
    for (; first + at_once <= modes; first += at_once)
        push<at_once>(problem, modes, first, force, a);
    for (; first < modes; ++first)
        push<1>(problem, modes, first, force, a);
}

// What rounding leaves of the constraints in the first coefficient, where load and stretched springs cancel with
// forces. It would move closed contacts the same way in each block.
STRIDOR_INLINE void hold_constraints(const SeriesProblem& problem, std::size_t modes, double surface_rate, Lanes* right,
                                     Lanes* force, Lanes* a) {
    const std::size_t registers = registers_for(problem.rows);
    Lanes* more = right + registers;
    find_forces(problem, modes, a, surface_rate, right, more);
    for (std::size_t r = 0; r < registers; ++r)
        save(load(force[r]) + load(more[r]), force[r]);
    push_modes(problem, modes, more, a);
}

// `modes` in registers; `a` holds so many
STRIDOR_INLINE void expand_modes(const SeriesProblem& problem, int order, const SeriesRoom& room, std::size_t modes,
                                 Lanes* a) {
    const std::size_t registers = registers_for(problem.rows);
    for (std::size_t m = 0; m <= static_cast<std::size_t>(order); ++m) {
        const double per_step = static_cast<double>(m + 1) / problem.step;
        const Lanes* v = room.v + m * modes;
        accelerate_freely(problem, modes, room.q + m * modes, v, a, m == 0);
        if (problem.rub != nullptr) problem.rub(problem.friction, m, a);
        if (problem.rows > 0) {
            Lanes* force = room.force + m * registers;
            const double surface_rate = per_step * problem.surface[m + 1];
            find_forces(problem, modes, a, surface_rate, room.right, force);
            push_modes(problem, modes, force, a);
            if (m == 0) hold_constraints(problem, modes, surface_rate, room.right, force, a);
        }
        const double scale = 1.0 / per_step;
        for (std::size_t j = 0; j < modes; ++j) {
            save(load(v[j]) * scale, room.q[(m + 1) * modes + j]);
            save(load(a[j]) * scale, room.v[(m + 1) * modes + j]);
        }
    }
}

// Forces eliminated: a coefficient waits for one sum of columns, not for forces and their pushes in turn.
STRIDOR_INLINE void expand_eliminated(const SeriesProblem& problem, int order, const SeriesRoom& room) {
    const std::size_t n = problem.numbers;
    const Lanes* drive = problem.eliminated + 4 * n;
    const Lanes* pressed = drive + 2;
    for (std::size_t m = 0; m <= static_cast<std::size_t>(order); ++m) {
        const double per_step = static_cast<double>(m + 1) / problem.step;
        const double rate = per_step * problem.surface[m + 1];
        // what is known early, and what the last coefficient gives
        Vector a = load(drive[0]) * rate, force = load(drive[1]) * rate;
        if (m == 0) {
            a = a + load(pressed[0]);
            force = force + load(pressed[1]);
        }
        Vector a_last = load(no_numbers), force_last = load(no_numbers);
        for (std::size_t k = 0; k < n; ++k) {
            const Lanes* of_q = problem.eliminated + 2 * k;
            const Lanes* of_v = of_q + 2 * n;
            const double q = room.q[m].at[k], v = room.v[m].at[k];
            a = a + load(of_q[0]) * q;
            force = force + load(of_q[1]) * q;
            a_last = a_last + load(of_v[0]) * v;
            force_last = force_last + load(of_v[1]) * v;
        }
        const double scale = 1.0 / per_step;
        save(load(room.v[m]) * scale, room.q[m + 1]);
        save(force + force_last, room.force[m]);
        Lanes sum;  // stays in a register
        save(a + a_last, sum);
        if (m == 0) hold_constraints(problem, 1, rate, room.right, room.force, &sum);
        save(load(sum) * scale, room.v[m + 1]);
    }
}

void expand(const SeriesProblem& problem, int order, const SeriesRoom& room) {
    if (problem.eliminated != nullptr) return expand_eliminated(problem, order, room);
    if (problem.modes > 1) return expand_modes(problem, order, room, problem.modes, room.acceleration);
    Lanes one;  // stays in a register
    expand_modes(problem, order, room, 1, &one);
}

void evaluate(const Lanes* coefficients, std::size_t count, std::size_t modes, const BlockPlaces& places,
              Lanes* values) {
    for (std::size_t j = 0; j < modes; ++j) {
        Vector value[block_places];
        for (Vector& each : value)
            each = load(no_numbers);
        for (std::size_t m = count; m-- > 0;) {
            const Vector c = load(coefficients[m * modes + j]);
            for (std::size_t place = 0; place < block_places; ++place)
                value[place] = value[place] * places[place] + c;
        }
        for (std::size_t place = 0; place < block_places; ++place)
            save(value[place], values[place * modes + j]);
    }
}

void evaluate_state(const Lanes* q, const Lanes* v, std::size_t count, std::size_t modes, double place, Lanes* q_there,
                    Lanes* v_there) {
    for (std::size_t j = 0; j < modes; ++j) {
        Vector value = load(no_numbers), rate = load(no_numbers);
        for (std::size_t m = count; m-- > 0;) {
            value = value * place + load(q[m * modes + j]);
            rate = rate * place + load(v[m * modes + j]);
        }
        save(value, q_there[j]);
        save(rate, v_there[j]);
    }
}

}  // namespace

}  // namespace stridor::integration::STRIDOR_ISA
