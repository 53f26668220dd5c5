#include "stridor/io/case/toml_writer.hpp"

#include "io_support.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace stridor::io {
namespace {

using parameters::Case;
using parameters::Field;
using parameters::Quantity;

// a value with 53 random bits, within its range, of any size
double random_value(const Quantity& quantity) {
    const double fraction = *support::signed_fraction();
    if (std::isfinite(quantity.range.low) && std::isfinite(quantity.range.high))
        return std::clamp(quantity.range.low + std::abs(fraction) * (quantity.range.high - quantity.range.low),
                          quantity.range.low, quantity.range.high);
    const double value = fraction * std::pow(10.0, *support::whole_between(-12, 12));
    return quantity.range.low == 0.0 ? std::abs(value) + 1e-15 : value;
}

// any values at all, then those that must fit together are made to
Case random_case() {
    Case c;
    for (const Field& field : parameters::fields()) {
        if (const auto* choice = std::get_if<parameters::Choice>(&field.kind))
            choice->set(c, *support::whole_between(0, static_cast<int>(choice->names.size()) - 1));
        // without a table there is no temperature
        const auto* quantity = std::get_if<Quantity>(&field.kind);
        if (quantity != nullptr && field.section != "temperature") quantity->set(c, random_value(*quantity));
    }
    if (c.drive.kind == parameters::DriveKind::sampled) c.drive.kind = parameters::DriveKind::constant;
    c.contact().friction_table = {"", {0.0, 0.05, 1e9}, std::vector<double>(3, 0.5 * c.contact().static_friction)};
    c.joint().axial_force = {"", {0.0, 1.0}, {0.0, 1e6}};
    c.contact().kinetic_friction = c.contact().static_friction * 0.7;
    c.contact().kinetic_friction_coming = c.contact().static_friction_coming * 0.7;
    c.drive.ramp = 0.1 / c.drive.frequency;
    c.run.duration = 0.3 + 6.0 / c.drive.frequency;  // a third of it holds one and a half periods
    c.run.window = c.run.duration / 3.0;
    c.run.step = c.run.duration / 7e5;
    if (c.drive.velocity == 0.0) c.drive.velocity = 0.1;
    if (!parameters::is_state_wise(c.contact().friction)) c.run.engine = parameters::Engine::moreau;
    const bool creeps = parameters::has_friction_state(c.contact().friction);
    if (creeps) c.run.engine = parameters::Engine::exact;
    if (c.run.engine != parameters::Engine::exact) c.joint().stiffening = parameters::Stiffening::none;
    if (creeps) c.contact().stribeck_exponent = std::floor(c.contact().stribeck_exponent);
    if (creeps || c.run.engine == parameters::Engine::moreau) c.contact().impact = parameters::ImpactKind::plastic;
    c.run.formulation = parameters::Formulation::standard;  // a joint has inertia
    c.verdict.settling *= 0.4;
    c.verdict.reversal *= 0.4;
    c.verdict.squeal_beats = std::floor(c.verdict.squeal_beats);
    c.title = *rc::gen::container<std::string>(rc::gen::inRange('\x01', '\x7f'));
    return c;
}

RC_GTEST_PROP(TomlWriter, WritesCasesThatReadBackTheSame, ()) {
    const Case c = random_case();
    RC_PRE(parameters::findings(c).empty());
    const Comments comments = *rc::gen::element(Comments::none, Comments::full);
    const Case back = read_case(TomlSource{case_toml(c, {.comments = comments, .heading = "a\n\nb"}), "back.toml", {}});
    RC_ASSERT(parameters::canonical_text(back) == parameters::canonical_text(c));
    RC_ASSERT(back.title == c.title);
}

RC_GTEST_PROP(TomlWriter, WritesChartsThatReadBackTheSame, ()) {
    sweep::Study study = sweep::figure_8();
    study.x.from = 1.0 + *support::signed_fraction();
    study.x.to = 1e4 * (2.0 + *support::signed_fraction());
    study.x.points = *support::whole_between(2, 100);
    study.y.to = 0.4 * (1.0 + *support::signed_fraction());
    study.y.from = 0.5 * study.y.to;
    RC_PRE(study.y.to > study.y.from);
    if (*rc::gen::arbitrary<bool>()) study.directions.pop_back();
    study.quantities = {"slip", "category"};
    study.refine = *support::whole_between(0, sweep::most_refinement);
    if (*rc::gen::arbitrary<bool>()) study.starts = {parameters::Initial::stuck, parameters::Initial::rest};
    const sweep::Study back = read_study(TomlSource{study_toml(study), "back.toml", {}});
    RC_ASSERT(sweep::canonical_text(back) == sweep::canonical_text(study));
    RC_ASSERT(parameters::canonical_text(back.base) == parameters::canonical_text(study.base));
    RC_ASSERT(back.quantities == study.quantities);
    RC_ASSERT(back.starts == study.starts);
}

TEST(TomlWriter, WritesThePapersCasesAndCharts) {
    for (const auto which : {parameters::PaperCase::squeal, parameters::PaperCase::squeak, parameters::PaperCase::creak,
                             parameters::PaperCase::quiet}) {
        const Case c = parameters::paper_case(which);
        const Case back = read_case(TomlSource{case_toml(c), "back.toml", {}});
        EXPECT_EQ(parameters::canonical_text(back), parameters::canonical_text(c));
        EXPECT_EQ(back.title, c.title);
    }
    for (const sweep::Study& study : {sweep::figure_8(), sweep::figure_6(70.0), sweep::figure_6(150.0)})
        EXPECT_EQ(sweep::canonical_text(read_study(TomlSource{study_toml(study), "back.toml", {}})),
                  sweep::canonical_text(study));
}

TEST(TomlWriter, ExplainsEveryKeyWithSymbolUnitAndRange) {
    const std::string text = case_toml(parameters::paper_case(parameters::PaperCase::squeal));
    const std::string unfolded = std::regex_replace(text, std::regex("\n#   "), " ");
    for (const Field& field : parameters::fields())
        EXPECT_EQ(text.find("# " + std::string(field.sentence)) != std::string::npos, field.belongs(parameters::Case{}))
            << field.name;
    for (const Field& field : parameters::fields()) {
        const bool has_home =
            field.belongs(parameters::Case{}) || !parameters::home_of(parameters::Case{}, field).empty();
        EXPECT_EQ(unfolded.find(std::string(field.sentence)) != std::string::npos, has_home) << field.name;
    }
    EXPECT_NE(text.find("# mass of the joint (m1) [kg, above 0]\nmass = \"0.1 kg\"\n"), std::string::npos) << text;
    EXPECT_NE(text.find("# how the motion starts: \"rest\", \"stuck\", \"sliding\" or \"given\"\n"), std::string::npos)
        << text;
}

// one letter less makes a key of another kind, a few more comment out those of this one
TEST(TomlWriter, ShowsTheKeysOfOtherKindsReadyToBeUncommented) {
    const std::string text = case_toml(parameters::paper_case(parameters::PaperCase::squeal));
    EXPECT_NE(text.find("# with drive.kind = \"constant\" or \"trapezoidal\": velocity of the plate; going if "
                        "positive, coming if negative (V)\n#   [m/s, not 0]\n#velocity = \"0.1 m/s\"\n"),
              std::string::npos)
        << text;
    const std::string constant = replaced(replaced(text, "kind = \"sinusoidal\"", "kind = \"constant\""),
                                          "#velocity = \"0.1", "velocity = \"0.3");
    EXPECT_EQ(read_case(TomlSource{constant, "constant.toml", {}}).drive.velocity, 0.3);
    const std::string stepped = replaced(replaced(text, "engine = \"exact\"", "engine = \"beta_2\""), "#step", "step");
    EXPECT_EQ(read_case(TomlSource{stepped, "stepped.toml", {}}).run.step, 1e-7);
}

TEST(TomlWriter, WritesDampingRatiosThatReadBackTheSame) {
    const std::string text = replaced(squeal_toml(), "axial_damping = \"1 N*s/m\"", "axial_damping = \"15 %\"");
    const Case c = read_case(TomlSource{text, "case.toml", {}});
    EXPECT_EQ(c.joint().axial_damping, 2.0 * 0.15 * std::sqrt(1e7 * 0.1));
    EXPECT_NE(case_toml(c).find("axial_damping = \"damping ratio 0.15\"\n"), std::string::npos);
    const Case back = read_case(TomlSource{case_toml(c), "back.toml", {}});
    EXPECT_EQ(back.joint().axial_damping, c.joint().axial_damping);
    EXPECT_EQ(parameters::canonical_text(back), parameters::canonical_text(c));
    // an override of the stiffness keeps the ratio, as an axis of a chart does
    EXPECT_EQ(read_case(TomlSource{text, "case.toml", {"k1i=4e6"}}).joint().axial_damping,
              2.0 * 0.15 * std::sqrt(4e6 * 0.1));
}

TEST(TomlWriter, WritesNoLineBeyond120Columns) {
    std::istringstream lines(case_toml({}, {Comments::full, ""}));
    std::size_t comments = 0;
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(base::character_count(line), 120U) << line;
        if (line.starts_with("#   ")) ++comments;
    }
    EXPECT_GT(comments, 0U);  // of lines that were broken
}

TEST(TomlWriter, PutsTheHeadingOnTop) {
    const Case c;
    EXPECT_TRUE(case_toml(c, {.comments = Comments::none, .heading = "one\n\ntwo"}).starts_with("# one\n#\n# two\n\n"));
}

}  // namespace
}  // namespace stridor::io
