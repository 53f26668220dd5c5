#include "stridor/explorer/page_file.hpp"

#include "stridor/base/json.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

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

}  // namespace
}  // namespace stridor::explorer
