#include "stridor/io/case/toml_temperature.hpp"

#include "io_support.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace stridor::io {
namespace {

using parameters::canonical_text;
using parameters::Case;

// the squeal case without two lines, and with a table of them
std::string lip_toml(const std::string& table =
                         "value = \"-3.5 degC\"\nat = [\"-30 degC\", \"23 degC\", \"80 degC\"]\n"
                         "axial_stiffness = [\"60 N/mm\", \"25 N/mm\", \"12 N/mm\"]\n"
                         "mu_d = [0.25, 0.5, 0.75]\n") {
    std::string text = replaced(squeal_toml(), "axial_stiffness = \"1e7 N/m\"\n", "");
    text = replaced(text, "kinetic_friction = 0.6\n", "");
    text = replaced(text, "axial_damping = \"1 N*s/m\"", "axial_damping = \"15 %\"");
    return text + "\n[temperature]\n" + table;
}

Case read_temperature(const std::string& text, std::vector<std::string> overrides = {}) {
    return read_case(TomlSource{text, "case.toml", std::move(overrides)});
}

std::string temperature_refusal(const std::string& text, std::vector<std::string> overrides = {}) {
    const auto error = error_of([&] { read_temperature(text, std::move(overrides)); });
    EXPECT_TRUE(error && error->kind() == ErrorKind::input);
    return error ? error->what() : "";
}

void expect_says(const std::string& message, const std::string& words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

TEST(TomlTemperature, SetsWhatFollowsIt) {
    const Case c = read_temperature(lip_toml());
    EXPECT_EQ(c.joint().axial_stiffness, 42.5e3);
    EXPECT_EQ(c.contact().kinetic_friction, 0.375);
    EXPECT_EQ(c.joint().axial_damping, 2.0 * 0.15 * std::sqrt(42.5e3 * 0.1));
}

TEST(TomlTemperature, IsOverridden) {
    for (const char* name : {"temperature", "theta", "temperature.value"})
        EXPECT_EQ(read_temperature(lip_toml(), {std::string(name) + "=23 degC"}).joint().axial_stiffness, 25e3);
    const Case c = read_temperature(lip_toml(), {"temperature.k1i=3 N/mm, 2 N/mm, 1 N/mm", "temperature=80"});
    EXPECT_EQ(c.joint().axial_stiffness, 1e3);
    expect_says(temperature_refusal(lip_toml(), {"temperature=81"}),
                "must be between -30 and 80 degC, where the table ends");
    expect_says(temperature_refusal(lip_toml(), {"k1i=5 N/mm"}), "joint.axial_stiffness cannot be set");
    expect_says(temperature_refusal(squeal_toml(), {"temperature=23"}),
                "temperature.value means nothing for this case");
}

TEST(TomlTemperature, WritesTablesThatReadBackTheSame) {
    const std::string ratios =
        "value = 3\nat = [-5, 0.1]\njoint.axial_stiffness = [7e4, 1e3]\nmu_d = [0.1, 0.3]\n"
        "c2y = [\"15 %\", \"loss factor 0.1\"]\n";
    for (const std::string& text : {lip_toml(), lip_toml(replaced(ratios, "value = 3", "value = -3"))})
        for (const Comments comments : {Comments::none, Comments::full}) {
            const std::string c2y = text.find("c2y") == std::string::npos ? "" : "damping = \"1 N*s/m\"\n\n[contact]";
            const Case c = read_temperature(c2y.empty() ? text : replaced(text, c2y, "\n[contact]"));
            const std::string written = case_toml(c, {.comments = comments, .heading = ""});
            const Case back = read_temperature(written);
            EXPECT_EQ(canonical_text(back), canonical_text(c)) << written;
            EXPECT_EQ(back.joint().axial_stiffness, c.joint().axial_stiffness);
            EXPECT_EQ(back.plate.damping, c.plate.damping);
            EXPECT_EQ(written.find("\naxial_stiffness"), std::string::npos) << written;
        }
}

// what a trace keeps of its case are the lines of its canonical text, each as an override
TEST(TomlTemperature, IsReadFromTheLinesOfACanonicalText) {
    const Case c = read_temperature(lip_toml());
    TomlSource source{"", "the trace", {}};
    const std::string text = canonical_text(c);
    for (std::size_t from = 0, end = 0; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
        source.overrides.push_back(text.substr(from, end - from));
    EXPECT_EQ(canonical_text(read_case(source)), text);
}

TEST(TomlTemperature, PointsAtWhatIsWrongInIt) {
    const auto table = [](const std::string& lists) { return temperature_refusal(lip_toml("value = 10\n" + lists)); };
    const std::string at = "at = [0, 50]\n";
    expect_says(table(at + "k1i = [1, 2, 3]\nmu_d = [0.1, 0.2]\n"),
                "temperature.k1i: joint.axial_stiffness has 3 values over 2 temperatures");
    expect_says(table("at = [50, 0]\nk1i = [1, 2]\nmu_d = [0.1, 0.2]\n"), "temperature.at does not rise");
    expect_says(table("at = [50]\nk1i = [1]\nmu_d = [0.1]\n"), "too few temperatures: 1");
    expect_says(table("k1i = [1, 2]\nmu_d = [0.1, 0.2]\n"), "missing key temperature.at");
    expect_says(table(at), "temperature.at stands alone");
    expect_says(table(at + "k1i = [1, 2]\njoint.axial_stiffness = [1, 2]\nmu_d = [0.1, 0.2]\n"),
                "temperature.joint.axial_stiffness is joint.axial_stiffness again");
    expect_says(table(at + "k1i = 5\nmu_d = [0.1, 0.2]\n"), "temperature.k1i is a number (expected a list");
    expect_says(table(at + "k1i = [1, \"2 N/mm\"]\nmu_d = [0.1, 0.2]\n"), "a list of text and numbers");
    expect_says(table(at + "k1i = [1, -2]\nmu_d = [0.1, 0.2]\n"), "joint.axial_stiffness = -2 is out of range");
    expect_says(table(at + "axial_stifness = [1, 2]\nmu_d = [0.1, 0.2]\n"),
                "Did you mean temperature.axial_stiffness?");
    expect_says(table(at + "preload = [1, 2]\nk1i = [1, 2]\nmu_d = [0.1, 0.2]\n"), "unknown key temperature.preload");
    expect_says(temperature_refusal(lip_toml("at = [0, 50]\nk1i = [1, 2]\nmu_d = [0.1, 0.2]\n")),
                "missing key temperature.value");
    expect_says(temperature_refusal(squeal_toml() + "\n[temperature]\nvalue = 3\n"), "nothing follows the temperature");
    expect_says(temperature_refusal("temperature = 3\n" + squeal_toml()), "expected a section: [temperature]");
    // one complaint each: what a list says is not missing elsewhere
    const auto error =
        error_of([&] { read_temperature(lip_toml("value = 10\nat = [0, 50]\nk1i = [1]\nmu_d = [0.1, 0.2]\n")); });
    EXPECT_EQ(error->complaints().size(), 1U) << error->what();
    expect_error(error, "1 values over 2", "case.toml:49:7");
}

TEST(TomlTemperature, SaysWhatItsPropertiesContradict) {
    const auto error =
        error_of([] { read_temperature(replaced(lip_toml(), "0.25, 0.5, 0.75", "0.25, 0.5, 0.9"), {"theta=80"}); });
    ASSERT_TRUE(error);
    expect_says(error->what(), "mu_d = 0.9 exceeds mu_s = 0.8");
    ASSERT_TRUE(error->place());
    EXPECT_EQ(error->place()->source_line, "mu_d = [0.25, 0.5, 0.9]");
}

TEST(TomlTemperature, IsAnAxis) {
    const sweep::Study study = read_study(TomlSource{lip_toml(), "c.toml", {}}, {"temperature=-30:80:3", ""});
    EXPECT_EQ(study.x.parameter, "temperature.value");
    EXPECT_EQ(sweep::case_at(study, {0, 0, 2}).joint().axial_stiffness, 12e3);
    const sweep::Study back = read_study(TomlSource{study_toml(study), "back.toml", {}});
    EXPECT_EQ(sweep::canonical_text(back), sweep::canonical_text(study));
    // the temperature of the base is none of the chart's
    const sweep::Study warm = read_study(TomlSource{lip_toml(), "c.toml", {"temperature=60"}}, {"theta=-30:80:3", ""});
    EXPECT_EQ(sweep::canonical_text(warm), sweep::canonical_text(study));
    const auto refused = [](const AxisTexts& axes) {
        return std::string(error_of([&] { read_study(TomlSource{lip_toml(), "c.toml", {}}, axes); })->what());
    };
    expect_says(refused({"temperature=-31:80:3", ""}), "must be between -30 and 80 degC");
    expect_says(refused({"k1i=1e4:1e5:3", ""}), "joint.axial_stiffness cannot be set");
    expect_says(refused({"preload=1:9:3", "mu_d=0.1:0.2:3"}), "contact.kinetic_friction cannot be set");
    // beside preload, what does not follow the temperature
    EXPECT_EQ(read_study(TomlSource{lip_toml(), "c.toml", {}}, {"preload=1:9:3", ""}).y.parameter,
              "joint.incidence_angle");
}

TEST(TomlTemperature, StandsInTheJsonOfItsCase) {
    const auto document = nlohmann::json::parse(case_json(read_temperature(lip_toml())));
    const auto& table = document["temperature"];
    EXPECT_EQ(table["value"], -3.5) << document.dump(1);
    EXPECT_EQ(table["at"], (std::vector<double>{-30, 23, 80}));
    EXPECT_EQ(table["joint.axial_stiffness"], (std::vector<double>{60e3, 25e3, 12e3}));
    EXPECT_EQ(document["joint"]["axial_stiffness"], 42.5e3);
    EXPECT_FALSE(nlohmann::json::parse(case_json(read_temperature(squeal_toml()))).contains("temperature"));
}

}  // namespace
}  // namespace stridor::io
