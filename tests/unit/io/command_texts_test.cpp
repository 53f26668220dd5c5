// What options say of sounds, recordings and advice, as `stridor listen`, `convert`, `rig friction` and `advise` take
// it; and the files that the program brings along.

#include "stridor/io/advice/advice_texts.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/simulation/fitted_friction.hpp"
#include "stridor/io/simulation/friction_test.hpp"
#include "stridor/io/simulation/rig_risk.hpp"
#include "stridor/io/sound/listening_texts.hpp"
#include "stridor/io/sound/named_sound.hpp"
#include "stridor/io/sound/signal_report.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace stridor::io {
namespace {

using support::thrown_by;

TEST(ReadyFiles, AreReadAsWhatTheyAre) {
    for (const std::string& name : ready_file_names()) {
        if (name != "schema") {
            EXPECT_NO_THROW(read_case({ready_file(name), name, {}})) << name;
        }
    }
    EXPECT_EQ(ready_file("schema").front(), '{');
}

TEST(ReadyFiles, MayBeWrittenOverAndNothingElse) {
    const support::ScratchFolder folder;
    const std::string file = (folder / "a.toml").string();
    EXPECT_NO_THROW(spare_written(file));
    storage::write_file(file, ready_file("creak"));
    EXPECT_NO_THROW(spare_written(file));
    storage::write_file(file, ready_file("creak") + "# mine\n");
    EXPECT_TRUE(thrown_by([&] { spare_written(file); }).says("is there already"));
}

TEST(AskedTexts, AreRangesAndTolerances) {
    const parameters::Case c;
    EXPECT_EQ(read_asked_range(c, " preload ").name, "preload");
    const advice::AskedRange range = read_asked_range(c, "preload=1:2 kN");
    EXPECT_EQ(range.from, 1000.0);
    EXPECT_EQ(range.to, 2000.0);
    const advice::AskedTolerance share = read_asked_tolerance(c, "preload=10 % normal");
    EXPECT_NEAR(share.relative.value(), 0.1, 1e-15);
    EXPECT_EQ(share.spread, advice::Spread::normal);
    EXPECT_EQ(read_asked_tolerance(c, "preload=2 N").absolute, 2.0);
    EXPECT_TRUE(thrown_by([&] { read_asked_tolerance(c, "preload"); }).says("expected KEY=AMOUNT"));
    EXPECT_TRUE(thrown_by([&] { read_asked_range(c, "preload=1:2:3"); }).says("expected KEY or KEY=FROM:TO"));
}

TEST(ListeningTexts, NameOneOfSeveralJoints) {
    const TomlSource source{ready_file("two-lips"), "two-lips.toml", {}};
    const auto weights_of = [&](const std::string& of, const std::string& component) {
        ListeningTexts texts;
        texts.of = of;
        texts.component = component;
        const ListeningChoice choice = chosen_case(texts, source);
        return hearing::heard_motion(choice.c, asked_motion(texts)).pickup.weights;
    };
    const auto one = [&](std::size_t at) { return parameters::weight_of_one(read_case(source), at); };
    EXPECT_EQ(weights_of("upper", "y"), one(1));
    EXPECT_EQ(weights_of("lower", ""), one(2));
    EXPECT_EQ(weights_of("lower", "y"), one(3));
    EXPECT_EQ(weights_of("plate", ""), one(4));
    EXPECT_TRUE(thrown_by([&] { weights_of("lowr", ""); }).says("joint (the strongest), plate, upper, lower"));
}

TEST(ListeningTexts, NameAContactOrARowOfAnOwnStructure) {
    const TomlSource source{ready_file("chain"), "chain.toml", {}};
    const auto heard = [&](const std::string& of, const std::string& component) {
        ListeningTexts texts;
        texts.of = of;
        texts.component = component;
        const ListeningChoice choice = chosen_case(texts, source);
        return hearing::heard_motion(choice.c, asked_motion(texts)).pickup;
    };
    const parameters::Case c = read_case(source);
    const std::vector<parameters::OwnContact>& contacts = c.own_structure->contacts;
    ASSERT_EQ(contacts.size(), 2U);
    EXPECT_EQ(heard("joint", "").weights, contacts[0].tangent);
    EXPECT_EQ(heard("block2", "").weights, contacts[1].tangent);
    EXPECT_EQ(heard("block2", "y").weights, contacts[1].normal);
    EXPECT_EQ(heard(c.own_structure->row[3], "").weights, parameters::weight_of_one(c, 3));
    EXPECT_TRUE(thrown_by([&] { heard("block3", ""); }).says("Listen to a contact: block1, block2"));
    EXPECT_TRUE(thrown_by([&] { heard("plate", ""); }).says("is no contact, output or row"));
    EXPECT_TRUE(thrown_by([&] { heard(c.own_structure->row[3], "x"); }).says("it has one direction"));
}

TEST(ListeningTexts, BecomeSettings) {
    const TomlSource source{ready_file("squeal"), "squeal.toml", {}};
    ListeningTexts texts;
    texts.seconds = "0.4 s";
    const ListeningChoice choice = chosen_case(texts, source);
    const hearing::HeardMotion motion = hearing::heard_motion(choice.c, asked_motion(texts));
    const sound::AuralisationSettings settings = listening_settings(texts, choice.c, motion);
    ASSERT_EQ(settings.stretches.size(), 1U);
    EXPECT_EQ(settings.stretches.front().to, 0.4);
    EXPECT_EQ(settings.rate, 48000.0);
    texts.seconds = "2.5";
    EXPECT_EQ(chosen_case(texts, source).c.run.duration, 2.5);
    texts.rate = "48";
    EXPECT_TRUE(thrown_by([&] { listening_settings(texts, choice.c, motion); }).says("from 8 kHz to 192 kHz"));
}

TEST(ListeningTexts, TakeTheDirectionOfTheirCell) {
    const TomlSource source{ready_file("noise-chart"), "pair.toml", {}};
    ListeningTexts texts;
    texts.cell = "x=20 N,y=0.6,direction=coming";
    const ListeningChoice choice = chosen_case(texts, source);
    EXPECT_EQ(texts.direction, "coming");
    EXPECT_LT(choice.c.drive.velocity, 0.0);
    EXPECT_FALSE(choice.cell.empty());
}

TEST(ListeningFullScale, LeavesADecibelOrRefusesToClip) {
    hearing::RenderedSound sound(8000.0, "m/s");
    sound.append(std::vector<double>{0.5, -2.0, 1.0});
    ListeningTexts texts;
    EXPECT_NEAR(20.0 * std::log10(2.0 / listening_full_scale(texts, sound)), -1.0, 1e-12);
    texts.full_scale = "5 m/s";
    EXPECT_TRUE(thrown_by([&] { listening_full_scale(texts, sound); }).says("--level absolute"));
    texts.level = "absolute";
    EXPECT_EQ(listening_full_scale(texts, sound), 5.0);
    texts.full_scale = "1 m/s";
    EXPECT_TRUE(thrown_by([&] { listening_full_scale(texts, sound); }).says("it would be clipped"));
}

TEST(SignalOutput, HasTheFormatOfItsName) {
    EXPECT_EQ(format_of({"A.WAV"}), "wav");
    EXPECT_EQ(format_of({"a.tsv"}), "csv");
    EXPECT_EQ(format_of({"a.unv"}), "uff58b");
    EXPECT_EQ(format_of({"a.wav", "uff58"}), "uff58");
    EXPECT_TRUE(thrown_by([] { format_of({"a.xyz"}); }).says("Say it with --format."));
}

TEST(SignalOutput, HasARoundFullScaleAboveThePeak) {
    EXPECT_EQ(round_full_scale(0.0), 1.0);
    EXPECT_EQ(round_full_scale(0.7), 1.0);
    EXPECT_EQ(round_full_scale(1.0), 2.0);
    EXPECT_EQ(round_full_scale(3.0), 5.0);
    EXPECT_EQ(round_full_scale(512.0), 1000.0);
}

MeasuredFriction measured(double mu_s, double mu_d) {
    MeasuredFriction result;
    result.test.file = "rig.csv";
    result.test.preload = 10.0;
    result.trace.all.static_friction.value = mu_s;
    result.trace.all.kinetic_friction.value = mu_d;
    return result;
}

TEST(CaseWithFriction, HasFourDigitsOfWhatWasMeasured) {
    const std::string text = case_with_friction({}, measured(0.612349, 0.45));
    const parameters::Case c = read_case({text, "measured.toml", {}});
    EXPECT_EQ(c.contact().static_friction, 0.6123);
    EXPECT_EQ(c.contact().kinetic_friction, 0.45);
}

TEST(CaseWithFriction, TakesTheKineticCoefficientWhereNoStaticOneIsSeen) {
    const double unseen = std::numeric_limits<double>::quiet_NaN();
    const std::string text = case_with_friction({}, measured(unseen, 0.45));
    EXPECT_NE(text.find("no static coefficient was to be seen"), std::string::npos);
    EXPECT_TRUE(thrown_by([&] { case_with_friction({}, measured(0.5, unseen)); }).says("nothing slides in it"));
    EXPECT_TRUE(thrown_by([&] { case_with_friction({}, measured(0.4, 0.5)); }).says("comes out below"));
}

// friction at six speeds, exactly of Stribeck's law
FittedFriction fitted_stribeck() {
    analysis::FrictionPoints points;
    for (std::size_t k = 0; k < 60; ++k) {
        analysis::FrictionPoint point;
        const double speed = 0.01 * static_cast<double>(k % 6 + 1);
        point.speeds.fill(speed);
        // deviations that are even at each speed
        point.friction = 0.3 + 0.2 * std::exp(-speed / 0.02) + (k / 6 % 2 == 0 ? 1e-4 : -1e-4);
        points.points.push_back(point);
    }
    FittedFriction fitted;
    fitted.tests.push_back({});
    fitted.tests.back().file = "rig.csv";
    fitted.fit = analysis::friction_fit(points);
    return fitted;
}

TEST(CaseWithLaw, HasTheLawToFourDigits) {
    const FittedFriction fitted = fitted_stribeck();
    const std::string text = case_with_law({}, fitted, analysis::law_called(fitted.fit, "stribeck"));
    EXPECT_NE(text.find("# friction fitted: rig.csv"), std::string::npos);
    const parameters::Contact contact = read_case({text, "fitted.toml", {}}).contact();
    EXPECT_EQ(contact.friction, parameters::FrictionKind::stribeck);
    EXPECT_NEAR(contact.static_friction, 0.5, 1e-3);
    EXPECT_NEAR(contact.kinetic_friction, 0.3, 1e-3);
    EXPECT_NEAR(contact.stribeck_velocity, 0.02, 2e-4);
    EXPECT_EQ(std::round(1e5 * contact.stribeck_velocity), 1e5 * contact.stribeck_velocity);
}

TEST(CaseWithLaw, HasTheRowsOfATable) {
    const FittedFriction fitted = fitted_stribeck();
    parameters::Case slow;  // no faster than the table's last row
    slow.drive.kind = parameters::DriveKind::constant;
    slow.drive.velocity = 0.05;
    const std::string text = case_with_law(slow, fitted, analysis::law_called(fitted.fit, "table"));
    const parameters::Contact contact = read_case({text, "fitted.toml", {}}).contact();
    EXPECT_EQ(contact.friction, parameters::FrictionKind::table);
    EXPECT_EQ(contact.interpolation, parameters::Interpolation::linear);
    ASSERT_EQ(contact.friction_table.speeds.size(), 7U);
    EXPECT_NEAR(contact.friction_table.coefficients[2], 0.3 + 0.2 * std::exp(-1.0), 1e-3);
    EXPECT_EQ(contact.static_friction, contact.friction_table.coefficients[0]);
}

// the same law at two temperatures, with half the v_s at the hotter one
FittedFriction fitted_over_temperature() {
    std::vector<analysis::FrictionAtTemperature> runs(2);
    for (std::size_t n = 0; n < 2; ++n) {
        runs[n].temperature = n == 0 ? 23.0 : 60.0;
        runs[n].data = fitted_stribeck().fit.data;
        if (n == 1)
            for (analysis::FrictionPoint& point : runs[n].data.points)
                for (double& speed : point.speeds)
                    speed *= 0.5;
    }
    FittedFriction fitted;
    fitted.tests.resize(1);
    fitted.over = analysis::friction_over_temperature(std::move(runs));
    fitted.fit = fitted.over->whole;
    return fitted;
}

TEST(CaseWithLaw, HasALawOverTheTemperature) {
    const FittedFriction fitted = fitted_over_temperature();
    const std::size_t law = analysis::law_called(fitted.fit, "stribeck");
    const std::string text = case_with_law({}, fitted, law);
    parameters::Case c = read_case({text, "fitted.toml", {}});
    EXPECT_EQ(c.contact().friction, parameters::FrictionKind::stribeck);
    for (const auto& [temperature, v_s] : {std::pair{23.0, 0.02}, {41.5, 0.015}, {60.0, 0.01}}) {
        parameters::set_quantity(c, *parameters::find_field("temperature.value"), temperature);
        EXPECT_NEAR(c.contact().stribeck_velocity, v_s, 0.01 * v_s) << temperature;
        EXPECT_NEAR(c.contact().static_friction, 0.5, 1e-3) << temperature;
    }
    EXPECT_TRUE(thrown_by([&] { case_with_law(c, fitted, law); }).says("a table over the temperature already"));
    EXPECT_TRUE(thrown_by([&] {
                    case_with_law({}, fitted, analysis::law_called(fitted.fit, "table"));
                }).says("rows over the speed do not follow the temperature"));
}

TEST(FrictionFitJson, TellsTheLawOfEachTemperature) {
    const FittedFriction fitted = fitted_over_temperature();
    const std::string text = friction_fit_json(fitted, fitted.fit.best);
    for (const char* part : {"\"temperatures\"", "\"temperature\": 60", "\"gain\"", "It changes with the temperature.",
                             "\"temperatures.temperature\": \"degC\""})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(FrictionFitJson, TellsNumbersIntervalsAndWhatTheDataBear) {
    const FittedFriction fitted = fitted_stribeck();
    const std::string text = friction_fit_json(fitted, fitted.fit.best);
    for (const char* part :
         {"\"schema\": \"stridor.friction-fit/1\"", "\"best\": \"stribeck\"", "\"asked\": \"stribeck\"",
          "\"key\": \"contact.stribeck_velocity\"", "\"sentence\": \"The data bear stribeck.", "\"residual\"",
          "\"points.speed\": \"m/s\"", "\"file\": \"rig.csv\""})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(FrictionFitTexts, AreOneForAllFilesOrOneEach) {
    FrictionFitTexts texts;
    texts.files = {"slow.csv", "fast.csv"};
    texts.shared.preload = "10 N";
    texts.shared.velocity = "1 mm/s, 20 mm/s";
    const std::vector<FrictionTexts> each = texts_of_files(texts);
    ASSERT_EQ(each.size(), 2U);
    EXPECT_EQ(each[1].file, "fast.csv");
    EXPECT_EQ(each[1].preload, "10 N");
    EXPECT_EQ(each[1].velocity, "20 mm/s");
    texts.shared.preload = "1 N, 2 N, 3 N";
    EXPECT_TRUE(thrown_by([&] { texts_of_files(texts); }).says("--preload has 3 values for 2 files"));
}

TEST(PairRow, HasTheConditionsThatAreKnown) {
    EXPECT_EQ(pair_row(measured(0.612349, 0.45), {"seal on \"glass\"", "23 degC", {}}),
              "[[pair]]\nname = \"seal on \\\"glass\\\"\"\nsource = \"rig.csv\"\ntemperature = \"23 degC\"\n"
              "load = \"10 N\"\nstatic_friction = 0.6123\nkinetic_friction = 0.45\n");
    EXPECT_TRUE(thrown_by([] { pair_row(measured(0.5, 0.4), {"seal", "23 N", {}}); }).says("a temperature"));
}

TEST(MeasuringRig, NeedsMassAndStiffness) {
    FrictionFitTexts texts;
    EXPECT_FALSE(measuring_rig(texts));
    texts.mass = "127 g";
    EXPECT_TRUE(thrown_by([&] { measuring_rig(texts); }).says("the rig's stiffness is missing"));
    texts.stiffness = "2 N/mm";
    EXPECT_DOUBLE_EQ(measuring_rig(texts)->stiffness, 2000.0);
    texts.mass = "fit";
    EXPECT_TRUE(std::isnan(measuring_rig(texts)->mass));
    texts.mass = "-1 kg";
    EXPECT_TRUE(thrown_by([&] { measuring_rig(texts); }).says("must be above zero"));
}

TEST(PairRows, AreOneForEachConditionOfTheRuns) {
    const support::ScratchFolder folder;
    const auto run = [&](const char* name, double friction) {
        std::string text = "time,friction\ns,N\n";
        for (int k = 0; k < 400; ++k)
            text += fmt::format("{:.3f},{:.4f}\n", 1e-3 * k, friction + 0.02 * std::sin(static_cast<double>(k * k)));
        storage::write_file((folder / name).string(), text);
        return (folder / name).string();
    };
    FrictionFitTexts texts;
    texts.files = {run("cold.csv", 5.0), run("warm-slow.csv", 4.0), run("warm-fast.csv", 3.0)};
    texts.shared.preload = "10 N";
    texts.shared.velocity = "4 mm/s, 1 mm/s, 4 mm/s";
    const auto note = [](const std::string&) {};
    const std::string rows = pair_rows(texts, {"seal", "23 degC, 60 degC, 60 degC", {}}, note);
    EXPECT_NE(rows.find("temperature = \"23 degC\"\nload = \"10 N\"\nstatic_friction = 0.5"), std::string::npos);
    // two runs at one temperature have one row
    EXPECT_NE(rows.find("temperature = \"60 degC\"\nload = \"10 N\"\nstatic_friction = 0.35"), std::string::npos);
    EXPECT_EQ(rows.find("[[pair]]", rows.find("[[pair]]", 1) + 1), std::string::npos);
    EXPECT_TRUE(thrown_by([&] { pair_rows(texts, {"seal", "1 degC, 2 degC", {}}, note); }).says("--temperature has 2"));
}

// a made seal whose friction falls from mu_s to mu_d over v_s, at six speeds and two temperatures
FrictionFitTexts runs_of_a_seal(const support::ScratchFolder& folder, std::string& temperatures) {
    FrictionFitTexts texts;
    texts.shared.preload = "10 N";
    for (const double temperature : {23.0, 60.0})
        for (const double speed : {2.0, 5.0, 10.0, 20.0, 40.0, 80.0}) {
            const double scale = temperature > 50.0 ? 12.0 : 20.0;
            const double kinetic = temperature > 50.0 ? 2.4 : 3.0;
            std::string text = "time,friction,speed\ns,N,mm/s\n";
            for (int k = 0; k < 500; ++k)
                text += fmt::format(
                    "{:.3f},{:.4f},{:g}\n", 4e-3 * k,
                    kinetic + 2.0 * std::exp(-speed / scale) + 0.08 * std::sin((k + 77.0 * speed) * (k + 77.0 * speed)),
                    speed);
            const std::string name = (folder / fmt::format("seal-{:g}-{:g}.csv", temperature, speed)).string();
            storage::write_file(name, text);
            texts.files.push_back(name);
            temperatures += (temperatures.empty() ? "" : ", ") + fmt::format("{:g} degC", temperature);
        }
    return texts;
}

double number_in(const std::string& rows, const std::string& key, std::size_t from) {
    const std::size_t found = rows.find("\n" + key + " = ", from);
    if (found == std::string::npos) return std::nan("");
    std::string value = rows.substr(found + key.size() + 4, 20);
    if (value.front() == '"') value.erase(0, 1);
    return std::strtod(value.c_str(), nullptr);
}

TEST(PairRows, HaveTheNumbersOfALawThatIsFitted) {
    const support::ScratchFolder folder;
    std::string temperatures, said;
    const FrictionFitTexts texts = runs_of_a_seal(folder, temperatures);
    const auto note = [&](const std::string& words) { said += words; };
    const std::string rows = pair_rows_of_law(texts, {"seal", temperatures, {}}, "best", note);
    const std::size_t warm = rows.find("[[pair]]", 1);
    ASSERT_NE(warm, std::string::npos) << rows;
    EXPECT_NE(rows.find("# of the law friction = \"stribeck\""), std::string::npos) << rows;
    EXPECT_NE(said.find("stribeck"), std::string::npos);
    EXPECT_NEAR(number_in(rows, "stribeck_velocity", 0), 0.020, 0.0004);
    EXPECT_NEAR(number_in(rows, "stribeck_velocity", warm), 0.012, 0.0004);
    EXPECT_NEAR(number_in(rows, "kinetic_friction", warm), 0.24, 0.002);
    EXPECT_EQ(number_in(rows, "stribeck_exponent", 0), 1.0);
    // they are read as they are written
    storage::write_file((folder / "pairs.toml").string(), rows);
    const parameters::MaterialPair pair = read_material_pair((folder / "pairs.toml").string(), "seal");
    EXPECT_EQ(pair.temperature, (std::vector{23.0, 60.0}));
    EXPECT_EQ(pair.stribeck_velocity,
              (std::vector{number_in(rows, "stribeck_velocity", 0), number_in(rows, "stribeck_velocity", warm)}));
    EXPECT_TRUE(thrown_by([&] {
                    pair_rows_of_law(texts, {"seal", temperatures, {}}, "table", note);
                }).says("no place for rows over the speed"));
}

TEST(RigRisk, RefusesRangesThatAreNone) {
    const auto note = [](const std::string&) {};
    for (const char* range : {"noise=1:2", "acceleration", "impulse_rate=5:1", "impulse_rate=0:1"})
        EXPECT_EQ(thrown_by([&] { rig_risk({}, {range}, note); }).kind, ErrorKind::input) << range;
}

TEST(NamedSound, IsACaseACellOrARecording) {
    const support::ScratchFolder folder;
    const std::string one = (folder / "one.toml").string();
    const std::string chart = (folder / "pair.toml").string();
    storage::write_file(one, ready_file("squeal"));
    storage::write_file(chart, ready_file("noise-chart"));
    const hearing::NamedSound whole = named_sound(one, {});
    EXPECT_EQ(whole.label, "one");
    EXPECT_TRUE(std::get<hearing::SimulatedSound>(whole.source).stretches.empty());
    const hearing::NamedSound cell = named_sound(chart + ":x=20 N,y=0.6,direction=going", {});
    EXPECT_EQ(std::get<hearing::SimulatedSound>(cell.source).stretches.size(), 1U);
    EXPECT_TRUE(thrown_by([&] { named_recording(one, {}); }).says("is no recording"));
    EXPECT_TRUE(thrown_by([&] { named_sound("library:x", {}); }).says("an entry of the noise library has a number"));
    EXPECT_TRUE(thrown_by([&] { named_sound("a.wav:channel=", {}); }).says("names no channel"));
}

}  // namespace
}  // namespace stridor::io
