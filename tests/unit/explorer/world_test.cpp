#include "stridor/explorer/world.hpp"

#include "stridor/explorer/gate.hpp"
#include "stridor/explorer/served_world.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::explorer {
namespace {

using support::thrown_by;

TEST(World, BeginsWithTable1) {
    const support::ScratchFolder folder;
    EXPECT_EQ(thrown_by([&] { world_of(folder / "none.sqlite"); }).kind, ErrorKind::io);
    EXPECT_EQ(world_of({}).presets.size(), 4U);
}

TEST(Preset, OfAFileHasItsChart) {
    const Preset chart = preset_of({io::ready_file("noise-chart"), "pair.toml", {"contact.preload=30"}});
    EXPECT_EQ(chart.name, "file");
    EXPECT_EQ(chart.file, "pair.toml");
    ASSERT_TRUE(chart.study.has_value());
    EXPECT_EQ(chart.study->base.contact().preload, 30.0);
    EXPECT_EQ(thrown_by([] { preset_of({"contact = 1", "a.toml", {}}); }).kind, ErrorKind::input);
}

// a lip of a seal is pressed with a tenth of a newton, a brake with thousands
TEST(Preset, WithoutAChartHasOneAroundItsOwnPreload) {
    for (const char* preload : {"0.67", "20", "4000"}) {
        const Preset preset =
            preset_of({io::ready_file("squeal"), "a.toml", {std::string("contact.preload=") + preload}});
        ASSERT_TRUE(preset.study.has_value());
        EXPECT_TRUE(sweep::holds_design(*preset.study)) << preload;
        EXPECT_DOUBLE_EQ(preset.study->x.from, 0.1 * std::stod(preload));
        EXPECT_DOUBLE_EQ(preset.study->x.to, 10.0 * std::stod(preload));
        EXPECT_EQ(preset.study->y.parameter, "contact.kinetic_friction");
        EXPECT_EQ(preset.study->y.to, 0.8) << "its static friction";
    }
}

TEST(HostNames, AreOfThisMachineAndThoseThatAreAdded) {
    EXPECT_EQ(host_names("::1", {"lab"}),
              (std::vector<std::string>{"localhost", "127.0.0.1", "[::1]", "[::1]", "lab"}));
    EXPECT_EQ(host_in_link("10.0.0.1"), "10.0.0.1");
}

}  // namespace
}  // namespace stridor::explorer
