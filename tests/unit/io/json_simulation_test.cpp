#include "stridor/io/simulation/json_simulation.hpp"

#include "io_support.hpp"
#include "stridor/base/version.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/io/chart/json_chart.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/sweep/boundaries.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace stridor::io {
namespace {

using Json = nlohmann::json;

// a run made up by hand, with numbers that are hard to write
Json simulation_document() {
    const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    integration::Motion motion;
    motion.outcome = {integration::Reason::completed, 1.0};
    motion.energy.drive_work = 0.1 + 0.2;
    analysis::Evidence evidence;
    evidence.phase = record::Phase::going;
    evidence.window_time = 0.5;
    evidence.judged_time = 0.2;
    evidence.judged_rates = {0.2, 0.1, 0.7};
    evidence.alternation.regularity = std::numeric_limits<double>::quiet_NaN();
    evidence.alternation.frequency = 430.4;
    evidence.levels.joint = {5e-324, 1.0 / 3.0, -std::numeric_limits<double>::infinity(), 1.0};
    const std::vector verdicts{classification::classify(evidence, c.verdict)};
    return Json::parse(simulation_json(c, motion, {1e6, 2e-4}, verdicts));
}

TEST(CaseJson, HoldsWhatBelongsToTheCase) {
    const Json document = Json::parse(case_json(parameters::paper_case(parameters::PaperCase::squeal)));
    EXPECT_EQ(document["joint"]["incidence_angle"], 70.0);
    EXPECT_EQ(document["drive"]["kind"], "sinusoidal");
    EXPECT_FALSE(document["drive"].contains("velocity"));
    EXPECT_TRUE(document["title"].is_string());
}

TEST(SimulationJson, ListsSeveralContacts) {
    parameters::Case c;
    c.joints = {{.name = "upper"}, {.name = "lower"}};
    integration::Motion motion;
    record::Tally tally;
    tally.contacts.resize(2);
    tally.contacts[0].time = tally.contacts[0].judged_time = {1.0, 0.0, 0.0};
    tally.contacts[1].time = tally.contacts[1].judged_time = {0.5, 0.25, 0.25};
    tally.vibration.resize(5);
    tally.closing_vibration.resize(5);
    motion.record.phases = {tally};
    const auto verdicts = classification::classify_phases(motion.record.phases, c.verdict);
    const Json phase = Json::parse(simulation_json(c, motion, {}, verdicts))["phases"][0];
    EXPECT_EQ(phase["verdict"]["category"], "undecided");  // the second has too few intervals
    ASSERT_EQ(phase["contacts"].size(), 2U);
    EXPECT_EQ(phase["contacts"][0]["verdict"]["category"], "none");
    EXPECT_EQ(phase["contacts"][0]["name"], "upper");
    EXPECT_EQ(phase["contacts"][1]["name"], "lower");
    EXPECT_EQ(phase["contacts"][1]["rates"]["stick"], 0.25);
    EXPECT_EQ(phase["contacts"][1]["verdict"]["rates"]["stick"], 0.25);
    EXPECT_FALSE(simulation_document()["phases"][0].contains("contacts"));
}

TEST(SimulationJson, HoldsTheOtherFormulationBesideAndWhetherItAgrees) {
    parameters::Case c;
    c.joints = {{.name = "upper"}, {.name = "lower"}};
    record::Tally tally;
    tally.contacts.resize(2);
    for (record::ContactTally& contact : tally.contacts)
        contact.time = contact.judged_time = {1.0, 0.0, 0.0};
    tally.vibration.resize(5);
    tally.closing_vibration.resize(5);
    integration::Motion motion;
    motion.record.phases = {tally, tally};
    motion.massless = integration::MasslessTwin{{integration::Reason::completed, 1.0}, {tally, tally}};
    record::ContactTally& other = motion.massless->phases[1].contacts[1];
    other.time = other.judged_time = {0.5, 0.25, 0.25};
    const auto verdicts = classification::classify_phases(motion.record.phases, c.verdict);
    const Json document = Json::parse(simulation_json(c, motion, {}, verdicts));
    EXPECT_EQ(document["outcome"]["massless"], "completed");
    const Json agreeing = document["phases"][0]["massless"], differing = document["phases"][1]["massless"];
    EXPECT_EQ(agreeing["category"], "none");
    EXPECT_EQ(agreeing["agrees"], true);
    EXPECT_EQ(differing["category"], "undecided");
    EXPECT_EQ(differing["agrees"], false);
    ASSERT_EQ(differing["contacts"].size(), 2U);
    EXPECT_EQ(differing["contacts"][0]["name"], "upper");
    EXPECT_EQ(differing["contacts"][0]["verdict"]["category"], "none");
    EXPECT_EQ(differing["contacts"][1]["rates"]["stick"], 0.25);
    EXPECT_EQ(differing["contacts"][1]["verdict"]["category"], "undecided");
    // the verdict itself stays that of the standard formulation
    EXPECT_EQ(document["phases"][1]["verdict"]["category"], "none");
}

TEST(SimulationJson, SaysHowAFormulationBesideEndedWithoutAResult) {
    parameters::Case c;
    record::Tally tally;
    tally.contacts.resize(1);
    tally.vibration.resize(3);
    tally.closing_vibration.resize(3);
    integration::Motion motion;
    motion.record.phases = {tally};
    motion.massless = integration::MasslessTwin{{integration::Reason::no_forces, 0.25}, {tally}};
    const auto verdicts = classification::classify_phases(motion.record.phases, c.verdict);
    const Json document = Json::parse(simulation_json(c, motion, {}, verdicts));
    EXPECT_EQ(document["outcome"]["massless"], "no_forces");
    EXPECT_FALSE(document["phases"][0].contains("massless"));
    EXPECT_FALSE(simulation_document()["outcome"].contains("massless"));
}

TEST(SimulationJson, HasTheKeysOfTheContract) {
    const Json document = simulation_document();
    EXPECT_EQ(document["schema"], "stridor.simulation/1");
    EXPECT_EQ(document["version"], base::version());
    EXPECT_EQ(document["commit"], base::commit());
    for (const char* key : {"name", "impact", "steps"})
        EXPECT_TRUE(document["engine"].contains(key)) << key;
    EXPECT_EQ(document["outcome"]["reason"], "completed");
    for (const char* key : {"stored", "preload_work", "drive_work", "dashpot_loss", "friction_loss", "impact_loss",
                            "residual", "relative_residual"})
        EXPECT_TRUE(document["energy"].contains(key)) << key;
    ASSERT_EQ(document["phases"].size(), 1U);
    const Json& phase = document["phases"][0];
    EXPECT_EQ(phase["phase"], "going");
    EXPECT_EQ(phase["window"]["duration"], 0.5);
    EXPECT_EQ(phase["window"]["judged"], 0.2);
    const Json& verdict = phase["verdict"];
    EXPECT_TRUE(verdict["category"].is_string());
    for (const char* state : {"slip", "stick", "separation"}) {
        EXPECT_TRUE(verdict["rates"].contains(state));
        EXPECT_TRUE(verdict["judged_rates"].contains(state));
    }
    for (const char* key : {"regularity", "period", "frequency", "levels", "margins", "reasons"})
        EXPECT_TRUE(verdict.contains(key)) << key;
}

TEST(SimulationJson, TellsByHowMuchSharesChangedWithTheStep) {
    EXPECT_FALSE(simulation_document()["phases"][0]["verdict"].contains("step_change"));
    parameters::Case c;
    c.run.engine = parameters::Engine::moreau;
    classification::Verdict verdict;
    verdict.evidence.step_change = analysis::Rates{0.01, 0.02, 0.03};
    verdict.evidence.judged_step_change = analysis::Rates{0.04, 0.05, 0.06};
    const std::vector verdicts{verdict};
    const Json document = Json::parse(simulation_json(c, {}, {}, verdicts));
    const Json& told = document["phases"][0]["verdict"];
    EXPECT_EQ(told["step_change"]["stick"], 0.02);
    EXPECT_EQ(told["judged_step_change"]["slip"], 0.04);
    EXPECT_EQ(document["engine"]["compared_step"], 2e-6);
    EXPECT_EQ(document["units"]["engine.compared_step"], "s");
    EXPECT_EQ(document["units"]["phases.verdict.judged_step_change"], "1");
}

TEST(SimulationJson, GivesEveryThresholdWithItsDistance) {
    const Json margins = simulation_document()["phases"][0]["verdict"]["margins"];
    ASSERT_FALSE(margins.empty());
    EXPECT_EQ(margins[0]["threshold"], "quiet_slip");
    EXPECT_EQ(margins[0]["value"].get<double>() - margins[0]["threshold_value"].get<double>(),
              margins[0]["distance"].get<double>());
}

TEST(SimulationJson, KeepsEveryBitOfANumberAndMakesNanNull) {
    const Json document = simulation_document();
    EXPECT_EQ(document["energy"]["drive_work"].get<double>(), 0.1 + 0.2);
    const Json& verdict = document["phases"][0]["verdict"];
    EXPECT_EQ(verdict["levels"]["joint"]["rms"].get<double>(), 5e-324);
    EXPECT_EQ(verdict["levels"]["joint"]["peak"].get<double>(), 1.0 / 3.0);
    EXPECT_TRUE(verdict["levels"]["joint"]["level"].is_null());
    EXPECT_TRUE(verdict["regularity"].is_null());
}

TEST(SimulationJson, StatesTheUnitOfEveryQuantity) {
    const Json units = simulation_document()["units"];
    EXPECT_EQ(units["case.contact.preload"], "N");
    EXPECT_EQ(units["energy"], "J");
    EXPECT_EQ(units["phases.verdict.levels.level"], "dB re 1e-9 m/s");
}

TEST(SimulationJson, SurvivesATitleThatIsNotText) {
    parameters::Case c;
    c.title = "\xff\xfe";
    EXPECT_TRUE(Json::accept(case_json(c)));
}

TEST(StabilityJson, HoldsDirectionsModesAndBoundaries) {
    analysis::StabilityScan scan;
    scan.base = parameters::paper_case(parameters::PaperCase::squeal);
    scan.key = "contact.kinetic_friction";
    scan.unit = "1";
    analysis::DirectionScan direction;
    direction.direction = parameters::Direction::coming;
    direction.here.kind = analysis::StabilityKind::flutter;
    direction.here.modes = {{-1.0, 400.0}, {700.0, 592.0}};
    direction.path.points = {{0.1, direction.here}};
    direction.path.boundaries = {{0.449, analysis::StabilityKind::stable, analysis::StabilityKind::flutter, 607.0}};
    scan.directions = {direction};
    const Json document = Json::parse(stability_json(scan));
    EXPECT_EQ(document["schema"], "stridor.stability/1");
    EXPECT_EQ(document["over"]["parameter"], "contact.kinetic_friction");
    const Json& coming = document["directions"][0];
    EXPECT_EQ(coming["direction"], "coming");
    EXPECT_EQ(coming["kind"], "flutter");
    EXPECT_EQ(coming["modes"][1]["frequency"], 592.0);
    EXPECT_EQ(coming["points"][0]["value"], 0.1);
    EXPECT_EQ(coming["boundaries"][0]["above"], "flutter");
}

TEST(StabilityJson, HoldsWhatModesAreMadeOfWhereItIsAskedFor) {
    const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    const analysis::StabilityScan plain = analysis::scan_stability(c, std::nullopt);
    EXPECT_FALSE(Json::parse(stability_json(plain))["directions"][0].contains("contributions"));
    const Json document = Json::parse(stability_json(analysis::with_modes(plain)));
    const Json& going = document["directions"][0];
    ASSERT_EQ(going["contributions"].size(), 1U) << "one mode grows";
    const Json& mode = going["contributions"][0];
    EXPECT_NEAR(mode["growth"].get<double>(), going["growth"].get<double>(), 1e-6);
    EXPECT_EQ(mode["contacts"][0]["name"], "joint");
    EXPECT_NEAR(mode["contacts"][0]["growth"].get<double>() + mode["damping_growth"].get<double>(),
                mode["growth"].get<double>(), 1e-6);
    EXPECT_GT(mode["free_modes"][0]["energy_share"], mode["free_modes"][1]["energy_share"]);
    EXPECT_EQ(mode["shape"].size(), 3U);
    EXPECT_EQ(mode["shape"][2]["name"], "y2");
    EXPECT_EQ(document["units"]["directions.contributions.growth"], "1/s");
    // sliding that locks has no modes to tell of
    parameters::Case locked = c;
    locked.contact().static_friction = locked.contact().kinetic_friction = 4.5;
    const Json none = Json::parse(stability_json(analysis::with_modes(analysis::scan_stability(locked, std::nullopt))));
    EXPECT_EQ(none["directions"][0]["kind"], "locked");
    EXPECT_TRUE(none["directions"][0]["contributions"].empty());
}

TEST(ChartJson, HoldsAnArrayPerFigure) {
    const sweep::SweepResult chart = small_chart();
    const Json document = Json::parse(chart_json(chart));
    EXPECT_EQ(document["schema"], "stridor.chart/1");
    EXPECT_EQ(document["chart"]["x"]["parameter"], "contact.preload");
    EXPECT_EQ(document["chart"]["x"]["unit"], "N");
    EXPECT_EQ(document["chart"]["x"]["values"].size(), 4U);
    EXPECT_EQ(document["shape"]["y"], 3);
    const Json& cells = document["cells"];
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        EXPECT_EQ(cells[std::string(figure.name)].size(), chart.cells.size()) << figure.name;
    EXPECT_EQ(cells["status"][0], "done");
    EXPECT_EQ(cells["category"][5], "squeal");
    EXPECT_EQ(cells["slip"][5].get<double>(), figure_of(sweep::computed_cell(chart, 5), "slip"));
    EXPECT_TRUE(cells["frequency"][5].is_null());
    EXPECT_TRUE(cells["category"][6].is_null());
    EXPECT_EQ(cells["message"][6], "cell \"6\", not done");
}

TEST(ChartJson, TellsWhatWasInferred) {
    const Json document = Json::parse(chart_json(refined_chart()));
    EXPECT_EQ(document["chart"]["refine"], 1);
    EXPECT_EQ(document["cells"]["source"][0], "computed");
    EXPECT_EQ(document["cells"]["source"][1], "inferred");
    EXPECT_EQ(document["cells"]["category"][1], "none");
    EXPECT_TRUE(document["cells"]["slip"][1].is_null());
}

TEST(ChartJson, HasTheVerdictOfEachStart) {
    EXPECT_FALSE(Json::parse(chart_json(small_chart()))["cells"].contains("starts"));
    const Json document = Json::parse(chart_json(chart_of_starts()));
    EXPECT_EQ(document["chart"]["starts"], (Json{"rest", "sliding"}));
    EXPECT_EQ(document["cells"]["agreement"][5], "quiet_unless_disturbed");
    EXPECT_EQ(document["cells"]["starts"]["rest"][5], "none");
    EXPECT_EQ(document["cells"]["starts"]["sliding"][5], "squeal");
}

TEST(ChartJson, HasTheLinesBetweenTheCategories) {
    const sweep::SweepResult chart = small_chart();
    const std::vector<sweep::Boundary> boundaries = sweep::boundaries(chart);
    const Json array = Json::parse(chart_json(chart))["boundaries"];
    ASSERT_EQ(array.size(), boundaries.size());
    for (std::size_t k = 0; k < boundaries.size(); ++k) {
        EXPECT_EQ(array[k]["between"][1], boundaries[k].second);
        EXPECT_EQ(array[k]["x"].size(), boundaries[k].vertices.size());
        EXPECT_EQ(array[k]["x_resolution"][0].get<double>(), boundaries[k].vertices[0].x_resolution);
    }
}

}  // namespace
}  // namespace stridor::io
