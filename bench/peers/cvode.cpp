// CVODE finds roots of the event functions by itself, from sign changes between the ends of its steps, and starts
// anew after each. Adams formulas have their implicit equation solved by fixed-point iteration; backward differences,
// for bristles that are stiff, by Newton's with a matrix of differences. A function that is zero at the start (the gap
// after lift-off, w after a stick) is left out by CVODE until it has moved away.

#include "peers/cvode.hpp"

#include "peers/bristles.hpp"
#include "peers/rubbing.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <tuple>

namespace stridor::peers {

namespace {

constexpr double absolute_displacement = 1e-13;  // [m]
constexpr double absolute_velocity = 1e-9;       // [m/s] the displacement's times 1e4 rad/s
constexpr double absolute_state = 1e-9;          // [1] of friction: a velocity's share of it

void require(int flag, const char* what) {
    if (flag < 0) throw std::runtime_error(std::string(what) + " failed with " + std::to_string(flag));
}

template <typename System, typename Phase>
struct Problem {
    System r;
    Phase mode;
};

template <typename Posed>
int right_hand_side(realtype, N_Vector y, N_Vector ydot, void* user_data) {
    const Posed& problem = *static_cast<const Posed*>(user_data);
    derivative(problem.r, problem.mode, N_VGetArrayPointer(y), N_VGetArrayPointer(ydot));
    return 0;
}

template <typename Posed>
int event_functions(realtype, N_Vector y, realtype* values, void* user_data) {
    const Posed& problem = *static_cast<const Posed*>(user_data);
    const auto now = margins(problem.r, problem.mode, N_VGetArrayPointer(y));
    std::copy(now.begin(), now.end(), values);
    return 0;
}

// CVODE's objects, created together and freed together
template <typename Posed, typename State, std::size_t events>
class Solver {
public:
    Solver(Posed& problem, const State& start, double relative, Formulas formulas) {
        require(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
        y_ = N_VNew_Serial(static_cast<sunindextype>(start.size()), context_);
        tolerance_ = N_VClone(y_);
        std::copy(start.begin(), start.end(), N_VGetArrayPointer(y_));
        for (std::size_t k = 0; k < start.size(); ++k)
            N_VGetArrayPointer(tolerance_)[k] = k < 3   ? absolute_displacement
                                                : k < 6 ? absolute_velocity
                                                        : absolute_state;
        memory_ = CVodeCreate(formulas == Formulas::adams ? CV_ADAMS : CV_BDF, context_);
        require(CVodeInit(memory_, right_hand_side<Posed>, 0.0, y_), "CVodeInit");
        require(CVodeSVtolerances(memory_, relative, tolerance_), "CVodeSVtolerances");
        if (formulas == Formulas::adams) {
            iteration_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
            require(CVodeSetNonlinearSolver(memory_, iteration_), "CVodeSetNonlinearSolver");
        } else {
            const auto size = static_cast<sunindextype>(start.size());
            matrix_ = SUNDenseMatrix(size, size, context_);
            linear_ = SUNLinSol_Dense(y_, matrix_, context_);
            require(CVodeSetLinearSolver(memory_, linear_, matrix_), "CVodeSetLinearSolver");
        }
        require(CVodeSetUserData(memory_, &problem), "CVodeSetUserData");
        require(CVodeSetMaxNumSteps(memory_, -1), "CVodeSetMaxNumSteps");
        require(CVodeRootInit(memory_, static_cast<int>(events), event_functions<Posed>), "CVodeRootInit");
        std::array<int, events> falling{};
        falling.fill(-1);
        require(CVodeSetRootDirection(memory_, falling.data()), "CVodeSetRootDirection");
        require(CVodeSetNoInactiveRootWarn(memory_), "CVodeSetNoInactiveRootWarn");
    }
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;
    ~Solver() {
        CVodeFree(&memory_);
        if (iteration_ != nullptr) SUNNonlinSolFree(iteration_);
        if (linear_ != nullptr) SUNLinSolFree(linear_);
        if (matrix_ != nullptr) SUNMatDestroy(matrix_);
        N_VDestroy(tolerance_);
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }

    // to the next event or to the end; true at an event
    bool advance(double end, double& time) {
        require(CVodeSetStopTime(memory_, end), "CVodeSetStopTime");
        const int flag = CVode(memory_, end, y_, &time, CV_NORMAL);
        require(flag, "CVode");
        return flag == CV_ROOT_RETURN;
    }

    std::size_t event() {
        std::array<int, events> found{};
        require(CVodeGetRootInfo(memory_, found.data()), "CVodeGetRootInfo");
        const auto first = std::find_if(found.begin(), found.end(), [](int root) { return root != 0; });
        return static_cast<std::size_t>(first - found.begin());
    }

    State motion() const {
        State s;
        std::copy_n(N_VGetArrayPointer(y_), s.size(), s.begin());
        return s;
    }

    void restart(double time, const State& s) {
        std::copy(s.begin(), s.end(), N_VGetArrayPointer(y_));
        require(CVodeReInit(memory_, time, y_), "CVodeReInit");
    }

private:
    SUNContext context_ = nullptr;
    void* memory_ = nullptr;
    N_Vector y_ = nullptr, tolerance_ = nullptr;
    SUNNonlinearSolver iteration_ = nullptr;
    SUNMatrix matrix_ = nullptr;
    SUNLinearSolver linear_ = nullptr;
};

template <typename System>
record::ContactHistory solved(const System& system, const parameters::Case& c, double relative, Formulas formulas) {
    auto s = first_motion(system, c);
    using Posed = Problem<System, decltype(closed(system, s))>;
    Posed problem{system, closed(system, s)};
    record::ContactHistory history;
    note(history, told(system, problem.mode), 0.0);
    constexpr std::size_t events = std::tuple_size_v<decltype(margins(system, problem.mode, s.data()))>;
    Solver<Posed, decltype(s), events> solver(problem, s, relative, formulas);
    ChatterGuard guard;
    double time = 0.0;
    while (solver.advance(c.run.duration, time)) {
        s = solver.motion();
        problem.mode = change(problem.r, problem.mode, solver.event(), s);
        note(history, told(system, problem.mode), time);
        guard.count(time);
        solver.restart(time, s);
    }
    history.back().to = c.run.duration;
    return history;
}

}  // namespace

record::ContactHistory by_cvode(const parameters::Case& c, double relative, Formulas formulas) {
    if (c.contact().friction == parameters::FrictionKind::lugre) return solved(bristled(c), c, relative, formulas);
    return solved(rubbing(c), c, relative, formulas);
}

std::string cvode_version() {
    return "SUNDIALS CVODE " SUNDIALS_VERSION;
}

}  // namespace stridor::peers
