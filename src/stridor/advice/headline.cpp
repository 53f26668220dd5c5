#include "stridor/advice/headline.hpp"

#include "stridor/advice/margins.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/usual_range.hpp"

#include <fmt/format.h>

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

using classification::Category;
using classification::Quiet;

std::string_view deed(const DesignVerdict& verdict, std::size_t phase) {
    if (verdict.phases[phase].status != sweep::Status::done) return "has no result";
    switch (verdict.phases[phase].category) {
        case Category::none:
            return is_quiet_phase(verdict, phase) ? "is quiet" : classification::name(verdict.phases[phase].quiet);
        case Category::squeal:
            return "squeals";
        case Category::squeak:
            return "squeaks";
        case Category::creak:
            return "creaks";
        case Category::undecided:
            break;
    }
    return "is undecided";
}

std::string while_words(record::Phase phase) {
    if (phase == record::Phase::all) return "";
    return " while " + std::string(record::phase_names[static_cast<std::size_t>(phase)]);
}

// the start, where it is not the one that the case asks for
std::string start_words(const DesignSpace& space, const DesignVerdict& verdict, std::size_t phase) {
    const bool is_own = verdict.starts.empty() || verdict.starts[phase] == space.base.run.initial;
    if (is_own || is_quiet_phase(verdict, phase)) return "";
    return " (run.initial = " + std::string(sweep::start_names()[static_cast<std::size_t>(verdict.starts[phase])]) +
           ")";
}

// "squeals while going, is quiet while coming"; "squeals both ways"
std::string deeds(const DesignSpace& space, const DesignVerdict& verdict) {
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < space.phases.size(); ++k)
        parts.push_back(std::string(deed(verdict, k)) + start_words(space, verdict, k));
    if (parts.size() == 2 && parts.front() == parts.back()) return parts.front() + " both ways";
    std::string text;
    // what is heard comes first
    for (const bool quiet : {false, true})
        for (std::size_t k = 0; k < parts.size(); ++k)
            if (is_quiet_phase(verdict, k) == quiet)
                text += (text.empty() ? "" : ", ") + parts[k] + while_words(space.phases[k]);
    return text;
}

// " because it sticks", " (it sticks while coming)"
std::string silence_words(const DesignSpace& space, const DesignVerdict& verdict) {
    const auto sticks = [](const sweep::StartVerdict& phase) { return phase.quiet == Quiet::sticks; };
    if (std::all_of(verdict.phases.begin(), verdict.phases.end(), sticks)) return " because it sticks";
    for (std::size_t k = 0; k < space.phases.size(); ++k)
        if (sticks(verdict.phases[k])) return " (it sticks" + while_words(space.phases[k]) + ")";
    return "";
}

// what the nearest change makes of it
std::string turn_deed(const DesignSpace& space, const DesignVerdict& verdict) {
    const std::size_t phase = sweep::worst(verdict.phases);
    return std::string(deed(verdict, phase)) + while_words(space.phases[phase]) + start_words(space, verdict, phase);
}

bool is_name_of_several(std::string_view name) {
    return std::count_if(parameters::fields().begin(), parameters::fields().end(),
                         [&](const parameters::Field& field) { return field.name == name; }) > 1;
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

Standing standing(const DesignVerdict& present, const std::optional<Neighbourhood>& near) {
    if (!is_quiet(present)) return Standing::not_quiet;
    if (!near) return Standing::quiet_here;
    return near->turns.empty() ? Standing::quiet : Standing::barely_quiet;
}

std::string headline(const DesignSpace& space, const DesignVerdict& present, const std::optional<Neighbourhood>& near) {
    const std::string quiet = "quiet" + silence_words(space, present);
    const double within = 100.0 * looked_within;
    switch (standing(present, near)) {
        case Standing::quiet:
            return fmt::format("{}, and at {} steps from {:g} to {:g} % more and less of each quantity too", quiet,
                               near_steps.size(), 100.0 * near_steps.front(), within);
        case Standing::barely_quiet:
            return fmt::format("{}, but only just: {} {}", quiet, change_words(near->turns.front()),
                               turn_deed(space, near->turns.front().verdict));
        case Standing::quiet_here:
            return fmt::format("{} here; changes within {:g} % were not tried yet", quiet, within);
        case Standing::not_quiet:
            break;
    }
    return deeds(space, present);
}

std::string change_words(const NearChange& change) {
    return fmt::format("{:.2g} % {} {}", 100.0 * std::abs(change.relative), change.relative < 0.0 ? "less" : "more",
                       quantity_words(change.key));
}

std::vector<std::string> turn_words(const DesignSpace& space, const Neighbourhood& near) {
    std::vector<std::string> words;
    for (const NearChange& change : near.turns) {
        const std::string_view unit = parameters::unit_of(change.key);
        words.push_back(fmt::format("{} ({:.5g}{}) {}", change_words(change), change.value,
                                    unit == "1" ? "" : " " + std::string(unit), turn_deed(space, change.verdict)));
    }
    return words;
}

std::string nearest_words(const DesignSpace& space, const NearestDesign& nearest) {
    constexpr std::size_t told = 3;
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < space.parameters.size(); ++k)
        if (nearest.shares[k] != space.origin[k]) order.emplace_back(-std::abs(nearest.shares[k] - space.origin[k]), k);
    std::sort(order.begin(), order.end());
    std::string text;
    for (std::size_t k = 0; k < std::min(told, order.size()); ++k) {
        const DesignParameter& range = space.parameters[order[k].second];
        const std::string_view unit = parameters::unit_of(range.key);
        text +=
            fmt::format("{}{} {:.5g} -> {:.5g}{}", text.empty() ? "" : ", ", range.key,
                        parameters::get_quantity(space.base, range.key),
                        value_at(range, nearest.shares[order[k].second]), unit == "1" ? "" : " " + std::string(unit));
    }
    return fmt::format("{} ({:.2g} % of {} away)", text, 100.0 * nearest.distance,
                       order.size() == 1 ? "its range" : "their ranges");
}

std::string scan_words() {
    return fmt::format(
        "Each range was looked at in {} steps, and closer around its present value; noise or silence that is narrower "
        "than a step may be missed.",
        scan_intervals);
}

std::string quantity_words(std::string_view key) {
    const parameters::Field& field = *parameters::field_of(key);
    std::string name(field.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    const bool is_of_one_joint = key != parameters::key_of(field);
    if (is_of_one_joint) {
        const std::string_view joint = key.substr(std::string_view("joint.").size());
        return name + " of " + std::string(joint.substr(0, joint.find('.')));
    }
    return is_name_of_several(field.name) ? std::string(field.section) + " " + name : name;
}

}  // namespace stridor::advice
