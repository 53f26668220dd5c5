#include "stridor/base/text.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/report/design_report.hpp"
#include "stridor/report/design_results.hpp"
#include "stridor/report/structure_sketch.hpp"
#include "stridor/report/timed_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace stridor::report {
namespace {

using parameters::Case;

Case chain(std::vector<std::string> overrides = {}) {
    for (const char* shorter : {"run.duration=20", "run.window=10"})
        overrides.emplace_back(shorter);
    return io::read_case({io::ready_file("chain"), "chain.toml", overrides});
}

const Section* section_named(const Report& report, const std::string& heading) {
    const auto found = std::find_if(report.sections.begin(), report.sections.end(),
                                    [&](const Section& section) { return section.heading == heading; });
    return found == report.sections.end() ? nullptr : &*found;
}

TEST(DesignReport, ShowsEachContactOfAnOwnStructure) {
    DesignResults results = basic_results(chain(), {});
    add_sounds(results, {}, PartTime(1e6));
    const Report report = design_report(results);
    const Section* contacts = section_named(report, "Each contact");
    ASSERT_NE(contacts, nullptr);
    ASSERT_EQ(contacts->table.rows.size(), 4U) << "each way";
    EXPECT_EQ(contacts->table.rows[0][1], "going");
    EXPECT_EQ(contacts->table.rows[3][1], "coming");
    EXPECT_EQ(contacts->table.rows[0].size(), contacts->table.columns.size());
    EXPECT_EQ(contacts->table.rows[1].front(), "block2");
    EXPECT_EQ(contacts->table.rows[1][7], "1 N") << "half of the preload";
    EXPECT_EQ(contacts->paragraphs.size(), 2U) << "they are one interface, each way";
    ASSERT_NE(section_named(report, "Motion while coming"), nullptr);
    EXPECT_NE(section_named(report, "Motion while coming")->svg.find("<svg"), std::string::npos);
    EXPECT_NE(report.sketch.find("block2"), std::string::npos);
    EXPECT_EQ(report.sketch.find("incidence"), std::string::npos);
    EXPECT_NE(section_named(report, "Stability of steady sliding"), nullptr);
    const Section* sound = section_named(report, "What it sounds like");
    ASSERT_NE(sound, nullptr);
    EXPECT_NE(sound->paragraphs.front().find("block1 velocity along x"), std::string::npos);
    // the case in it is the case
    const Case back = io::read_case({section_named(report, "The case")->file.saved, "case.toml", {}});
    EXPECT_EQ(parameters::canonical_text(back), parameters::canonical_text(results.design));
}

TEST(DesignReport, ShowsEachOfSeveralJoints) {
    Case c = io::read_case({io::ready_file("two-lips"), "two.toml", {"run.duration=0.3", "run.window=0.3"}});
    const Report report = design_report(basic_results(c, {}));
    const Section* contacts = section_named(report, "Each contact");
    ASSERT_NE(contacts, nullptr);
    EXPECT_EQ(contacts->table.rows.size(), 4U) << "each way";
    EXPECT_EQ(
        section_named(design_report(basic_results(io::read_case({io::ready_file("squeal"), "squeal.toml", {}}), {})),
                      "Each contact"),
        nullptr);
}

// it locks where it goes and squeals where it comes; its file has the first as velocity
TEST(DesignReport, IsOfBothDirectionsOfAConstantDrive) {
    const io::TomlSource source{io::ready_file("weatherstrip"), "seal.toml", {}};
    const Case c = io::read_case(source);
    DesignResults results = basic_results(c, {});
    add_sounds(results, {}, PartTime(1e6));
    EXPECT_EQ(headline(results), "locks while going, squeals while coming");
    ASSERT_EQ(results.verdicts.size(), 2U);
    EXPECT_EQ(results.verdicts[1].category, classification::Category::squeal);
    EXPECT_NEAR(results.verdicts[1].evidence.alternation.frequency, 262.6, 0.1);
    EXPECT_EQ(results.sounds.size(), 2U);
    const Report report = design_report(results);
    EXPECT_EQ(report.headline, "L" + headline(results).substr(1));
    EXPECT_NE(report.lead.at(1).find("While the surface is coming (V < 0) the contact squeals"), std::string::npos);
    EXPECT_EQ(report.badges.at(1).word, "squeal");
    const sweep::Study study = chart_to_report(source, c, {}, 8);
    EXPECT_EQ(study.directions.size(), 2U);
    EXPECT_EQ(study.starts, advice::starts_of(results.standing.space));
}

TEST(DesignReport, OfOneDirectionSaysThatAlone) {
    advice::AdviceOptions options;
    options.runs.directions = {parameters::Direction::going};
    const DesignResults results =
        basic_results(io::read_case({io::ready_file("weatherstrip"), "seal.toml", {}}), options);
    EXPECT_EQ(results.verdicts.size(), 1U);
    EXPECT_EQ(headline(results).find("coming"), std::string::npos);
}

TEST(DesignReport, SaysWhyAPartIsMissing) {
    EXPECT_EQ(reason_of(Error(ErrorKind::input, {"this cannot be done", "it is too soft", "Use steel."})),
              "This cannot be done (it is too soft).")
        << "what would mend another thing is no help";
    EXPECT_THROW(reason_of(Error(ErrorKind::interrupted, {"stopped", "", ""})), Error);
    DesignResults results = basic_results(chain(), {});
    results.stability.reset();
    results.without_stability = "Not today.";
    results.advice_time = PartTime(60.0);
    const Report report = design_report(results);
    EXPECT_EQ(section_named(report, "Stability of steady sliding")->paragraphs.front(), "Not today.");
    EXPECT_NE(report.badges.front().more.find("was not found within 60"), std::string::npos)
        << report.badges.front().more;
}

TEST(DesignReport, ExplainsWhyMotionAndEarDiffer) {
    DesignResults results = basic_results(chain(), {});
    for (const parameters::Direction direction : {parameters::Direction::going, parameters::Direction::coming}) {
        DesignSound sound{direction, {}, "RIFF"};
        sound.heard.category = direction == parameters::Direction::going ? results.verdicts.front().category
                                                                         : classification::Category::squeak;
        results.sounds.push_back(sound);
    }
    ASSERT_NE(results.verdicts.at(1).category, classification::Category::squeak);
    const Report report = design_report(results);
    const HtmlTable& both = section_named(report, "What it sounds like")->table;
    ASSERT_EQ(both.rows.size(), 1U) << "where they agree there is nothing to explain";
    EXPECT_EQ(both.rows[0][0], "coming");
    EXPECT_EQ(both.columns[1], "by the motion: this counts");
    EXPECT_EQ(both.rows[0][2], "By ear: squeak.");
}

TEST(ChartToReport, IsOverTheStiffnessWhereALoadPresses) {
    const std::string text =
        "[structure]\nrows = [\"x\", \"y\"]\nmass = [[1, 0], [0, 1]]\nstiffness = [[1e6, 0], [0, 1e6]]\n"
        "load = [0, -5]\n[[structure.contact]]\nname = \"foot\"\nnormal = \"y\"\ntangent = \"x\"\n"
        "[contact]\nstatic_friction = 0.8\nkinetic_friction = 0.3\n"
        "[drive]\nkind = \"constant\"\nvelocity = 0.02\n";
    const io::TomlSource source{text, "own.toml", {}};
    const sweep::Study study = chart_to_report(source, io::read_case(source), {}, 12);
    EXPECT_EQ(study.x.parameter, "structure.stiffness_scale");
    EXPECT_EQ(study.y.parameter, "contact.kinetic_friction");
}

TEST(StructureSketch, DrawsSomeOfManyContacts) {
    Case c = chain();
    auto own = std::make_shared<parameters::OwnStructure>(*c.own_structure);
    own->contacts.resize(40, own->contacts.front());
    for (std::size_t k = 0; k < own->contacts.size(); ++k)
        own->contacts[k].name = "node<" + std::to_string(k) + "äöüß";
    c.own_structure = own;
    const std::string svg = structure_sketch_svg(c);
    EXPECT_NE(svg.find("40 contacts"), std::string::npos);
    EXPECT_EQ(svg.find("node<"), std::string::npos) << "names are text, not markup";
    std::size_t feet = 0;
    for (std::size_t at = svg.find("<path d=\"M"); at != std::string::npos; at = svg.find("<path d=\"M", at + 1))
        ++feet;
    EXPECT_LE(feet, 11U) << "with two arrows";
    EXPECT_EQ(base::character_count(svg) > 0, true);
}

}  // namespace
}  // namespace stridor::report
