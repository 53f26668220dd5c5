#include "stridor/advice/neighbourhood.hpp"

#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/usual_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stridor::advice {

namespace {

// a change is located so well [1]
constexpr double near_resolution = 5e-4;

// a quantity to one side of a design: `unit` of it is 100 %
struct NearSide {
    std::string key;
    double value = 0.0;  // in the field's unit
    double unit = 0.0;   // in the field's unit; below zero: less of it

    double at(double share) const { return value + share * unit; }
};

bool ends_silence(const DesignVerdict& verdict) {
    return !is_quiet(verdict) && !is_invalid(verdict);
}

bool is_allowed(const parameters::Case& c, const std::string& key, double value) {
    const parameters::Range range = parameters::range_of(c, key);
    const bool is_above = range.low_end == parameters::Range::Low::open ? value > range.low : value >= range.low;
    return is_above && value <= range.high;
}

std::vector<NearSide> sides_of(const parameters::Case& c) {
    std::vector<NearSide> sides;
    for (const std::string& key : parameters::design_keys(c)) {
        const double value = parameters::get_quantity(c, key);
        const std::optional<parameters::UsualRange> usual = parameters::usual_range(c, key);
        const double size = value != 0.0 ? std::abs(value) : usual->to - usual->from;
        // less of a velocity is a slower one, whichever way
        const double more = value < 0.0 ? -size : size;
        sides.push_back({key, value, -more});
        sides.push_back({key, value, more});
    }
    return sides;
}

// where the silence of one side ends: between two shares
struct NearBracket {
    std::size_t side = 0;
    double before = 0.0;
    double beyond = 0.0;
    DesignVerdict verdict{};  // beyond
};

std::vector<NearBracket> brackets_of(const DesignSpace& space, const std::vector<NearSide>& sides,
                                     DesignRunner& runner) {
    std::vector<Design> designs;
    std::vector<std::pair<std::size_t, std::size_t>> places;  // side, step
    for (std::size_t side = 0; side < sides.size(); ++side)
        for (std::size_t step = 0; step < near_steps.size(); ++step) {
            const double value = sides[side].at(near_steps[step]);
            if (!is_allowed(space.base, sides[side].key, value)) break;
            designs.push_back({{{sides[side].key, value}}});
            places.emplace_back(side, step);
        }
    std::vector<DesignVerdict> verdicts = runner.judge(designs);
    std::vector<NearBracket> brackets;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto [side, step] = places[k];
        const bool is_found = !brackets.empty() && brackets.back().side == side;
        if (is_found || !ends_silence(verdicts[k])) continue;
        brackets.push_back({side, step > 0 ? near_steps[step - 1] : 0.0, near_steps[step], std::move(verdicts[k])});
    }
    return brackets;
}

void narrow(std::vector<NearBracket>& brackets, const std::vector<NearSide>& sides, DesignRunner& runner) {
    while (true) {
        std::vector<NearBracket*> wide;
        std::vector<Design> middles;
        for (NearBracket& bracket : brackets) {
            if (bracket.beyond - bracket.before <= near_resolution) continue;
            const NearSide& side = sides[bracket.side];
            wide.push_back(&bracket);
            middles.push_back({{{side.key, side.at(0.5 * (bracket.before + bracket.beyond))}}});
        }
        if (wide.empty()) return;
        std::vector<DesignVerdict> verdicts = runner.judge(middles);
        for (std::size_t k = 0; k < wide.size(); ++k) {
            const double middle = 0.5 * (wide[k]->before + wide[k]->beyond);
            const bool is_beyond = ends_silence(verdicts[k]);
            (is_beyond ? wide[k]->beyond : wide[k]->before) = middle;
            if (is_beyond) wide[k]->verdict = std::move(verdicts[k]);
        }
    }
}

}  // namespace

Neighbourhood neighbourhood(const DesignSpace& space, DesignRunner& runner) {
    const std::vector<NearSide> sides = sides_of(space.base);
    std::vector<NearBracket> brackets = brackets_of(space, sides, runner);
    narrow(brackets, sides, runner);
    Neighbourhood near;
    for (NearBracket& bracket : brackets) {
        const NearSide& side = sides[bracket.side];
        const bool is_less = (side.unit < 0.0) != (side.value < 0.0);
        near.turns.push_back({side.key, is_less ? -bracket.beyond : bracket.beyond, side.at(bracket.beyond),
                              std::move(bracket.verdict)});
    }
    std::stable_sort(near.turns.begin(), near.turns.end(),
                     [](const auto& a, const auto& b) { return std::abs(a.relative) < std::abs(b.relative); });
    return near;
}

}  // namespace stridor::advice
