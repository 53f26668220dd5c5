// Tolerances are shares of the sum of the magnitudes that a balance is made of: rounding of a state of eight
// numbers (1e-13), and for inequalities that an event ends, the depth to which the search for events looks, 1e-9
// of a step's amplitude.

#include "support/oracles/motion_laws.hpp"

#include "stridor/model/laws/friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <sstream>

namespace stridor::support {

namespace {

using model::ContactState;
using parameters::Case;

constexpr double rounding = 1e-10;         // [1] of a balance's terms
constexpr double event_depth = 1e-8;       // [1] of a balance's terms
constexpr double energy_share = 1e-9;      // [1] of all that is turned over
constexpr double energy_rounding = 1e-12;  // [1] of the largest energy

// a sum and the size of its terms
struct Sum {
    double value = 0.0;
    double size = 0.0;

    void add(double term) {
        value += term;
        size += std::abs(term);
    }
};

class Laws {
public:
    Laws(const Case& c, const integration::Motion& motion) : c_(c), motion_(motion), trace_(motion.record.trace) {
        const double angle = c.joint().incidence_angle * std::numbers::pi / 180.0;
        const double along = std::cos(angle), across = std::sin(angle);
        const auto rotate = [&](double axial, double flexural) {
            return std::array{axial * along * along + flexural * across * across,
                              axial * across * across + flexural * along * along, (axial - flexural) * across * along};
        };
        stiffness_ = rotate(c.joint().axial_stiffness, c.joint().flexural_stiffness);
        damping_ = rotate(c.joint().axial_damping, c.joint().flexural_damping);
    }

    std::string first_broken() {
        check_history();
        check_energy();
        check_tallies();
        for (std::size_t k = 0; k < trace_.time.size() && broken_.empty(); ++k)
            check_sample(k);
        return broken_;
    }

private:
    template <typename... Parts>
    void expect(bool holds, const Parts&... parts) {
        if (holds || !broken_.empty()) return;
        std::ostringstream text;
        text.precision(9);
        (text << ... << parts);
        broken_ = text.str();
    }

    void check_history() {
        const record::ContactHistory& history = motion_.record.histories.front();
        const double end = motion_.outcome.time;
        if (end == 0.0) return;
        expect(!history.empty(), "no history");
        if (history.empty()) return;
        expect(history.front().from == 0.0, "history begins at ", history.front().from);
        expect(std::abs(history.back().to - end) <= 1e-12 * end, "history ends at ", history.back().to);
        for (std::size_t k = 0; k < history.size(); ++k) {
            expect(history[k].to > history[k].from, "interval of no time at ", history[k].from);
            expect(std::isfinite(history[k].slip_velocity + history[k].gap_velocity), "not a number at ",
                   history[k].from);
            if (k == 0) continue;
            expect(history[k].from == history[k - 1].to, "gap in the history at ", history[k].from);
            expect(history[k].state != history[k - 1].state, "same state twice at ", history[k].from);
        }
    }

    void check_energy() {
        const integration::EnergyBalance& e = motion_.energy;
        expect(std::isfinite(e.residual), "energy is not a number");
        const double share = e.relative_residual();
        const double idle_energy = this->idle_energy();
        expect(std::abs(share) <= energy_share || std::abs(e.residual) <= idle_energy, "energy residual ", share, " (",
               e.residual, " J)");
        expect(e.dashpot_loss >= -idle_energy, "dashpots give energy ", e.dashpot_loss);
        expect(e.friction_loss >= -idle_energy, "friction gives energy ", e.friction_loss);
        expect(e.impact_loss >= -idle_energy, "impacts give energy ", e.impact_loss);
    }

    // [J] what rounding makes of energies: displacements along a soft spring count with the stiff one's forces,
    // velocities with the plate's, which they are set to where a slip reverses or ends
    double idle_energy() const {
        const double soft = std::min({c_.joint().axial_stiffness, c_.joint().flexural_stiffness, c_.plate.stiffness});
        const double stiff = std::max({c_.joint().axial_stiffness, c_.joint().flexural_stiffness, c_.plate.stiffness});
        const double heavy = std::max(c_.joint().mass, c_.plate.mass);
        const double V = largest_surface_velocity();
        const double F = c_.contact().preload;
        double largest = 1e-16 * (F * F / soft + heavy * V * V);
        for (std::size_t k = 0; k < trace_.time.size(); ++k) {
            const auto u = at(trace_.displacement, k), v = at(trace_.velocity, k);
            const double far = std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
            const double fast = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
            largest = std::max(largest, far * (stiff * far + F) + heavy * fast * (fast + V));
        }
        return energy_rounding * largest;
    }

    void check_tallies() {
        double sum = 0.0;
        for (const record::Tally& tally : motion_.record.phases) {
            for (const double time : tally.contacts.front().time)
                sum += time;
            for (const record::Vibration& vibration : tally.vibration)
                expect(std::isfinite(vibration.square_time) && std::isfinite(vibration.peak_square) &&
                           vibration.square_time >= 0.0 && vibration.peak_square >= 0.0,
                       "vibration ", vibration.square_time);
        }
        const double end = motion_.outcome.time;
        expect(std::abs(sum - end) <= 1e-9 * end, "tallies hold ", sum, " s of ", end);
    }

    void check_sample(std::size_t k) {
        const auto u = at(trace_.displacement, k), v = at(trace_.velocity, k), a = at(trace_.acceleration, k);
        const double F = c_.contact().preload;
        const double stiffest = std::max(c_.joint().axial_stiffness, c_.joint().flexural_stiffness);
        const double most_damped = std::max(c_.joint().axial_damping, c_.joint().flexural_damping);
        Sum tangential, above, below;  // T, N on mass 1, N on mass 2
        tangential.add(c_.joint().mass * a[0]);
        above.add(c_.joint().mass * a[1]);
        add_joint(tangential, stiffness_[0], stiffness_[2], stiffest, u);
        add_joint(tangential, damping_[0], damping_[2], most_damped, v);
        add_joint(above, stiffness_[2], stiffness_[1], stiffest, u);
        add_joint(above, damping_[2], damping_[1], most_damped, v);
        above.add(F);
        // an engine that counts from the gap knows the joint's position as well as the plate's,
        // whatever the stiffness between
        above.size += 1e-5 * (stiffest * std::abs(u[2]) + most_damped * std::abs(v[2]));
        below.add(F);
        below.add(-c_.plate.mass * a[2]);
        below.add(-c_.plate.damping * v[2]);
        below.add(-c_.plate.stiffness * u[2]);

        const double time = trace_.time[k];
        const double size = tangential.size + above.size + below.size;
        const double N = trace_.contacts.front().normal_force[k], T = trace_.contacts.front().friction_force[k];
        expect(std::isfinite(size), "not a number at ", time);
        expect(std::abs(tangential.value - T) <= rounding * size + event_depth * size * (N == 0.0),
               "tangential balance at ", time, ": ", tangential.value, " is not ", T);
        expect(std::abs(above.value - below.value) <= rounding * size, "normal balance at ", time, ": ", above.value,
               " is not ", below.value);

        const double length = std::abs(u[1]) + std::abs(u[2]) + (std::abs(v[1]) + std::abs(v[2])) / fastest_;
        const double V = surface_velocity(time);
        const double speed = std::abs(v[0]) + largest_surface_velocity();
        const double w = v[0] - V;
        expect(std::abs(trace_.surface_velocity[k] - V) <= 1e-11 * largest_surface_velocity(), "surface velocity at ",
               time, ": ", trace_.surface_velocity[k], " is not ", V);
        if (trace_.contacts.front().state[k] == ContactState::separation) {
            expect(u[1] - u[2] >= -event_depth * length, "gap ", u[1] - u[2], " at ", time);
            expect(std::abs(above.value) <= rounding * size, "force ", above.value, " across an open gap at ", time);
            expect(N == 0.0 && T == 0.0, "forces in separation at ", time);
            return;
        }
        expect(std::abs(u[1] - u[2]) <= rounding * length, "closed gap ", u[1] - u[2], " at ", time);
        expect(std::abs(v[1] - v[2]) <= rounding * (std::abs(v[1]) + std::abs(v[2])), "closed gap moves at ", time);
        expect(above.value >= -event_depth * size, "normal force ", above.value, " at ", time);
        expect(std::abs(above.value - N) <= event_depth * size, "normal force at ", time, ": ", above.value, " is not ",
               N);
        check_friction(k,
                       {.tangential = tangential.value, .normal = above.value, .size = size, .w = w, .speed = speed});
    }

    // T of the equations of motion and N of them, with the size of their terms; slip velocity and the size of its terms
    struct Closed {
        double tangential, normal, size, w, speed;
    };

    void check_friction(std::size_t k, const Closed& now) {
        const double time = trace_.time[k];
        const double N = trace_.contacts.front().normal_force[k], T = trace_.contacts.front().friction_force[k];
        const model::FrictionLaw law = model::friction_law(c_.contact());
        if (trace_.contacts.front().state[k] == ContactState::stick) {
            expect(std::abs(now.w) <= rounding * now.speed, "stuck contact moves with ", now.w, " at ", time);
            const double limit = stick_limit(law, model::slip_against(now.tangential));
            expect(std::abs(now.tangential) <= limit * now.normal + event_depth * now.size, "stick at ", time,
                   " with T ", now.tangential, " and N ", now.normal);
        } else {
            const double off = std::min(std::abs(T - slip_ratio(law, model::Slip::forward) * N),
                                        std::abs(T - slip_ratio(law, model::Slip::backward) * N));
            expect(off <= rounding * now.size, "slip at ", time, " with T ", T, " and N ", N);
            // a slip that ends where the plate comes to a stop: w is what rounding of the velocities before has left
            const double pace = now.speed + largest_surface_velocity();
            expect(T * now.w <= 0.0 || std::abs(now.w) <= event_depth * pace || std::abs(T) <= event_depth * now.size,
                   "friction drives the slip at ", time, " with T ", T, " and w ", now.w);
        }
    }

    static std::array<double, 3> at(const std::vector<std::vector<double>>& vectors, std::size_t k) {
        return {vectors[0][k], vectors[1][k], vectors[2][k]};
    }

    static void add_joint(Sum& sum, double in_x, double in_y, double strongest, const std::array<double, 3>& motion) {
        sum.add(in_x * motion[0]);
        sum.add(in_y * motion[1]);
        // near 0 and 90 degrees a component is known to the rounding of the largest one: 1e-15 of it, beside `rounding`
        sum.size += 1e-5 * strongest * (std::abs(motion[0]) + std::abs(motion[1]));
    }

    double largest_surface_velocity() const {
        if (c_.drive.kind == parameters::DriveKind::constant) return std::abs(c_.drive.velocity);
        if (c_.drive.kind == parameters::DriveKind::sinusoidal)
            return c_.drive.amplitude * 2.0 * std::numbers::pi * c_.drive.frequency;
        double largest = 0.0;
        for (const double velocity : c_.drive.velocities)
            largest = std::max(largest, std::abs(velocity));
        return largest;
    }

    double surface_velocity(double time) const {
        if (c_.drive.kind == parameters::DriveKind::constant) return c_.drive.velocity;
        if (c_.drive.kind == parameters::DriveKind::sinusoidal)
            return largest_surface_velocity() * std::cos(2.0 * std::numbers::pi * c_.drive.frequency * time);
        std::size_t k = 1;
        while (k + 1 < c_.drive.times.size() && c_.drive.times[k] < time)
            ++k;
        const double share = (time - c_.drive.times[k - 1]) / (c_.drive.times[k] - c_.drive.times[k - 1]);
        return std::lerp(c_.drive.velocities[k - 1], c_.drive.velocities[k], share);
    }

    const Case& c_;
    const integration::Motion& motion_;
    const record::Trace& trace_;
    std::array<double, 3> stiffness_{};  // [N/m] xx, yy, xy
    std::array<double, 3> damping_{};    // [N*s/m]
    double fastest_ = std::sqrt((c_.joint().axial_stiffness + c_.joint().flexural_stiffness) / c_.joint().mass +
                                c_.plate.stiffness / c_.plate.mass);  // [rad/s]
    std::string broken_;
};

}  // namespace

std::string broken_law(const Case& c, const integration::Motion& motion) {
    return Laws(c, motion).first_broken();
}

}  // namespace stridor::support
