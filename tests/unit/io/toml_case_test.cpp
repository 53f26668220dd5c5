#include "stridor/io/case/toml_case.hpp"

#include "io_support.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/canary.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace stridor::io {
namespace {

using parameters::Case;

Case read(const std::string& text, std::vector<std::string> overrides = {}) {
    return read_case(TomlSource{text, "case.toml", std::move(overrides)});
}

std::optional<Error> refusal(const std::string& text, std::vector<std::string> overrides = {}) {
    const auto error = error_of([&] { read(text, std::move(overrides)); });
    EXPECT_TRUE(!error || error->kind() == ErrorKind::input) << error->what();
    return error;
}

// what `refusal` says of the squeal case with one piece of text replaced
std::optional<Error> refusal_with(const std::string& from, const std::string& to) {
    return refusal(replaced(squeal_toml(), from, to));
}

constexpr const char* minimal =
    "[joint]\nmass = 0.1\naxial_stiffness = 1e7\nflexural_stiffness = 1e6\naxial_damping = 1\n"
    "flexural_damping = 1\nincidence_angle = 70\n[plate]\nmass = 0.4\nstiffness = 1e6\ndamping = 1\n"
    "[contact]\npreload = 20\nstatic_friction = 0.8\nkinetic_friction = 0.6\n"
    "[drive]\nkind = \"constant\"\nvelocity = -0.1\n";

TEST(TomlCase, TakesNumbersInSiAndTextWithUnits) {
    std::string text = replaced(minimal, "preload = 20", "preload = \"0.02 kN\"");
    text = replaced(text, "incidence_angle = 70", "incidence_angle = 45.5");
    text = replaced(text, "velocity = -0.1", "velocity = \"-40 mm/s\"");
    const Case c = read(text);
    EXPECT_EQ(c.contact().preload, 20.0);
    EXPECT_EQ(c.joint().incidence_angle, 45.5);
    EXPECT_EQ(c.drive.velocity, -0.04);
    EXPECT_EQ(c.drive.kind, parameters::DriveKind::constant);
}

TEST(TomlCase, TakesTheUsualLawsWhereNoneIsNamed) {
    const Case c = read(minimal);
    EXPECT_EQ(c.contact().friction, parameters::FrictionKind::coulomb);
    EXPECT_EQ(c.contact().impact, parameters::ImpactKind::plastic);
}

// the other way has coefficients of its own, which belong to that law alone
TEST(TomlCase, ReadsFrictionThatDiffersEachWay) {
    const std::string each_way = "static_friction = 0.8\nstatic_friction_coming = 0.5\nkinetic_friction_coming = 0.1\n";
    const std::string text = replaced(minimal, "static_friction = 0.8\n", each_way + "friction = \"directional\"\n");
    const Case c = read(text);
    EXPECT_EQ(c.contact().friction, parameters::FrictionKind::directional);
    EXPECT_EQ(c.contact().kinetic_friction_coming, 0.1);
    EXPECT_TRUE(refusal(replaced(minimal, "static_friction = 0.8\n", each_way)).has_value());
    EXPECT_TRUE(refusal(replaced(text, "static_friction_coming = 0.5\n", "")).has_value());
}

TEST(TomlCase, DefaultsRunAndVerdict) {
    const Case c = read(minimal);
    const Case defaults;
    EXPECT_EQ(c.run.step, defaults.run.step);
    EXPECT_EQ(c.verdict.creak_stick, defaults.verdict.creak_stick);
    EXPECT_EQ(c.contact().impact, parameters::ImpactKind::plastic);
}

TEST(TomlCase, ListsAllMissingKeysAtOnce) {
    std::string text = replaced(minimal, "preload = 20\n", "");
    text = replaced(text, "velocity = -0.1\n", "");
    expect_error(refusal(text), "missing keys contact.preload, drive.velocity", "case.toml");
    expect_error(refusal(replaced(minimal, "preload = 20\n", "")), "missing key contact.preload (", "case.toml");
    expect_error(refusal(""), "missing keys joint.mass, joint.axial_stiffness,", "case.toml");
    expect_error(refusal(replaced(minimal, "kind = \"constant\"\n", "")), "missing key drive.kind (", "case.toml");
}

TEST(TomlCase, SuggestsTheKeyThatWasMeant) {
    expect_error(refusal_with("preload", "prelaod"), "unknown key contact.prelaod. Did you mean contact.preload?",
                 "case.toml:17:1");
    expect_error(refusal_with("[contact]", "[contac]"), "unknown section [contac]. Did you mean [contact]?",
                 "case.toml:16:2");
    expect_error(refusal_with("title", "preload = 1\ntitle"), "unknown key preload. Did you mean contact.preload?",
                 "case.toml:1:1");
    expect_error(refusal_with("[plate]", "[plate]\npreload = 1"), "Did you mean contact.preload?", "case.toml:12:1");
    expect_error(refusal(squeal_toml(), {"contact.colour=red"}), "unknown key contact.colour", "--set");
    EXPECT_EQ(refusal_with("preload", "prelaod")->place()->source_line, "prelaod = \"20 N\"");
}

TEST(TomlCase, NamesBothDimensionsOfAWrongUnit) {
    expect_error(refusal_with("\"20 N\"", "\"20 mm\""),
                 "contact.preload = \"20 mm\" is a length (m) (expected a force (N))", "case.toml:17:11");
    expect_error(refusal_with("\"20 N\"", "\"20 Nx\""), "contact.preload: unknown unit \"Nx\"", "case.toml:17:11");
    expect_error(refusal_with("\"20 N\"", "\"much\""), "contact.preload = \"much\" is not a number", "case.toml:17:11");
    expect_error(refusal(squeal_toml(), {"contact.preload=5 mm"}), "contact.preload = \"5 mm\" is a length", "--set");
}

TEST(TomlCase, RefusesWrongTypes) {
    expect_error(refusal_with("\"20 N\"", "true"), "contact.preload is a boolean (expected a number in N",
                 "case.toml:17:11");
    expect_error(refusal_with("\"20 N\"", "[\"20 N\"]"), "contact.preload is a list", "case.toml:17:11");
    expect_error(refusal_with("\"20 N\"", "{}"), "contact.preload is a section", "case.toml:17:11");
    expect_error(refusal_with("preload = \"20 N\"", "preload.x = 1"), "unknown key contact.preload.x",
                 "case.toml:17:9");
    expect_error(refusal_with("\"sinusoidal\"", "5"), "drive.kind is a number (expected one of \"sinusoidal\"",
                 "case.toml:23:8");
    expect_error(refusal_with("title = \"", "title = 5 # \""), "title is a number (expected text)", "case.toml:1:9");
    expect_error(refusal("contact = 5\n"), "contact is a number (expected a section", "case.toml:1:1");
}

TEST(TomlCase, RefusesNumbersThatMakeNoSense) {
    expect_error(refusal_with("\"20 N\"", "nan"), "contact.preload = nan is out of range (it must be finite)",
                 "case.toml:17:11");
    expect_error(refusal_with("\"20 N\"", "inf"), "it must be finite", "case.toml:17:11");
    expect_error(refusal_with("\"20 N\"", "\"-20 N\""), "contact.preload = -20 is out of range", "case.toml:17:11");
    expect_error(refusal_with("\"sinusoidal\"", "\"sinsoidal\""), "Did you mean \"sinusoidal\"?", "case.toml:23:8");
}

TEST(TomlCase, RefusesKeysThatMeanNothingForTheCase) {
    expect_error(refusal_with("[run]", "velocity = 1\n\n[run]"),
                 "drive.velocity means nothing for this case (it belongs to drive.kind = \"constant\" or "
                 "\"trapezoidal\")",
                 "case.toml:27:1");
    expect_error(refusal(squeal_toml(), {"drive.velocity=1"}), "drive.velocity means nothing", "--set");
    expect_error(refusal(minimal, {"verdict.settling=0.1"}),
                 "it belongs to drive.kind = \"sinusoidal\", \"sampled\" or \"trapezoidal\"", "--set");
}

TEST(TomlCase, OverridesOfTheDriveLeaveOutKeysOfTheFileThatLostTheirMeaning) {
    const Case c = read(squeal_toml(), {"drive.kind=constant", "drive.velocity=0.1"});
    EXPECT_EQ(c.drive.kind, parameters::DriveKind::constant);
    EXPECT_EQ(c.drive.velocity, 0.1);
    expect_error(refusal(squeal_toml(), {"drive.kind=constant"}), "missing key drive.velocity", "case.toml");
}

TEST(TomlCase, PointsAtValuesThatContradictEachOther) {
    const auto error = refusal_with("kinetic_friction = 0.6", "kinetic_friction = 0.9");
    expect_error(error, "mu_d = 0.9 exceeds mu_s = 0.8", "case.toml:19:20");
    EXPECT_EQ(error->problem().suggestion, "Swap them?");
    expect_error(refusal(squeal_toml(), {"contact.kinetic_friction=0.9"}), "mu_d = 0.9 exceeds", "--set");
    expect_error(refusal(minimal, {"run.duration=0.5", "run.window=1"}), "run.window = 1 s is longer", "--set");
}

std::vector<std::string> places_of(const Error& error) {
    std::vector<std::string> places;
    for (const base::Complaint& complaint : error.complaints())
        places.push_back(base::describe(*complaint.place));
    return places;
}

TEST(TomlCase, TellsAllThatIsWrongAtOnceFromTopToBottom) {
    std::string text = replaced(squeal_toml(), "mass = \"0.1 kg\"", "mass = \"0,1 kg\"");  // line 4
    text = replaced(text, "flexural_damping", "flexural_dampin");                          // line 8
    text = replaced(text, "preload = \"20 N\"\n", "");                                     // shifts what follows
    text = replaced(text, "static_friction = 0.8", "static_friction = true");              // line 17
    text = replaced(text, "quiet_slip = 0.98", "quiet_slip = 2");
    text = replaced(text, "window = \"1 s\"", "window = \"2 s\"");
    const auto error = refusal(text, {"contact.impact=plastik"});
    ASSERT_TRUE(error);
    EXPECT_EQ(places_of(*error), (std::vector<std::string>{"case.toml:4:8", "case.toml:8:1", "case.toml:17:19",
                                                           "case.toml:28:10", "case.toml:36:14", "case.toml", "--set"}))
        << error->what();
}

TEST(TomlCase, TellsEveryLineThatIsNotToml) {
    std::string text = replaced(squeal_toml(), "mass = \"0.1 kg\"", "mass = 0.1 kg");
    text = replaced(text, "preload = \"20 N\"", "preload = 20 N");
    text = replaced(text, "static_friction = 0.8", "static_friction = 0,8");
    text = replaced(text, "kinetic_friction = 0.6", "kinetic_friction = 0.6\nkinetic_friction = 0.5");
    const auto error = refusal(text);
    ASSERT_TRUE(error);
    EXPECT_EQ(places_of(*error),
              (std::vector<std::string>{"case.toml:4:12", "case.toml:17:14", "case.toml:18:20", "case.toml:20:1"}))
        << error->what();
    // without its section what follows would be misplaced
    EXPECT_EQ(refusal(replaced(squeal_toml(), "[plate]", "[plate"))->complaints().size(), 1U);
    EXPECT_EQ(refusal(replaced(squeal_toml(), "preload = \"20 N\"", "preload = [20\nx = 1"))->complaints().size(), 1U);
}

// a friction coefficient that could not be read contradicts none
TEST(TomlCase, FindsNoContradictionInWhatItCouldNotRead) {
    std::string text = replaced(squeal_toml(), "kinetic_friction = 0.6", "kinetic_friction = 0.9");
    EXPECT_EQ(refusal(replaced(text, "preload = \"20 N\"", "preload = 0"))->complaints().size(), 2U);
    EXPECT_EQ(refusal(replaced(text, "static_friction = 0.8", "static_friction = \"0,8\""))->complaints().size(), 1U);
    EXPECT_EQ(refusal(replaced(text, "static_friction = 0.8\n", ""))->complaints().size(), 1U);
}

TEST(TomlCase, HearsOfAMisspeltKeyOnceAndNotThatItIsMissing) {
    EXPECT_EQ(refusal_with("preload", "prelaod")->complaints().size(), 1U);
    EXPECT_EQ(refusal_with("[contact]", "[contac]")->complaints().size(), 1U);
    EXPECT_EQ(refusal_with("preload = \"20 N\"", "preload.x = 1")->complaints().size(), 1U);
    EXPECT_EQ(refusal_with("\"sinusoidal\"", "\"sinsoidal\"")->complaints().size(), 1U);
}

// what an init file has to say after its kind was changed by hand
TEST(TomlCase, KeysThatAChangedKindLeavesBehindAreWarnings) {
    const std::string text =
        replaced(squeal_toml(), "kind = \"sinusoidal\"", "kind = \"constant\"\nvelocity = \"0.2 m/s\"");
    EXPECT_EQ(read(text).drive.velocity, 0.2);
    std::vector<std::string> keys;
    for (const base::Complaint& warning : case_warnings(parse_toml({text, "case.toml", {}})))
        keys.push_back(warning.problem.what.substr(0, warning.problem.what.find(' ')));
    EXPECT_EQ(keys,
              (std::vector<std::string>{"drive.amplitude", "drive.frequency", "verdict.settling", "verdict.reversal"}));
    EXPECT_EQ(parameters::canonical_text(read(text)),
              parameters::canonical_text(read(squeal_toml(), {"drive.kind=constant", "drive.velocity=0.2"})));
    expect_error(refusal(replaced(text, "0.004 m", "0.005 m")), "drive.amplitude means nothing for this case",
                 "case.toml:25:1");
    expect_error(refusal(replaced(text, "velocity = \"0.2 m/s\"\n", "")), "Write for example velocity = \"0.1 m/s\"",
                 "case.toml");
    EXPECT_TRUE(case_warnings(parse_toml({squeal_toml(), "case.toml", {}})).empty());
    // an override that has no effect is no remainder
    expect_error(refusal(text, {"drive.amplitude=0.004"}), "drive.amplitude means nothing", "--set");
}

TEST(TomlCase, TakesOverridesInAnySpelling) {
    EXPECT_EQ(read(minimal, {"mu_d=0.3"}).contact().kinetic_friction, 0.3);
    EXPECT_EQ(read(minimal, {"preload=30", "contact.preload=40", "F=50"}).contact().preload, 50.0);
    expect_error(refusal(minimal, {"mass=1"}), "Write joint.mass or plate.mass.", "--set");
    expect_error(refusal(minimal, {"mu_d=much"}), "contact.kinetic_friction = \"much\" is not a number", "--set");
}

TEST(TomlCase, AWindowNobodyWroteIsNeverLongerThanTheRun) {
    EXPECT_EQ(read(minimal, {"run.duration=0.5"}).run.window, 0.5);
    EXPECT_EQ(read(minimal, {"run.duration=5"}).run.window, 1.0);
}

TEST(TomlCase, DoesNotLookAtAChart) {
    EXPECT_NO_THROW(read(squeal_toml() + "[chart]\nx = 5\nnonsense = true\n"));
}

TEST(TomlCase, FindsTheSampledDriveBesideTheFile) {
    const ScratchFolder scratch;
    std::filesystem::create_directory((scratch / "in").string());
    storage::write_file((scratch / "in/drive.csv").string(), "time,velocity\ns,mm/s\n0,100\n2,-100\n");
    std::string text = replaced(minimal, "kind = \"constant\"", "kind = \"sampled\"");
    text = replaced(text, "velocity = -0.1", "file = \"drive.csv\"");
    storage::write_file((scratch / "in/case.toml").string(), text);
    const Case c = read_case((scratch / "in/case.toml").string());
    EXPECT_EQ(c.drive.times, (std::vector<double>{0.0, 2.0}));
    EXPECT_EQ(c.drive.velocities, (std::vector<double>{0.1, -0.1}));
    EXPECT_EQ(c.drive.file, "drive.csv");

    storage::write_file((scratch / "in/drive.csv").string(), "time,velocity\n0,1\n2,x\n");
    const auto error = error_of([&] { read_case((scratch / "in/case.toml").string()); });
    expect_error(error, "velocity = \"x\" is not a number", (scratch / "in/drive.csv").string() + ":3:3");

    std::filesystem::remove((scratch / "in/drive.csv").string());
    expect_error(error_of([&] { read_case((scratch / "in/case.toml").string()); }), "drive.file: cannot read",
                 (scratch / "in/case.toml").string() + ":18:8");
}

// every spelling of drive.file that TOML knows
std::vector<std::string> sampled_drives(const std::string& path) {
    const std::string file = "\"" + path + "\"";
    return {"[drive]\nkind = \"sampled\"\nfile = " + file, "[drive]\nkind = 'sampled'\n\"file\" = '" + path + "'",
            "[drive]\n\"kind\" = \"sampled\"\n\"fi\\u006ce\" = " + file,
            "[\"drive\"]\nkind = \"sampled\"\n'file'=\"\"\"" + path + "\"\"\"",
            "[ drive ]\r\nkind = \"sampled\"\r\nfile\t=\t" + file + "\r\n"};
}

std::string without_drive() {
    std::string text = minimal;
    const std::size_t from = text.find("[drive]");
    const std::size_t to = text.find("\n[", from + 1);
    return text.erase(from, to == std::string::npos ? to : to - from);
}

// dotted keys and an inline table stand in front of the sections
std::vector<std::string> cases_with_samples(const std::string& path) {
    std::vector<std::string> texts;
    for (const std::string& drive : sampled_drives(path))
        texts.push_back(without_drive() + "\n" + drive + "\n");
    for (const std::string head :
         {"drive.kind = \"sampled\"\ndrive.file = \"@\"\n", "drive . kind = 'sampled'\ndrive\t.\"file\" = '@'\n",
          "drive = { kind = \"sampled\", file = \"@\" }\n", "\"dri\\u0076e\" = { kind = \"sampled\", 'file' = '@' }\n"})
        texts.push_back(replaced(head, "@", path) + without_drive());
    return texts;
}

TEST(TomlCase, ReachesAFileThroughItsReaderAlone) {
    support::Canary canary;
    for (const std::string& path : {canary.file(), canary.pipe()})
        for (const std::string& text : cases_with_samples(path)) {
            std::string asked;
            const SamplesReader reader = [&](const std::string& name) {
                asked = name;
                return recordings::SampledMotion{{0.0, 2.0}, {0.1, -0.1}};
            };
            EXPECT_NO_THROW(read_case(parse_toml({text, "case.toml", {}}), {reader})) << text;
            EXPECT_EQ(asked, path) << text;
            EXPECT_FALSE(canary.was_opened()) << text;
        }
}

TEST(TomlCase, OpensNothingWhateverByteStandsAroundAKey) {
    support::Canary canary;
    const SamplesReader none = [](const std::string&) -> recordings::SampledMotion {
        throw std::runtime_error("opened");
    };
    const std::string plain = cases_with_samples(canary.file()).front();
    for (const std::string& key : {std::string("file"), std::string("kind"), std::string("[drive]")})
        for (int byte = 0; byte < 0x80; byte = byte == 0x20 ? 0x7F : byte + 1)
            for (std::size_t at = 0; at <= key.size(); ++at) {
                std::string odd = key;
                odd.insert(at, 1, static_cast<char>(byte));
                try {
                    read_case(parse_toml({replaced(plain, key, odd), "case.toml", {}}), {none});
                    ADD_FAILURE() << odd;
                } catch (const std::exception&) {
                }
                EXPECT_FALSE(canary.was_opened()) << odd;
            }
}

TEST(TomlCase, TakesNoPipeForASampledDrive) {
    support::Canary canary;
    for (const std::string& path : {canary.pipe(), std::string("/dev/zero"), std::string("/dev")}) {
        const auto error = error_of([&] { read(cases_with_samples(path).front()); });
        expect_error(error, "drive.file: cannot read", "case.toml:19:8");
    }
}

std::string measured(const std::string& table) {
    const std::string text =
        replaced(minimal, "kinetic_friction = 0.6\n", "friction = \"table\"\nfriction_table = \"" + table + "\"\n");
    return text + "[run]\nengine = \"beta_2\"\n";
}

TEST(TomlCase, ReadsATableOfFriction) {
    const Case c = read(measured("0: 0.8, 50 mm/s: 0.6, 0.2: 0.55"));
    EXPECT_EQ(c.contact().friction_table.speeds, (std::vector<double>{0.0, 0.05, 0.2}));
    EXPECT_EQ(c.contact().interpolation, parameters::Interpolation::cubic);
    const auto error = refusal(measured("0: 0.8, 0.2: 0.6, 0.1: 0.5"));
    expect_error(error, "row 3 of the table of friction has 0.1 m/s after 0.2 m/s", "case.toml:16:18");
    expect_error(refusal(replaced(measured("0: 0.8, 1: 0.6"), "engine = \"beta_2\"",
                                  "engine = \"moreau\"\nformulation = \"massless\"")),
                 "knows no friction that changes with the slip velocity", "case.toml:15:12");
    EXPECT_NO_THROW(read(replaced(measured("0: 0.8, 1: 0.6"), "[run]\nengine = \"beta_2\"\n", "")));
}

TEST(TomlCase, ReadsATableOfFrictionFromItsFile) {
    const support::ScratchFolder folder;
    storage::write_file(folder / "rubber.csv", "speed [mm/s],friction\n0,0.8\n100,0.6\n");
    const std::string path = (folder / "case.toml").string();
    const Case c = read_case(TomlSource{measured("rubber.csv"), path, {}});
    EXPECT_EQ(c.contact().friction_table.speeds, (std::vector<double>{0.0, 0.1}));
    // what is kept of it has the rows
    const Case kept = read(case_toml(c, {}));
    EXPECT_EQ(parameters::canonical_text(kept), parameters::canonical_text(c));
    expect_error(error_of([] { read(measured("none.csv")); }), "cannot read", "case.toml:16:18");
    EXPECT_TRUE(error_of([] {
                    read_case(parse_toml({measured("rubber.csv"), "case.toml", {}}), readers_without_files());
                }).has_value());
}

TEST(TomlCase, RefusesStribeckNumbersThatMeanNothing) {
    const std::string text = replaced(minimal, "static_friction = 0.8\n",
                                      "static_friction = 0.8\nfriction = \"stribeck\"\nstribeck_velocity = 0.05\n") +
                             "[run]\nengine = \"beta_2\"\n";
    EXPECT_EQ(read(text).contact().stribeck_exponent, 1.0);
    const auto refused = [&](const char* from, const char* to, const char* says, const char* place) {
        expect_error(refusal(replaced(text, from, to)), says, place);
    };
    const std::string velocity = "stribeck_velocity = 0.05";
    refused(velocity.c_str(), "stribeck_velocity = 0", "contact.stribeck_velocity", "case.toml:16:21");
    refused(velocity.c_str(), (velocity + "\nstribeck_exponent = 0.5").c_str(), "contact.stribeck_exponent",
            "case.toml:17:21");
    refused(velocity.c_str(), (velocity + "\nviscous_friction = -1").c_str(), "contact.viscous_friction",
            "case.toml:17:20");
    refused("kinetic_friction = 0.6", "kinetic_friction = 0.9", "mu_d = 0.9 exceeds mu_s = 0.8", "case.toml:17:20");
    refused("kinetic_friction = 0.6", "kinetic_friction = -0.1", "contact.kinetic_friction", "case.toml:17:20");
    EXPECT_NO_THROW(read(replaced(text, "engine = \"beta_2\"", "engine = \"exact\"")));
    const std::string power = replaced(text, velocity, velocity + "\nstribeck_exponent = 1.5");
    expect_error(refusal(replaced(power, "engine = \"beta_2\"", "engine = \"exact\"")),
                 "has no power series of this law of friction", "case.toml:15:12");
}

TEST(TomlCase, ReadsFrictionWithoutAStickThatNoVerdictIsMadeOf) {
    const std::string text =
        replaced(minimal, "static_friction = 0.8\n", "friction = \"arctan\"\nregularisation = \"1 mm/s\"\n") +
        "[run]\nengine = \"moreau\"\n";
    const Case c = read(text);
    EXPECT_EQ(c.contact().friction, parameters::FrictionKind::arctan);
    EXPECT_EQ(c.contact().regularisation, 1e-3);
    EXPECT_EQ(c.verdict.creeping, parameters::Creeping::undecided);
    EXPECT_EQ(read(text + "[verdict]\ncreeping = \"judged\"\n").verdict.creeping, parameters::Creeping::judged);
    // what sticks has no such width, and what does not has no limit that rest could raise
    EXPECT_TRUE(refusal(replaced(text, "arctan", "coulomb")).has_value());
    EXPECT_TRUE(refusal(replaced(text, "regularisation = \"1 mm/s\"\n", "")).has_value());
    EXPECT_TRUE(refusal(replaced(text, "preload = 20", "preload = 20\nrest = \"logarithmic\"")).has_value());
    expect_error(refusal(replaced(text, "moreau", "exact")), "has no power series of this law of friction",
                 "case.toml:14:12");
}

TEST(TomlCase, ReadsStaticFrictionThatGrowsWithRest) {
    const std::string keys = "rest = \"kato\"\nrest_growth = 0.2\nrest_time = \"3 min\"\n";
    const std::string text = replaced(minimal, "preload = 20\n", "preload = 20\n" + keys);
    const Case c = read(text);
    EXPECT_EQ(c.contact().rest, parameters::RestKind::kato);
    EXPECT_EQ(c.contact().rest_time, 180.0);
    EXPECT_EQ(c.contact().rest_exponent, 0.5);
    EXPECT_EQ(read(text, {"t_r=2"}).contact().rested, 2.0);
    EXPECT_EQ(read(case_toml(c)).contact().rest_growth, 0.2);
    expect_error(refusal(replaced(text, "rest_growth = 0.2\n", "")), "missing key contact.rest_growth", "case.toml");
    for (const char* odd : {"m_r=0", "m_r=1.5", "t_0=0", "A_r=-0.1", "t_r=-1"})
        expect_error(refusal(text, {odd}), "is out of range", "--set");
    EXPECT_TRUE(refusal(replaced(minimal, "preload = 20\n", "preload = 20\nrest_time = 2\n")).has_value());
}

TEST(TomlCase, NeedsTheFileOfASampledDrive) {
    const std::string text = replaced(minimal, "kind = \"constant\"\nvelocity = -0.1\n", "kind = \"sampled\"\n");
    expect_error(refusal(text), "missing key drive.file", "case.toml");
}

}  // namespace
}  // namespace stridor::io
