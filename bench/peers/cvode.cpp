// CVODE finds roots of the event functions by itself, from sign changes between the ends of its steps, and starts
// anew after each. Nothing here is stiff: Adams formulas, their implicit equation solved by fixed-point
// iteration. A function that is zero at the start (the gap after lift-off, w after a stick) is left out by CVODE
// until it has moved away.

#include "peers/cvode.hpp"

#include "peers/rubbing.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace stridor::peers {

namespace {

constexpr double absolute_displacement = 1e-13;  // [m]
constexpr double absolute_velocity = 1e-9;       // [m/s] the displacement's times 1e4 rad/s

void require(int flag, const char* what) {
    if (flag < 0) throw std::runtime_error(std::string(what) + " failed with " + std::to_string(flag));
}

struct Problem {
    Rubbing r;
    Mode mode;
};

int right_hand_side(realtype, N_Vector y, N_Vector ydot, void* user_data) {
    const Problem& problem = *static_cast<const Problem*>(user_data);
    derivative(problem.r, problem.mode, N_VGetArrayPointer(y), N_VGetArrayPointer(ydot));
    return 0;
}

int event_functions(realtype, N_Vector y, realtype* values, void* user_data) {
    const Problem& problem = *static_cast<const Problem*>(user_data);
    const Margins now = margins(problem.r, problem.mode, N_VGetArrayPointer(y));
    values[0] = now[0];
    values[1] = now[1];
    return 0;
}

// CVODE's objects, created together and freed together
class Solver {
public:
    Solver(Problem& problem, const Motion& start, double relative) {
        require(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
        y_ = N_VNew_Serial(static_cast<sunindextype>(start.size()), context_);
        tolerance_ = N_VClone(y_);
        std::copy(start.begin(), start.end(), N_VGetArrayPointer(y_));
        for (std::size_t k = 0; k < start.size(); ++k)
            N_VGetArrayPointer(tolerance_)[k] = k < 3 ? absolute_displacement : absolute_velocity;
        memory_ = CVodeCreate(CV_ADAMS, context_);
        iteration_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
        require(CVodeInit(memory_, right_hand_side, 0.0, y_), "CVodeInit");
        require(CVodeSVtolerances(memory_, relative, tolerance_), "CVodeSVtolerances");
        require(CVodeSetNonlinearSolver(memory_, iteration_), "CVodeSetNonlinearSolver");
        require(CVodeSetUserData(memory_, &problem), "CVodeSetUserData");
        require(CVodeSetMaxNumSteps(memory_, -1), "CVodeSetMaxNumSteps");
        require(CVodeRootInit(memory_, 2, event_functions), "CVodeRootInit");
        std::array<int, 2> falling{-1, -1};
        require(CVodeSetRootDirection(memory_, falling.data()), "CVodeSetRootDirection");
        require(CVodeSetNoInactiveRootWarn(memory_), "CVodeSetNoInactiveRootWarn");
    }
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;
    ~Solver() {
        CVodeFree(&memory_);
        SUNNonlinSolFree(iteration_);
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
        std::array<int, 2> found{};
        require(CVodeGetRootInfo(memory_, found.data()), "CVodeGetRootInfo");
        return found[0] != 0 ? 0 : 1;
    }

    Motion motion() const {
        Motion s;
        std::copy_n(N_VGetArrayPointer(y_), s.size(), s.begin());
        return s;
    }

    void restart(double time, const Motion& s) {
        std::copy(s.begin(), s.end(), N_VGetArrayPointer(y_));
        require(CVodeReInit(memory_, time, y_), "CVodeReInit");
    }

private:
    SUNContext context_ = nullptr;
    void* memory_ = nullptr;
    N_Vector y_ = nullptr, tolerance_ = nullptr;
    SUNNonlinearSolver iteration_ = nullptr;
};

}  // namespace

record::ContactHistory by_cvode(const parameters::Case& c, double relative) {
    Problem problem{rubbing(c), {}};
    Motion s = first_motion(problem.r, c);
    problem.mode = closed(problem.r, s);
    record::ContactHistory history;
    note(history, problem.mode.state, 0.0);
    Solver solver(problem, s, relative);
    ChatterGuard guard;
    double time = 0.0;
    while (solver.advance(c.run.duration, time)) {
        s = solver.motion();
        problem.mode = change(problem.r, problem.mode, solver.event(), s);
        note(history, problem.mode.state, time);
        guard.count(time);
        solver.restart(time, s);
    }
    history.back().to = c.run.duration;
    return history;
}

std::string cvode_version() {
    return "SUNDIALS CVODE " SUNDIALS_VERSION;
}

}  // namespace stridor::peers
