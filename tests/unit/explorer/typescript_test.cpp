#include "stridor/explorer/typescript.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/sweep/cell.hpp"

#include <gtest/gtest.h>

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
