#include "stridor/explorer/page_file.hpp"

#include "stridor/base/json.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/base/version.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/body.hpp"
#include "stridor/explorer/first_answers.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <boost/beast/zlib/inflate_stream.hpp>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

namespace stridor::explorer {
namespace {

using support::thrown_by;

const std::string head = R"(<head></head><script type="application/json" id="stridor-case">)";
const std::string tail = "</script><p>";

TEST(PageFile, HoldsACaseAsTextThatIsNoMarkup) {
    const std::string hostile = "title = \"</script><script>alert(1)</script><!-- \\\\ \xC3\xA9\"\n";
    const std::string page = page_with_case(head + "null" + tail, {hostile});
    ASSERT_TRUE(page.starts_with(head));
    ASSERT_TRUE(page.ends_with(tail));
    const std::string inside = page.substr(head.size(), page.size() - head.size() - tail.size());
    EXPECT_EQ(inside.find('<'), inside.npos);
    EXPECT_EQ(base::Json::parse(inside).get<std::string>(), hostile);
}

TEST(PageFile, WithoutAPlaceForACaseIsDamaged) {
    EXPECT_EQ(thrown_by([] { page_with_case("<p>", {"a"}); }).kind, ErrorKind::io);
}

TEST(PageFile, IsFoundInABuildFolderAndWhereItWasInstalled) {
    const support::ScratchFolder folder;
    const auto write = [&](const std::string& place, const std::string& text) {
        std::filesystem::create_directories((folder / place).parent_path());
        std::ofstream(folder / place) << text;
    };
    EXPECT_TRUE(thrown_by([&] { one_file_page(folder / "bin/stridor"); }).says("no page in one file"));
    write("share/stridor/page.html", "installed");
    EXPECT_EQ(one_file_page(folder / "bin/stridor"), "installed");
    write("bin/page/page.html", "built");
    EXPECT_EQ(one_file_page(folder / "bin/stridor"), "built");
}

// what the page reads is the same case, bit for bit
TEST(PageFile, HasTheWholeCase) {
    for (const char* ready : {"squeal", "weatherstrip", "two-lips", "chain", "string", "wiper-wet"}) {
        const io::TomlSource source{io::ready_file(ready), "a.toml", {"contact.preload=3"}};
        const StandingCase standing = standing_alone(source);
        EXPECT_TRUE(standing.files.empty());
        const io::TomlDocument document = io::parse_toml({standing.toml, "b.toml", {}});
        EXPECT_EQ(parameters::canonical_text(io::read_case(document, io::readers_without_files())),
                  parameters::canonical_text(io::read_case(source)))
            << ready;
    }
}

TEST(PageFile, TakesTheSamplesOfADriveAlong) {
    const support::ScratchFolder folder;
    const std::string samples = "time [s],velocity [m/s]\n0,0.1\n5,0.1\n";
    std::ofstream(folder / "velocity.csv") << samples;
    const io::TomlSource source{io::ready_file("squeal"),
                                (folder / "a.toml").string(),
                                {"drive.kind=sampled", "drive.file=" + (folder / "velocity.csv").string()}};
    const StandingCase standing = standing_alone(source);
    EXPECT_EQ(standing.files, (std::map<std::string, std::string>{{"velocity.csv", samples}}));
    EXPECT_NE(standing.toml.find("file = \"velocity.csv\""), std::string::npos);
    const parameters::Case here = io::read_case({standing.toml, (folder / "b.toml").string(), {}});
    EXPECT_EQ(here.drive.times, io::read_case(source).drive.times);
    EXPECT_EQ(here.drive.velocities, io::read_case(source).drive.velocities);
    const std::string page = page_with_case(head + "null" + tail, standing);
    const base::Json held = base::Json::parse(page.substr(head.size(), page.size() - head.size() - tail.size()));
    EXPECT_EQ(held["toml"], standing.toml);
    EXPECT_EQ(held["files"]["velocity.csv"], base::base64(samples));
}

std::string place_of_answers(std::string_view commit) {
    return R"(<script type="text/plain" id="stridor-first" data-commit=")" + std::string(commit) + R"(">)";
}

// the answers as the page reads them; null: there are none
base::Json answers_in(const std::string& page) {
    const std::string place = place_of_answers(base::commit());
    const std::string letters = page.substr(place.size(), page.size() - place.size() - tail.size());
    EXPECT_EQ(page, place + letters + tail);
    if (letters.empty()) return nullptr;
    EXPECT_EQ(letters.find_first_of(std::string("<\r\0", 3)), letters.npos);
    std::string packed;
    for (std::size_t k = 0; k < letters.size(); ++k)
        packed += letters[k] == '=' ? static_cast<char>(letters[++k] - 64) : letters[k];
    std::string text(std::size_t{1} << 22U, '\0');
    boost::beast::zlib::z_params ends{packed.data(), packed.size(), 0, text.data(), text.size()};
    boost::beast::error_code error;
    boost::beast::zlib::inflate_stream().write(ends, boost::beast::zlib::Flush::sync, error);
    return base::Json::parse(text.substr(0, ends.total_out));
}

base::Json told(const base::Json& answers, const std::string& path) {
    for (const base::Json& one : answers)
        if (one["path"] == path) return one;
    return base::Json::object();
}

base::Json answers_with(const std::string& toml) {
    const StandingCase standing = standing_alone({toml, "a.toml", {}});
    return answers_in(page_with_first_answers(place_of_answers(base::commit()) + tail, &standing));
}

TEST(FirstAnswers, AreThoseOfThePapersSqueal) {
    const base::Json answers = answers_in(page_with_first_answers(place_of_answers(base::commit()) + tail, nullptr));
    const World world{paper_presets(), {}};
    const base::Json body{{"preset", "squeal"}, {"set", base::Json::array()}};
    EXPECT_EQ(told(answers, "/api/start").at("answer"), start(world).body);
    EXPECT_EQ(told(answers, "/api/simulate").at("body"), body);
    EXPECT_EQ(told(answers, "/api/simulate").at("answer"), simulate(world, body, {}).body);
    const base::Json stands = told(answers, "/api/design");
    EXPECT_EQ(stands.at("answer"), design(world, stands.at("body"), {}).body);
    EXPECT_EQ(told(answers, "/api/chart").at("body").at("chart"), default_chart());
}

TEST(FirstAnswers, HaveTheWholeChartOfTheCaseInOneFrame) {
    const std::string toml = io::ready_file("chain");
    const base::Json answers = answers_with(toml);
    EXPECT_EQ(told(answers, "/api/simulate").at("body").at("preset"), "file");
    const base::Json charted = told(answers, "/api/chart");
    const World world{{preset_of({toml, "a.toml", {}}, {})}, {}};
    base::Json last;
    chart(world, charted.at("body"), {}).stream([&](const auto& line) { last = base::Json::parse(line); }, {});
    const base::Json kept = base::Json::parse(charted.at("answer").get<std::string>());
    EXPECT_EQ(kept.at("directions"), base::Json({"going", "coming"}));
    for (const char* name : {"done", "computed", "category", "computed_mask", "gaps"})
        EXPECT_EQ(kept.at(name), last.at(name)) << name;
}

TEST(FirstAnswers, LeaveOutAChartThatKeepsTheWriterWaiting) {
    const base::Json answers = answers_with(io::ready_file("two-lips"));
    EXPECT_FALSE(told(answers, "/api/simulate").empty());
    EXPECT_TRUE(told(answers, "/api/chart").empty());
}

TEST(FirstAnswers, AreLeftOutWhereThePageMustAskItself) {
    const std::string of_other = place_of_answers("0123") + tail;
    EXPECT_EQ(page_with_first_answers(of_other, nullptr), of_other);
    const std::string page = place_of_answers(base::commit()) + tail;
    for (const StandingCase& standing : {StandingCase{"contact = 1\n"}, StandingCase{"", {{"velocity.csv", "0,1"}}}})
        EXPECT_EQ(answers_in(page_with_first_answers(page, &standing)), nullptr);
}

}  // namespace
}  // namespace stridor::explorer
