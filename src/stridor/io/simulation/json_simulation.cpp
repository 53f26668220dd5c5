#include "stridor/io/simulation/json_simulation.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/classification/interface_rules.hpp"
#include "stridor/io/json_members.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace stridor::io {

namespace {

using namespace json_parts;
using parameters::Case;

// where a dotted key stands, made on the way
Json& place_of(Json& object, std::string_view key) {
    const std::size_t dot = key.find('.');
    Json& member = object[std::string(key.substr(0, dot))];
    return dot == std::string_view::npos ? member : place_of(member, key.substr(dot + 1));
}

Json figure_value(const analysis::EvidenceFigure& figure, const analysis::Evidence& evidence) {
    const double value = figure.value(evidence);
    return figure.holds == analysis::EvidenceFigure::Holds::count ? Json(static_cast<std::int64_t>(value))
                                                                  : Json(value);
}

using analysis::CarriedLoad;
using analysis::Eigenmode;
using analysis::Rates;
using integration::EnergyBalance;
using integration::LimitCycle;
using integration::Silence;
using record::Ending;

constexpr auto rates_members = std::to_array<Member<Rates>>({
    {{"slip", "1", "share of the time in slip"}, &Rates::slip},
    {{"stick", "1", "share of the time in stick"}, &Rates::stick},
    {{"separation", "1", "share of the time in separation"}, &Rates::separation},
});

constexpr auto silence_members = std::to_array<Member<Silence>>({
    {{"time", "s", "from when on"}, &Silence::time},
    {{"normal_force", "N", "what the normal force never falls below"}, &Silence::normal_force},
    {{"slip_velocity", "m/s", "what the magnitude of the slip velocity never falls below"}, &Silence::slip_velocity},
});

constexpr auto cycle_members = std::to_array<Member<LimitCycle>>({
    {{"time", "s", "when the second of two equal periods ended"}, &LimitCycle::time},
    {{"period", "s", "of the motion"}, &LimitCycle::period},
    {{"residual", "1", "distance of the states one period apart, as a share of the velocities"}, &LimitCycle::residual},
    {{"events", "", "changes of state or of the slip's direction, and impacts, per period"},
     [](const LimitCycle& cycle) -> Json { return cycle.events; }},
});

constexpr auto ending_members = std::to_array<Member<Ending>>({
    {{"state", "", "the last one of the first contact", "ContactState"},
     [](const Ending& ending) -> Json { return name_of(model::contact_state_names, ending.state); }},
    {{"since", "s", "when it entered that"}, &Ending::since},
    {{"future", "", "what is known of the time after the run", "string"},
     [](const Ending& ending) -> Json { return name_of(record::future_names, ending.outlook.future); }},
    {{"release", "s", "about when a contact that sticks will slip", "number | null"},
     [](const Ending& ending) -> Json { return ending.outlook.release; }},
    {{"growth", "1/s", "of a small disturbance of sliding that does not last", "number | null"},
     [](const Ending& ending) -> Json { return ending.outlook.growth; }},
    {{"grown", "s", "about when that ends the sliding", "number | null"},
     [](const Ending& ending) -> Json { return ending.outlook.grown; }},
});

constexpr auto energy_members = std::to_array<Member<EnergyBalance>>({
    {{"stored", "J", "change of kinetic and elastic energy"}, &EnergyBalance::stored},
    {{"preload_work", "J", "work of the constant load"}, &EnergyBalance::preload_work},
    {{"drive_work", "J", "work of the drive"}, &EnergyBalance::drive_work},
    {{"dashpot_loss", "J", "what the dampers took"}, &EnergyBalance::dashpot_loss},
    {{"friction_loss", "J", "what friction took"}, &EnergyBalance::friction_loss},
    {{"impact_loss", "J", "what impacts took"}, &EnergyBalance::impact_loss},
    {{"residual", "J", "what is left over"}, &EnergyBalance::residual},
    {{"relative_residual", "1", "that as a share of all energy that went in or out"},
     [](const EnergyBalance& energy) -> Json { return energy.relative_residual(); }},
});

constexpr auto load_members = std::to_array<Member<CarriedLoad>>({
    {{"normal_force", "N", "mean of the normal force"}, &CarriedLoad::normal_force},
    {{"load_share", "1", "of the load of the interface"}, &CarriedLoad::share},
    {{"friction_power", "W", "mean of what friction takes"}, &CarriedLoad::friction_power},
    {{"is_loaded", "", "enough for a verdict", "boolean"},
     [](const CarriedLoad& load) -> Json { return load.is_loaded; }},
});

constexpr auto mode_members = std::to_array<Member<Eigenmode>>({
    {{"growth", "1/s", "real part of the eigenvalue"}, &Eigenmode::growth},
    {{"frequency", "Hz", "0 of a real eigenvalue"}, &Eigenmode::frequency},
});

Json rates_object(const Rates& rates) {
    return object_of(rates_members, rates);
}

// the figures of the table; beside two of them stands what is no single number
void put_figures(Json& object, const analysis::Evidence& evidence) {
    const analysis::Alternation& alternation = evidence.alternation;
    for (const analysis::EvidenceFigure& figure : analysis::evidence_figures()) {
        place_of(object, figure.key) = figure_value(figure, evidence);
        if (figure.key == "variation")
            for (const analysis::Mismatch& mismatch : alternation.mismatch)
                object["mismatch"].push_back(mismatch.mean);
        if (figure.key == "lag")
            object["beat"] = {{"from", name_of(model::contact_state_names, alternation.from)},
                              {"to", name_of(model::contact_state_names, alternation.to)}};
    }
    object["levels"]["reference"] = "1e-9 m/s";
    if (evidence.step_change) object["step_change"] = rates_object(*evidence.step_change);
    if (evidence.judged_step_change) object["judged_step_change"] = rates_object(*evidence.judged_step_change);
}

Json verdict_object(const classification::Verdict& verdict) {
    Json object{{"category", classification::name(verdict.category)}, {"quiet_because", quiet_word(verdict.quiet)}};
    put_figures(object, verdict.evidence);
    object["margins"] = margins_array(verdict.margins);
    object["reasons"] = verdict.reasons;
    object["warnings"] = verdict.warnings;
    return object;
}

// how the contacts of an interface carry and what they do together
Json interface_object(const Case& c, const classification::InterfaceVerdict& verdict) {
    Json contacts = Json::array();
    for (std::size_t k = 0; k < verdict.figures.contacts.size(); ++k) {
        contacts.push_back({{"name", parameters::contact_name(c, verdict.figures.contacts[k])}});
        contacts.back().update(object_of(load_members, verdict.figures.loads[k]));
    }
    return {{"contacts", std::move(contacts)},
            {"rates", named(record::interface_state_names, verdict.figures.rates)},
            {"free_together", verdict.free_together},
            {"leading", parameters::contact_name(c, verdict.whole.evidence.contact)},
            {"differs", verdict.differs},
            {"category", classification::name(verdict.whole.category)}};
}

// each contact by itself, called as it is in the case
Json contacts_array(const Case& c, const record::Tally& phase, const classification::PhaseVerdicts& verdicts) {
    Json contacts = Json::array();
    for (std::size_t k = 0; k < verdicts.contacts.size(); ++k)
        contacts.push_back({{"name", parameters::contact_name(c, k)},
                            {"rates", rates_object(analysis::rates(phase.contacts[k].time))},
                            {"verdict", verdicts.contacts[k] ? verdict_object(*verdicts.contacts[k]) : Json(nullptr)}});
    return contacts;
}

// of a case with several joints or a structure of its own
void put_contacts(Json& object, const Case& c, const record::Tally& phase) {
    const classification::PhaseVerdicts all =
        classification::classify_all(phase, c.verdict, classification::contact_names(c));
    object["contacts"] = contacts_array(c, phase, all);
    if (!all.interfaces.empty())
        object["interfaces"] = array_of(all.interfaces, [&](const classification::InterfaceVerdict& verdict) {
            return interface_object(c, verdict);
        });
}

// the same phase of contacts without inertia, and whether its verdict agrees
Json massless_object(const Case& c, const record::Tally& with, const record::Tally& without) {
    const classification::PhaseVerdicts verdicts =
        classification::classify_all(without, c.verdict, classification::contact_names(c));
    const classification::Category wanted = classification::classify_all(with, c.verdict).whole.category;
    return {{"category", classification::name(verdicts.whole.category)},
            {"agrees", verdicts.whole.category == wanted},
            {"contacts", contacts_array(c, without, verdicts)}};
}

Json phase_object(const Case& c, const classification::Verdict& verdict) {
    const analysis::Evidence& evidence = verdict.evidence;
    return {{"phase", name_of(record::phase_names, evidence.phase)},
            {"window",
             {{"from", c.run.duration - c.run.window},
              {"to", c.run.duration},
              {"duration", evidence.window_time},
              {"judged", evidence.judged_time}}},
            {"verdict", verdict_object(verdict)}};
}

Json simulation_units(const Case& c) {
    Json units = case_units(c);
    units.update(Json{{"engine.step", "s"}, {"engine.step_limit", "s"}, {"outcome.time", "s"}});
    put_units(units, "outcome.silence.", silence_members);
    put_units(units, "outcome.limit_cycle.", cycle_members);
    put_units(units, "outcome.ending.", ending_members);
    units["energy"] = "J";
    put_units(units, "energy.", energy_members, "J");
    units.update(
        Json{{"phases.window", "s"}, {"phases.interfaces.rates", "1"}, {"phases.interfaces.free_together", "1"}});
    put_units(units, "phases.interfaces.contacts.", load_members);
    for (const analysis::EvidenceFigure& figure : analysis::evidence_figures()) {
        if (figure.key == "variation") units["phases.verdict.mismatch"] = "1";
        if (const std::string key = analysis::unit_key(figure); !key.empty())
            units["phases.verdict." + key] = figure.unit;
    }
    units["phases.verdict.margins"] = "1";
    if (parameters::engine_of(c) != parameters::Engine::exact)
        units.update(Json{{"engine.compared_step", "s"},
                          {"phases.verdict.step_change", "1"},
                          {"phases.verdict.judged_step_change", "1"}});
    return units;
}

Json stability_object(const parameters::Case& c, const analysis::SlidingStability& stability) {
    Json object{{"kind", name_of(analysis::stability_names, stability.kind)},
                {"growth", stability.growth},
                {"frequency", stability.frequency},
                {"normal_force", stability.normal_force},
                {"modes", objects_of(mode_members, stability.modes)}};
    for (const std::size_t contact : stability.open)
        object["open"].push_back(parameters::contact_name(c, contact));
    return object;
}

constexpr double least_share = 1e-3;  // [1] of a free mode that is listed

// the free modes that make most of it first
Json free_modes_array(const analysis::SlidingModes& modes, const analysis::SlidingMode& mode) {
    Json array = Json::array();
    for (const std::size_t number : analysis::by_share(mode)) {
        if (mode.energy_shares[number] < least_share) break;
        array.push_back({{"number", number + 1},
                         {"frequency", modes.free_frequencies[number]},
                         {"energy_share", mode.energy_shares[number]},
                         {"mac", mode.mac[number]}});
    }
    return array;
}

Json contributions_object(const parameters::Case& c, const analysis::SlidingModes& modes,
                          const analysis::SlidingMode& mode) {
    Json contacts = Json::array(), shape = Json::array();
    for (std::size_t k = 0; k < mode.contact_growth.size(); ++k)
        contacts.push_back({{"name", parameters::contact_name(c, k)}, {"growth", mode.contact_growth[k]}});
    const std::vector<std::string> rows = dof_names(c, static_cast<std::size_t>(mode.shape.size()));
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::complex<double> motion = mode.shape(static_cast<Eigen::Index>(row));
        shape.push_back({{"name", rows[row]}, {"real", motion.real()}, {"imaginary", motion.imag()}});
    }
    return {{"growth", mode.eigenvalue.real()},
            {"frequency", mode.eigenvalue.imag() / base::two_pi},
            {"contacts", std::move(contacts)},
            {"damping_growth", mode.damping_growth},
            {"free_modes", free_modes_array(modes, mode)},
            {"shape", std::move(shape)}};
}

Json direction_object(const parameters::Case& c, const analysis::DirectionScan& direction) {
    Json object{{"direction", name_of(parameters::direction_names, direction.direction)}};
    object.update(stability_object(c, direction.here));
    if (direction.critical_velocity) object["critical_velocity"] = *direction.critical_velocity;
    if (direction.modes)
        object["contributions"] = array_of(direction.modes->modes, [&](const analysis::SlidingMode& mode) {
            return contributions_object(c, *direction.modes, mode);
        });
    object["points"] = array_of(direction.path.points, [&](const analysis::StabilityPoint& point) {
        Json entry{{"value", point.value}};
        entry.update(stability_object(c, point.stability));
        if (point.critical_velocity) entry["critical_velocity"] = *point.critical_velocity;
        return entry;
    });
    object["boundaries"] = array_of(direction.path.boundaries, [](const analysis::StabilityBoundary& boundary) -> Json {
        return {{"value", boundary.value},
                {"below", name_of(analysis::stability_names, boundary.below)},
                {"above", name_of(analysis::stability_names, boundary.above)},
                {"frequency", boundary.frequency}};
    });
    return object;
}

// the same names stand at `directions`, in their `points` and in their `modes`
Json stability_units() {
    Json units{{"directions.growth", "1/s"}, {"directions.frequency", "Hz"}, {"directions.normal_force", "N"}};
    put_units(units, "directions.modes.", mode_members);
    units["directions.boundaries.frequency"] = "Hz";
    return units;
}

// what `--modes` adds
Json contribution_units() {
    return {{"directions.contributions.growth", "1/s"},
            {"directions.contributions.frequency", "Hz"},
            {"directions.contributions.contacts.growth", "1/s"},
            {"directions.contributions.damping_growth", "1/s"},
            {"directions.contributions.free_modes.frequency", "Hz"},
            {"directions.contributions.free_modes.energy_share", "1"},
            {"directions.contributions.free_modes.mac", "1"},
            {"directions.contributions.shape", "1"}};
}

Json outcome_object(const Case& c, const integration::Motion& motion) {
    Json object{{"reason", name_of(integration::reason_names, motion.outcome.reason)}, {"time", motion.outcome.time}};
    if (motion.silence) object["silence"] = object_of(silence_members, *motion.silence);
    if (motion.cycle) object["limit_cycle"] = object_of(cycle_members, *motion.cycle);
    if (motion.massless) object["massless"] = name_of(integration::reason_names, motion.massless->outcome.reason);
    const bool has_names = parameters::has_named_contacts(c);
    for (std::size_t k = 0; has_names && k < motion.last_set.size(); ++k)
        object["contacts"].push_back({{"name", parameters::contact_name(c, k)},
                                      {"state", name_of(model::contact_state_names, motion.last_set[k])}});
    if (motion.record.phases.empty()) return object;
    object["ending"] = object_of(ending_members, motion.record.phases.front().contacts.front().ending);
    return object;
}

Json engine_object(const parameters::Case& c, const integration::Cost& cost) {
    const auto text = [&](const char* key) { return parameters::value_text(c, *parameters::find_field(key)); };
    const std::string_view name = parameters::engine_names[static_cast<std::size_t>(parameters::engine_of(c))];
    Json object{{"name", name}, {"impact", text("contact.impact")}, {"steps", cost.steps}};
    if (c.run.engine == parameters::Engine::automatic) object["asked"] = text("run.engine");
    if (const std::optional<base::Problem> problem = parameters::why_not_exact(c))
        object["chosen_since"] = problem->what;
    if (parameters::engine_of(c) == parameters::Engine::beta_2)
        object.update(Json{{"step", c.run.step},
                           {"compared_step", 2.0 * c.run.step},
                           {"beta_2", c.run.beta_2},
                           {"step_limit", cost.step_limit}});
    if (parameters::engine_of(c) == parameters::Engine::moreau)
        object.update(Json{{"step", c.run.step},
                           {"compared_step", 2.0 * c.run.step},
                           {"step_limit", cost.step_limit},
                           {"formulation", text("run.formulation")}});
    return object;
}

}  // namespace

std::vector<DescribedRecord> simulation_records() {
    return {described("Rates", "Shares of the time in each state of a contact.", rates_members),
            described("Silence", "What is proven of a contact that slides for ever.", silence_members),
            described("LimitCycle", "A motion that repeats itself.", cycle_members),
            described("RunEnding", "How a run ends, and how it would go on.", ending_members),
            described("Energy", "The energy balance of a run.", energy_members),
            described("CarriedLoad", "What one contact of an interface carries.", load_members),
            described("Mode", "A mode of steady sliding.", mode_members)};
}

std::string case_json(const parameters::Case& c) {
    return base::text_of(case_object(c));
}

std::string check_json(const parameters::Case& c) {
    Json document = opening("check");
    document.update(case_object(c));
    return base::text_of(document);
}

std::string simulation_json(const parameters::Case& c, const integration::Motion& motion, const integration::Cost& cost,
                            std::span<const classification::Verdict> verdicts) {
    Json document = opening("simulation", c);
    document["engine"] = engine_object(c, cost);
    document["outcome"] = outcome_object(c, motion);
    document["energy"] = object_of(energy_members, motion.energy);
    document["phases"] = Json::array();
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
        document["phases"].push_back(phase_object(c, verdicts[k]));
        const bool has_names = parameters::has_named_contacts(c);
        if (has_names && k < motion.record.phases.size())
            put_contacts(document["phases"].back(), c, motion.record.phases[k]);
        if (motion.massless && k < motion.massless->phases.size() && integration::has_result(motion.massless->outcome))
            document["phases"].back()["massless"] =
                massless_object(c, motion.record.phases[k], motion.massless->phases[k]);
    }
    document["units"] = simulation_units(c);
    return base::text_of(document);
}

std::string stability_json(const analysis::StabilityScan& scan) {
    Json document = opening("stability", scan.base);
    if (!scan.key.empty()) document["over"] = {{"parameter", scan.key}, {"unit", scan.unit}};
    document["directions"] = array_of(scan.directions, [&](const analysis::DirectionScan& direction) {
        return direction_object(scan.base, direction);
    });
    Json units = case_units(scan.base);
    units.update(stability_units());
    if (!scan.directions.empty() && scan.directions.front().critical_velocity)
        units["directions.critical_velocity"] = "m/s";
    if (!scan.directions.empty() && scan.directions.front().modes) units.update(contribution_units());
    document["units"] = std::move(units);
    return base::text_of(document);
}

}  // namespace stridor::io
