// odeint integrates smooth equations; events are the user's. After each step the event functions are looked at in its
// middle and at its end, through the dense output; the first that is negative is located by bisection, and the stepper
// starts anew there with the step size it had.

#include "peers/odeint.hpp"

#include "peers/bristles.hpp"
#include "peers/rubbing.hpp"

#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>

#include <algorithm>
#include <array>

namespace stridor::peers {

namespace {

namespace odeint = boost::numeric::odeint;

constexpr double absolute =
    1e-13;  // [m] of displacements of 1e-5 m what 1e-8 is of them; velocities are 1e4 times as large
constexpr double first_step = 1e-6;       // [s] odeint takes it from there
constexpr double event_accuracy = 1e-15;  // [s]

struct Event {
    double time;        // [s]
    std::size_t which;  // number of the event function
};

template <typename System, typename Phase, typename Stepper>
class Search {
public:
    Search(const System& r, const Phase& mode, const Stepper& stepper) : r_(r), mode_(mode), stepper_(stepper) {}

    // the first event after `from`; its time is beyond `to` if there is none
    Event first(double from, double to) const {
        const double middle = 0.5 * (from + to);
        const Event early = first_between(from, middle);
        return early.time <= middle ? early : first_between(middle, to);
    }

private:
    auto at(double time) const {
        typename Stepper::state_type s;
        stepper_.calc_state(time, s);
        return margins(r_, mode_, s.data());
    }

    Event first_between(double from, double to) const {
        const auto end = at(to);
        Event event{2.0 * to, 0};
        for (std::size_t which = 0; which < end.size(); ++which) {
            if (end[which] >= 0.0) continue;
            double low = from, high = to;
            while (high - low > event_accuracy) {
                const double middle = 0.5 * (low + high);
                if (middle <= low || middle >= high) break;
                (at(middle)[which] >= 0.0 ? low : high) = middle;
            }
            if (high < event.time) event = {high, which};
        }
        return event;
    }

    const System& r_;
    const Phase& mode_;
    const Stepper& stepper_;
};

template <typename System>
record::ContactHistory solved(const System& r, const parameters::Case& c, double relative) {
    auto s = first_motion(r, c);
    using State = decltype(s);
    auto mode = closed(r, s);
    record::ContactHistory history;
    note(history, told(r, mode), 0.0);

    auto stepper = odeint::make_dense_output(absolute, relative, odeint::runge_kutta_dopri5<State>());
    const Search search(r, mode, stepper);
    const auto system = [&](const State& x, State& dxdt, double) { derivative(r, mode, x.data(), dxdt.data()); };
    stepper.initialize(s, 0.0, first_step);
    ChatterGuard guard;
    while (true) {
        const auto [from, to] = stepper.do_step(system);
        const double end = std::min(to, c.run.duration);
        const Event event = search.first(from, end);
        if (event.time <= end) {
            stepper.calc_state(event.time, s);
            mode = change(r, mode, event.which, s);
            note(history, told(r, mode), event.time);
            guard.count(event.time);
            stepper.initialize(s, event.time, stepper.current_time_step());
        } else if (to >= c.run.duration) {
            break;
        }
    }
    history.back().to = c.run.duration;
    return history;
}

}  // namespace

record::ContactHistory by_odeint(const parameters::Case& c, double relative) {
    if (c.contact().friction == parameters::FrictionKind::lugre) return solved(bristled(c), c, relative);
    return solved(rubbing(c), c, relative);
}

std::string odeint_version() {
    return "Boost.odeint " BOOST_LIB_VERSION;
}

}  // namespace stridor::peers
