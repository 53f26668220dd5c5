#include "stridor/advice/headline.hpp"

#include "stridor/advice/margins.hpp"
#include "stridor/parameters/case_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::advice {

namespace {

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
            return fmt::format("{} here; within {:g} % of it nobody looked yet", quiet, within);
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
