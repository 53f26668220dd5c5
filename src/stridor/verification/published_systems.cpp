// The table of what others published. A new row is an entry of `numbers`; a new system has a file in cases/published,
// listed in CMakeLists.txt. A tolerance is the precision of the published number: digits, steps, terms left out.

#include "stridor/classification/verdict.hpp"
#include "stridor/verification/published.hpp"

#include <string>
#include <utility>
#include <vector>

namespace stridor::verification {

namespace {

using classification::Category;

constexpr std::string_view printed_digits = "half of the last printed digit";
constexpr std::string_view rounding = "rounding of a closed form";
constexpr std::string_view finite_modes = "15 %, by judgement: their corner is sharp, that of 60 modes is not";

constexpr std::string_view modelica_steps = "1e-4 of it, by judgement: steps of a tolerance of 1e-6 each";
constexpr std::string_view law_missing = "the law is missing";
constexpr std::string_view no_parameters = "mass, stiffness and friction do not stand in open text";

// of Leine's block, whose digits are all given
PublishedNumber leine(std::string quantity, std::string_view unit, std::vector<std::string> set, QuantityOfCase measure,
                      double theirs, double tolerance) {
    return {std::move(quantity), unit, std::move(set), measure, "", theirs, tolerance, printed_digits};
}

// the phase of one of the paper's runs is of this category
PublishedNumber paper_category(std::string_view phase, Category theirs) {
    const std::string name(phase);
    return {name, category_unit, {}, category, name, static_cast<double>(theirs), 0.0, "the same word"};
}

PublishedSystem paper_case(std::string_view file, std::vector<PublishedNumber> numbers) {
    return {"Elmaian et al. 2012, Table 1 and text",
            "a rubber joint on a plate",
            Origin::computation,
            file,
            "thresholds of the verdict, which the paper does not print",
            std::move(numbers)};
}

std::vector<PublishedSystem> make_systems() {
    return {
        {"Den Hartog 1931",
         "a mass on a spring with dry friction, forced",
         Origin::formula,
         "den-hartog.toml",
         "the surface is shaken in place of the force, which is the same for the slip",
         {{"amplitude, g = 1.5, r = 0.2", "m", {}, slip_amplitude, "", 0.765942, 5e-7, printed_digits},
          {"amplitude, g = 1.5, r = 0.6", "m", {"preload=0.6"}, slip_amplitude, "", 0.400000, 5e-7, printed_digits},
          {"amplitude, g = 2, r = 0.4",
           "m",
           {"preload=0.4", "drive.amplitude=0.3333333333333333", "drive.frequency=0.3183098861837907"},
           slip_amplitude,
           "",
           0.266667,
           5e-7,
           printed_digits},
          {"stops from r on, g = 0.6",
           "N",
           {"drive.amplitude=1.5625", "drive.frequency=0.0954929658551372"},
           stick_limit,
           "preload=0.4:0.7",
           0.5315125402,
           1e-6,
           "bisected to 1e-7"}}},
        {"Nakano 2006: lambda^2 = 4 pi zeta",
         "a mass on a spring and a dashpot, on a belt",
         Origin::formula,
         "stick-slip.toml",
         "",
         {{"stick-slip ends, zeta = 0.001",
           "m/s",
           {},
           stick_limit,
           "drive.velocity=2:8",
           4.460310290381927,
           0.141,
           "first order in sqrt(zeta), 3.2 %"},
          {"stick-slip ends, zeta = 0.0001",
           "m/s",
           {"structure.damping_scale=0.1"},
           stick_limit,
           "drive.velocity=8:24",
           14.104739588693909,
           0.141,
           "first order in sqrt(zeta), 1 %"}}},
        {"Siconos, FrictionOscillator.ref",
         "a mass on a spring, let go on dry friction",
         Origin::computation,
         "free-oscillation.toml",
         "",
         {{"mass rests at",
           "m",
           {},
           position_at,
           "40",
           0.68204414,
           2.5e-3,
           "steps of 0.01 s: h^2/2 of 49 m/s^2 in 7 swings"}}},
        {"Leine et al. 1998, digits recomputed",
         "a block on a belt, friction 1/(1 + 3 |w|)",
         Origin::computation,
         "leine-block.toml",
         "",
         {leine("period, V = 0.2 m/s", "s", {}, release_period, 12.001031, 5e-7),
          leine("slip time, V = 0.2 m/s", "s", {}, slip_time, 4.296000, 5e-7),
          leine("stick share, V = 0.2 m/s", "1", {}, stick_share, 0.64203, 5e-6),
          leine("period, V = 0.1 m/s", "s", {"drive.velocity=0.1"}, release_period, 17.865990, 5e-7),
          leine("stick share, V = 0.1 m/s", "1", {"drive.velocity=0.1"}, stick_share, 0.76076, 5e-6)}},
        {"Modelica, Examples.Friction, stop1",
         "a mass pushed to and fro",
         Origin::computation,
         "sliding-mass.toml",
         "the surface is shaken in place of the force, which is the same for the slip",
         {{"way after 5 s", "m", {}, slip_at, "5", 1.768462821, 1.8e-4, modelica_steps},
          {"velocity after 5 s", "m/s", {}, slip_velocity_at, "5", 6.86485859, 6.9e-4, modelica_steps}}},
        {"Modelica, Examples.Friction, stop2",
         "a mass on a spring hits a stop",
         Origin::computation,
         "mass-at-a-stop.toml",
         "places count from the spring's rest, at -0.25 m",
         {{"place at their hit", "m", {}, position_at, "0.060596954", -0.15, 4e-5, modelica_steps},
          {"velocity there", "m/s", {}, slip_velocity_at, "0.060596954", -6.105682158, 6.1e-4, modelica_steps},
          {"mass rests at", "m", {}, position_at, "5", 0.002484152, 2.5e-5, modelica_steps}}},
        {"Le Rouzic et al. 2013: V_s ln(N dmu / (c V_s))",
         "a wiper blade",
         Origin::formula,
         "wiper-squeal.toml",
         "a mode of 1 kHz, which the criterion does not ask for",
         {{"velocity below which it squeals",
           "m/s",
           {},
           stability_limit,
           "drive.velocity=0.05:1",
           0.286220088,
           5e-10,
           printed_digits}}},
        {"Code_Aster V5.01.100 (SDND100)",
         "a friction pad on a spring, released",
         Origin::formula,
         "friction-pad.toml",
         "",
         {{"pad after half a period", "m", {}, position_at, "31.41592653589793e-3", -6.5e-4, 1e-12, rounding},
          {"pad after two periods", "m", {}, position_at, "125.6637061435917e-3", 5e-5, 1e-12, rounding},
          {"pad rests at", "m", {}, position_at, "0.3", 5e-5, 1e-12, rounding}}},
        {"Code_Aster V5.01.104 (SDND104)",
         "a loose mass on a shaken plate",
         Origin::formula,
         "shaken-mass.toml",
         "",
         {{"wear power, 15 m/s^2: slides", "W", {}, wear_power, "", 15.2671, 5e-5, printed_digits},
          {"wear power, 1.5 m/s^2: sticks, slips",
           "W",
           {"drive.amplitude=0.03799544386587666"},
           wear_power,
           "",
           0.409062,
           5e-7,
           printed_digits},
          {"wear power, 1.01 m/s^2: sticks, slips",
           "W",
           {"drive.amplitude=0.02558359886969028"},
           wear_power,
           "",
           2.26164e-4,
           5e-10,
           printed_digits},
          {"wear power, 0.99 m/s^2: sticks",
           "W",
           {"drive.amplitude=0.02507699295147860"},
           wear_power,
           "",
           0.0,
           5e-10,
           printed_digits}}},
        {"Hoffmann, Fischer, Allgaier, Gaul 2002",
         "a mass on two springs, pressed on a belt",
         Origin::formula,
         "flutter.toml",
         "numbers of the springs; the spring of the contact carries 1e-9 kg",
         {{"friction where flutter begins",
           "1",
           {},
           stability_limit,
           "kinetic_friction=0:1",
           0.75,
           1e-8,
           "the mass of the contact's spring"},
          {"frequency of flutter there",
           "Hz",
           {},
           stability_frequency,
           "kinetic_friction=0:1",
           0.7071067811865476,
           1e-8,
           "the mass of the contact's spring"}}},
        {"Schelleng 1973, as euphonics.org 9.3.1",
         "a bowed string",
         Origin::formula,
         "bowed-string.toml",
         "60 modes, Helmholtz's motion at the start; the theory has a string of all modes and a sharp corner",
         {{"string's slip share, beta = 0.08",
           "1",
           {},
           slip_share,
           "",
           0.08,
           0.0167,
           "the corner of 60 modes: 1/60 of the period"},
          {"string's slip share, beta = 0.13",
           "1",
           {"structure.position=0.13"},
           slip_share,
           "",
           0.13,
           0.0167,
           "the corner of 60 modes: 1/60 of the period"},
          {"greatest bow force, beta = 0.08",
           "N",
           {},
           greatest_helmholtz_force,
           "preload=1:2.5",
           1.75,
           0.2625,
           finite_modes},
          {"greatest bow force, beta = 0.13",
           "N",
           {"structure.position=0.13"},
           greatest_helmholtz_force,
           "preload=0.6:1.6",
           1.0769,
           0.1615,
           finite_modes}}},
        {"Utzig et al. 2021, reduced in NLstep, example 05",
         "a squeak-noise test rig, shaken",
         Origin::computation,
         "squeak-rig.toml",
         "theirs is a program of leapfrog steps over the published model: the source has figures only",
         {{"rms of the rig's response",
           "m/s",
           {},
           output_rms,
           "",
           0.01093,
           1e-5,
           "the last printed digit: both go by steps"}}},
        paper_case("quiet", {paper_category("going", Category::none), paper_category("coming", Category::none)}),
        paper_case("squeal", {paper_category("going", Category::squeal),
                              paper_category("coming", Category::none),
                              {"slip share, coming", "1", {}, slip_share, "coming", 1.0, 0.005, "only slip"}}),
        paper_case("squeak", {paper_category("going", Category::squeak)}),
        paper_case("creak", {paper_category("going", Category::creak), paper_category("coming", Category::creak)}),
    };
}

}  // namespace

const std::vector<PublishedSystem>& published_systems() {
    static const std::vector<PublishedSystem> systems = make_systems();
    return systems;
}

const std::vector<NotReproduced>& not_reproduced() {
    static const std::vector<NotReproduced> all{
        {"Canudas de Wit et al. 1995, as auralius/LuGre", "LuGre, plateaus 0.63, 1.27, 1.91, 2.55 m; break-away 1.09 N",
         law_missing},
        {"Rice and Ruina 1983", "rate and state, critical stiffness 2.55e9 and 5.001666667e9 N/m", law_missing},
        {"Feeny and Moon 1994", "chaos of a forced mass whose normal force follows its way",
         "no number stands in open text"},
        {"Reddyhoff et al. 2015, measured", "wiper blades, noise near 1000 Hz and at 2000 to 2500 Hz", no_parameters},
        {"Acoustics 7 (2025) 61, measured", "brake, creep groan at 80 Hz, honk at 400 to 500 Hz", no_parameters},
        {"Marino and Cicirello 2020, measured", "transmissibility of a storey with friction", no_parameters},
        {"Real et al. 2018, measured (thiagoritto/drillstring)", "drill string, stick-slip", no_parameters},
        {"Colas et al. 2019, measured (npusteln/stickslip)",
         "paper on paper, 30.7 g, 2254 N/m: slides at 42 um/s, not at 1.1 mm/s",
         "creep: with Coulomb friction it sticks and slips at both speeds, the more the slower"},
    };
    return all;
}

}  // namespace stridor::verification
