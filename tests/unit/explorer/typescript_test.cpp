#include "stridor/explorer/typescript.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/sweep/cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace {

using stridor::explorer::typescript;

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Typescript, HasEveryFigureOfACell) {
    const std::string words = typescript("words");
    for (const auto& figure : stridor::sweep::cell_figures())
        EXPECT_TRUE(holds(words, "  \"" + std::string(figure.name) + "\",\n")) << figure.name;
}

TEST(Typescript, HasTheFillOfEveryCategory) {
    using stridor::classification::Category;
    const std::string palette = typescript("palette");
    for (const Category category :
         {Category::none, Category::squeal, Category::squeak, Category::creak, Category::undecided}) {
        const std::string ground = stridor::drawing::hex(stridor::pictures::category_fill(category).colour);
        const std::string name(stridor::classification::name(category));
        EXPECT_TRUE(holds(palette, "  \"" + name + "\": { ground: \"" + ground + "\"")) << name;
    }
}

TEST(Typescript, HasTheRecordsOfSimulations) {
    EXPECT_TRUE(holds(typescript("words"),
                      "\n/** The energy balance of a run. */\nexport interface Energy {\n"
                      "  /** change of kinetic and elastic energy [J] */\n  stored: number;\n"));
    for (const auto& record : stridor::io::simulation_records())
        for (const auto& member : record.members)
            EXPECT_TRUE(holds(typescript("words"), "  " + std::string(member.key) + ": " + std::string(member.type)))
                << member.key;
}

TEST(Typescript, HasTheFiguresOfVerdicts) {
    const std::string words = typescript("words");
    const std::string type = words.substr(words.find("export interface VerdictFigures {\n"));
    EXPECT_TRUE(holds(type, "  normal_force: {\n    /** normal force at rest [N] */\n    preload: number;\n"));
    EXPECT_TRUE(holds(type,
                      "    plate: {\n      /** root mean square velocity of the plate [m/s] */\n"
                      "      rms: number | null;\n"));
    for (const auto& figure : stridor::analysis::evidence_figures())
        EXPECT_TRUE(holds(type, "/** " + std::string(figure.sentence))) << figure.key;
    EXPECT_EQ(std::count(type.begin(), type.end(), '{'), std::count(type.begin(), type.end(), '}'));
}

// prettier would break longer ones, and the copies would differ from what is written
TEST(Typescript, BreaksListsThatAreTooLong) {
    for (const std::string_view name : stridor::explorer::typescript_names) {
        std::istringstream lines(typescript(name));
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), 120U) << line;
    }
    EXPECT_TRUE(holds(typescript("words"), "export const directions = [\"going\", \"coming\"] as const;\n"));
}

}  // namespace
