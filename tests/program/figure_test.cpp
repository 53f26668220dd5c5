#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

using stridor::support::Finished;
using stridor::support::Launch;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

TEST(Figure, IsWhatItsEndingSays) {
    const ScratchFolder folder;
    write_text(folder / "case.toml", run({"init", "squeal"}).out);
    const auto drawn = [&](const std::string& name) {
        return run({"figure", "friction-law", "case.toml", "-o", name}, folder.path());
    };
    for (const auto& [name, start] :
         {std::pair("f.png", "\x89PNG"), std::pair("f.svg", "<?xml"), std::pair("f.pdf", "%PDF-")}) {
        ASSERT_EQ(drawn(name).exit_code, 0);
        EXPECT_TRUE(read_text(folder / name).starts_with(start)) << name;
    }
    EXPECT_EQ(drawn("f.jpeg").exit_code, 2);
}

TEST(Figure, IsNotDrawnWithoutAFont) {
    const ScratchFolder folder;
    write_text(folder / "case.toml", run({"init", "squeal"}).out);
    write_text(folder / "fonts.conf", "<fontconfig></fontconfig>");
    const Finished finished = run(Launch{{"figure", "friction-law", "case.toml", "-o", "f.png"},
                                         folder.path(),
                                         {},
                                         std::nullopt,
                                         {{"FONTCONFIG_FILE", (folder / "fonts.conf").string()}}});
    EXPECT_EQ(finished.exit_code, 5);
    EXPECT_NE(finished.err.find("no font is installed"), std::string::npos) << finished.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "f.png"));
}
