#include "stridor/io/chart/toml_study.hpp"

#include "io_support.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <gtest/gtest.h>

namespace stridor::io {
namespace {

using sweep::Study;

constexpr const char* axes =
    "[chart]\n"
    "x = { parameter = \"contact.preload\", from = \"1 N\", to = \"3 kN\", points = 40, scale = \"log\" }\n"
    "y = { parameter = \"contact.kinetic_friction\", from = 0.1, to = 0.8, points = 8 }\n";

Study read_chart(const std::string& chart, std::vector<std::string> overrides = {}) {
    return read_study(
        TomlSource{chart + squeal_toml().substr(squeal_toml().find('[')), "chart.toml", std::move(overrides)});
}

std::optional<Error> chart_refusal(const std::string& chart, std::vector<std::string> overrides = {}) {
    const auto error = error_of([&] { read_chart(chart, std::move(overrides)); });
    EXPECT_TRUE(!error || error->kind() == ErrorKind::input) << error->what();
    return error;
}

std::optional<Error> chart_refusal_with(const std::string& from, const std::string& to) {
    return chart_refusal(replaced(axes, from, to));
}

TEST(TomlStudy, ReadsAxesInTheUnitOfTheirParameter) {
    const Study study = read_chart(axes);
    EXPECT_EQ(study.x.parameter, "contact.preload");
    EXPECT_EQ(study.x.from, 1.0);
    EXPECT_EQ(study.x.to, 3000.0);
    EXPECT_EQ(study.x.points, 40);
    EXPECT_EQ(study.x.scale, sweep::Scale::logarithmic);
    EXPECT_EQ(study.y.points, 8);
    EXPECT_EQ(study.y.scale, sweep::Scale::linear);
    EXPECT_EQ(study.directions.size(), 2U);
    EXPECT_EQ(study.quantities, std::vector<std::string>{"category"});
}

TEST(TomlStudy, ReadsDirectionsAndQuantities) {
    const std::string text(axes);
    const Study study = read_chart(text + "directions = [\"coming\"]\nquantities = [\"slip\", \"category\"]\n");
    EXPECT_EQ(study.directions, std::vector{parameters::Direction::coming});
    EXPECT_EQ(study.quantities, (std::vector<std::string>{"slip", "category"}));
}

TEST(TomlStudy, ReadsRefinementAndStarts) {
    EXPECT_EQ(read_chart(axes).refine, 0);
    EXPECT_TRUE(read_chart(axes).starts.empty());
    const Study study = read_chart(std::string(axes) + "refine = 3\nstarts = [\"sliding\", \"rest\"]\n");
    EXPECT_EQ(study.refine, 3);
    EXPECT_EQ(study.starts, (std::vector{parameters::Initial::sliding, parameters::Initial::rest}));
    const Study overridden = read_chart(axes, {"chart.refine=2", "chart.starts=rest,stuck"});
    EXPECT_EQ(overridden.refine, 2);
    EXPECT_EQ(overridden.starts, (std::vector{parameters::Initial::rest, parameters::Initial::stuck}));
}

TEST(TomlStudy, PointsAtWrongRefinementAndStarts) {
    const std::string text(axes);
    expect_error(chart_refusal(text + "refine = 7\n"), "chart.refine = 7 is not a number of halvings",
                 "chart.toml:4:10");
    expect_error(chart_refusal(text + "refine = 1.5\n"), "it must be a whole number up to 6", "chart.toml:4:10");
    expect_error(chart_refusal(text + "refine = \"fine\"\n"), "chart.refine", "chart.toml:4:10");
    expect_error(chart_refusal(text + "starts = [\"slide\"]\n"), "choices: \"rest\", \"stuck\", \"sliding\"",
                 "chart.toml:4:10");
    expect_error(chart_refusal(text + "starts = [\"rest\", \"rest\"]\n"), "chart.starts names \"rest\" twice",
                 "chart.toml:4:10");
}

TEST(TomlStudy, TakesSectionsInsteadOfInlineTables) {
    const Study study = read_chart(
        "[chart.x]\nparameter = \"contact.preload\"\nfrom = 1\nto = 2\npoints = 3\n"
        "[chart.y]\nparameter = \"joint.incidence_angle\"\nfrom = \"0 deg\"\nto = 90\npoints = 2\n");
    EXPECT_EQ(study.x.points, 3);
    EXPECT_EQ(study.y.to, 90.0);
}

TEST(TomlStudy, IsOverriddenKeyByKey) {
    const Study study = read_chart(axes, {"chart.x.points=5", "chart.x.to=0.1 kN", "chart.y.scale=log",
                                          "chart.directions=going", "chart.quantities=[\"slip\", \"stick\"]"});
    EXPECT_EQ(study.x.points, 5);
    EXPECT_EQ(study.x.to, 100.0);
    EXPECT_EQ(study.y.scale, sweep::Scale::logarithmic);
    EXPECT_EQ(study.directions, std::vector{parameters::Direction::going});
    EXPECT_EQ(study.quantities, (std::vector<std::string>{"slip", "stick"}));
    EXPECT_EQ(read_chart(axes, {"chart.y.parameter=plate.mass", "chart.y.to=300 g"}).y.parameter, "plate.mass");
}

TEST(TomlStudy, MayHaveBaseValuesThatItsAxesReplace) {
    // mu_d of the file is above mu_s, but the axis ends below
    const Study study = read_chart(axes, {"contact.kinetic_friction=0.85"});
    EXPECT_EQ(study.base.contact().kinetic_friction, 0.85);
    expect_error(chart_refusal(axes, {"run.window=2"}), "run.window = 2 s is longer", "--set");
}

TEST(TomlStudy, SuggestsAChartWhereThereIsNone) {
    expect_error(chart_refusal(""), "there is no section [chart]", "chart.toml");
    EXPECT_NE(chart_refusal("")->problem().suggestion.find("stridor init noise-chart"), std::string::npos);
}

TEST(TomlStudy, ListsWhatAnAxisLacks) {
    expect_error(chart_refusal_with(", points = 8", ""), "missing in [chart]: chart.y.points", "chart.toml:1:2");
    expect_error(chart_refusal("[chart]\n"),
                 "missing in [chart]: chart.x.parameter, chart.x.from, chart.x.to, chart.x.points", "chart.toml:1:2");
}

TEST(TomlStudy, WithoutAYAxisIsADiagramOverXAlone) {
    const std::string text(axes);
    const Study study = read_chart(text.substr(0, text.find("y = ")));
    EXPECT_TRUE(sweep::has_one_axis(study));
    EXPECT_EQ(study.x.parameter, "contact.preload");
    EXPECT_EQ(study.y.parameter, "contact.kinetic_friction");
    EXPECT_EQ(study.y.from, study.base.contact().kinetic_friction);
    EXPECT_EQ(sweep::cell_count(study), 80U);
    const Study back = read_study(TomlSource{study_toml(study), "back.toml", {}});
    EXPECT_EQ(sweep::canonical_text(back), sweep::canonical_text(study));
}

TEST(TomlStudy, AxesGivenBesideItTakeThePlaceOfTheFiles) {
    const TomlSource source{axes + squeal_toml().substr(squeal_toml().find('[')), "chart.toml", {}};
    const Study both = read_study(source, {"incidence_angle=20:80 deg:7", "preload=1:4"});
    EXPECT_EQ(both.x.parameter, "joint.incidence_angle");
    EXPECT_EQ(both.x.points, 7);
    EXPECT_EQ(both.y.points, usual_points);
    EXPECT_EQ(both.y.scale, sweep::Scale::logarithmic) << "as usual for the preload";
    const Study beside = read_study(source, {"", "incidence_angle=20:80"});
    EXPECT_EQ(beside.x.parameter, "contact.preload");
    EXPECT_EQ(beside.y.parameter, "joint.incidence_angle");
    const Study alone = read_study(source, {"mu_d=0.2:0.6", ""});
    EXPECT_TRUE(sweep::has_one_axis(alone));
    EXPECT_EQ(alone.x.points, usual_points_alone);
    EXPECT_EQ(alone.y.parameter, "contact.preload");
}

TEST(TomlStudy, AUnitAtTheLastEndIsThatOfBoth) {
    const TomlSource source{axes + squeal_toml().substr(squeal_toml().find('[')), "chart.toml", {}};
    const Study study = read_study(source, {"preload=0.1:2 kN", "mu_d=20:60 %"});
    EXPECT_EQ(study.x.from, 100.0);
    EXPECT_EQ(study.x.to, 2000.0);
    EXPECT_EQ(study.y.from, 0.2);
    EXPECT_EQ(study.y.to, 0.6);
}

TEST(TomlStudy, PointsAtWhatAnAxisGetsWrong) {
    expect_error(chart_refusal_with("contact.preload", "contact.prelaod"), "Did you mean contact.preload?",
                 "chart.toml:2:19");
    expect_error(chart_refusal_with("contact.preload", "drive.kind"),
                 "chart.x.parameter = \"drive.kind\" is no quantity", "chart.toml:2:19");
    expect_error(chart_refusal_with("contact.kinetic_friction", "drive.velocity"), "changes nothing",
                 "chart.toml:3:19");
    expect_error(chart_refusal_with("\"1 N\"", "\"1 mm\""),
                 "chart.x.from = \"1 mm\" is a length (m) (expected a force (N))", "chart.toml:2:45");
    expect_error(chart_refusal_with("\"1 N\"", "0"), "chart.x.from", "chart.toml:2:45");
    expect_error(chart_refusal_with("to = 0.8", "to = -1"), "chart.y.to: contact.kinetic_friction = -1 is out of range",
                 "chart.toml:3:64");
    expect_error(chart_refusal_with("points = 8", "points = 1"), "chart.y.points = 1", "chart.toml:3:78");
    expect_error(chart_refusal_with("points = 8", "points = 2.5"), "must be a whole number", "chart.toml:3:78");
    expect_error(chart_refusal_with("points = 8", "points = 1e300"), "must be a whole number", "chart.toml:3:78");
    expect_error(chart_refusal_with("points = 8", "points = true"), "chart.y.points is a boolean", "chart.toml:3:78");
    expect_error(chart_refusal_with("\"log\"", "\"lg\""), "Did you mean \"log\"?", "chart.toml:2:86");
    expect_error(chart_refusal_with("scale", "scael"), "unknown key chart.x.scael. Did you mean chart.x.scale?",
                 "chart.toml:2:78");
    expect_error(chart_refusal_with("contact.kinetic_friction", "contact.preload"), "chart.x and chart.y are both",
                 "chart.toml:2:5");
    expect_error(chart_refusal("[chart]\nx = 5\n"), "chart.x is a number (expected an axis", "chart.toml:2:5");
}

TEST(TomlStudy, TakesAxesInAnySpellingAndKeepsTheFullKey) {
    const Study study =
        read_chart(replaced(replaced(axes, "contact.preload", "F"), "contact.kinetic_friction", "mu_d"));
    EXPECT_EQ(study.x.parameter, "contact.preload");
    EXPECT_EQ(study.y.parameter, "contact.kinetic_friction");
    EXPECT_EQ(sweep::canonical_text(study), sweep::canonical_text(read_chart(axes)));
    EXPECT_EQ(study_toml(study), study_toml(read_chart(axes)));
    EXPECT_EQ(sweep::canonical_text(read_chart(axes, {"mu_s=0.9", "chart.x.parameter=preload"})),
              sweep::canonical_text(read_chart(axes, {"contact.static_friction=0.9"})));
    expect_error(chart_refusal_with("contact.preload", "mass"), "Write joint.mass or plate.mass.", "chart.toml:2:19");
}

TEST(TomlStudy, TellsAllThatIsWrongAtOnce) {
    std::string text = replaced(axes, "contact.preload", "contact.prelaod");
    text = replaced(text, "points = 8", "points = 2.5");
    const auto error = chart_refusal(text + "directions = [\"gonig\"]\n", {"contact.preload=20 mm"});
    ASSERT_TRUE(error);
    EXPECT_EQ(error->complaints().size(), 4U) << error->what();
}

TEST(TomlStudy, PointsAtUnknownDirectionsAndQuantities) {
    const std::string text(axes);
    expect_error(chart_refusal(text + "directions = [\"gonig\"]\n"), "Did you mean \"going\"?", "chart.toml:4:14");
    expect_error(chart_refusal(text + "directions = []\n"), "chart.directions is empty", "chart.toml:4:14");
    expect_error(chart_refusal(text + "quantities = [\"slipp\"]\n"), "chart.quantities names \"slipp\"",
                 "chart.toml:4:14");
    expect_error(chart_refusal(text + "quantities = [5]\n"), "chart.quantities is a list of numbers",
                 "chart.toml:4:14");
    expect_error(chart_refusal(text + "colour = 1\n"), "unknown key chart.colour", "chart.toml:4:1");
}

TEST(TomlStudy, ReadsAFile) {
    const ScratchFolder scratch;
    storage::write_file((scratch / "c.toml").string(), study_toml(sweep::figure_8()));
    EXPECT_EQ(sweep::canonical_text(read_study((scratch / "c.toml").string())),
              sweep::canonical_text(sweep::figure_8()));
}

TEST(TomlStudy, OfSeveralJointsIsWrittenAsItIsRead) {
    const std::string two = case_toml(parameters::two_lips());
    const std::string chart =
        "[chart]\nx = { parameter = \"joint.lower.F\", from = \"20 N\", to = 400, points = 3 }\n"
        "y = { parameter = \"mu_d\", from = 0.1, to = 0.8, points = 4 }\n";
    const Study study = read_study(TomlSource{two + chart, "two.toml", {}});
    EXPECT_EQ(study.x.parameter, "joint.lower.contact.preload");
    EXPECT_EQ(study.y.parameter, "contact.kinetic_friction");
    ASSERT_EQ(study.base.joints.size(), 2U);
    const Study again = read_study(TomlSource{study_toml(study), "again.toml", {}});
    EXPECT_EQ(sweep::canonical_text(again), sweep::canonical_text(study));
    const auto error = error_of([&] {
        read_study(TomlSource{two + replaced(chart, "joint.lower.F", "joint.lowr.F"), "two.toml", {}});
    });
    ASSERT_TRUE(error);
    EXPECT_NE(std::string(error->what()).find("there is no joint \"lowr\""), std::string::npos) << error->what();
    ASSERT_TRUE(error->place());
    EXPECT_GT(error->place()->line, 1);
}

TEST(TomlStudy, OfSeveralJointsTakesAxesFromTheCommandLine) {
    const std::string two = case_toml(parameters::two_lips());
    const Study study =
        read_study(TomlSource{two, "two.toml", {}}, {"joint.upper.alpha=30:80:4", "joint.lower.F=20:400"});
    EXPECT_EQ(study.x.parameter, "joint.upper.incidence_angle");
    EXPECT_EQ(study.y.parameter, "joint.lower.contact.preload");
    EXPECT_EQ(study.y.scale, sweep::Scale::logarithmic);
    EXPECT_TRUE(error_of([&] { read_study(TomlSource{two, "two.toml", {}}, {"joint.third.F=20:400", ""}); }));
}

std::string chain_chart() {
    return ready_file("chain") + R"([chart]
x = { parameter = "structure.stiffness_scale", from = 0.5, to = 2, points = 3, scale = "log" }
y = { parameter = "contact.kinetic_friction", from = 0.2, to = 0.6, points = 2 }
)";
}

TEST(TomlStudy, TakesAnOwnStructure) {
    const Study study = read_study(TomlSource{chain_chart(), "c.toml", {}});
    const parameters::Case c = sweep::case_at(study, {0, 1, 2});
    EXPECT_EQ(c.structure_scales.stiffness, 2.0);
    EXPECT_EQ(c.contact().kinetic_friction, 0.6);
    const std::string text = sweep::canonical_text(study);
    EXPECT_NE(text.find("structure.content = " + content_hash(*study.base.own_structure)), std::string::npos);
    EXPECT_EQ(text.find("structure.stiffness_scale = "), std::string::npos) << "an axis says it";
    const Study back = read_study(TomlSource{study_toml(study), "back.toml", {}});
    EXPECT_EQ(sweep::canonical_text(back), text);
    EXPECT_TRUE(error_of([&] {
        read_study(TomlSource{chain_chart(), "c.toml", {}}, {"joint.mass=0.1:0.2", ""});
    })) << "it has no joint";
}

TEST(TomlStudy, RestsAtWhatAnOwnStructureHas) {
    const Study study = read_study(TomlSource{chain_chart(), "c.toml", {}}, {"preload=1:2:3", ""});
    EXPECT_EQ(study.y.parameter, "contact.kinetic_friction");
    EXPECT_TRUE(sweep::has_one_axis(study));
}

}  // namespace
}  // namespace stridor::io
