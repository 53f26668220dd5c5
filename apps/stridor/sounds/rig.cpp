#include "sounds/rig.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "library/library.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/results/rig_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/library/library_texts.hpp"
#include "stridor/io/simulation/fitted_friction.hpp"
#include "stridor/io/simulation/friction_test.hpp"
#include "stridor/io/simulation/rig_risk.hpp"
#include "stridor/noise_library/sensitivity.hpp"
#include "stridor/pictures/friction_fit.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/sensitivity.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct FrictionOptions {
    io::FrictionFitTexts texts;
    std::string fit;  // the law that was asked for, or best; empty: none is fitted
    bool risk = false;
    std::vector<std::string> ranges;
    io::PairConditions pair;
    std::string into;
    std::string figure;
    pictures::Sheet sheet;
    bool json = false;
};

void fit_friction(const FrictionOptions& options) {
    io::FrictionFitTexts texts = options.texts;
    texts.temperature = options.pair.temperature;
    const io::FittedFriction fitted = io::fitted_friction(texts, console::say_note);
    const std::size_t law = options.fit == "best" ? fitted.fit.best : analysis::law_called(fitted.fit, options.fit);
    if (!options.figure.empty())
        pictures::draw(fitted.over ? pictures::friction_over_conditions(*fitted.over, law)
                                   : pictures::friction_fit(fitted.fit, law),
                       options.figure, options.sheet);
    if (!options.into.empty()) {
        console::print_data(io::case_with_law(io::read_case(load_source(options.into)), fitted, law));
        console::say(fitted.over ? analysis::words_of(*fitted.over) : analysis::words_of(fitted.fit));
        return;
    }
    console::print(options.json ? io::friction_fit_json(fitted, law) + "\n" : console::friction_fit_text(fitted, law));
}

void friction(const FrictionOptions& options) {
    const io::FrictionFitTexts& texts = options.texts;
    if (options.fit.empty() && !options.risk && !(texts.mass + texts.stiffness + texts.damping).empty())
        base::refuse("--mass, --stiffness and --damping say nothing here", "they are for a fit or a risk number",
                     "Add --fit best or --risk?");
    if (!options.pair.temperature.empty() && options.fit.empty() && options.pair.name.empty())
        base::refuse("--temperature says nothing here", "it is for a fit or the row of a pair",
                     "Add --fit best or --pair NAME?");
    if (!options.fit.empty() && !options.pair.name.empty()) {
        console::print_data(io::pair_rows_of_law(texts, options.pair, options.fit, console::say_note));
        return;
    }
    if (!options.fit.empty()) {
        fit_friction(options);
        return;
    }
    if (options.risk) {
        const io::RigRisk risk = io::rig_risk(options.texts, options.ranges, console::say_note);
        console::print(options.json ? io::rig_risk_json(risk) + "\n" : console::risk_text(risk));
        return;
    }
    if (!options.pair.name.empty()) {
        console::print_data(io::pair_rows(options.texts, options.pair, console::say_note));
        return;
    }
    if (options.texts.files.size() > 1)
        base::refuse("there are " + std::to_string(options.texts.files.size()) + " files",
                     "one is read at a time, but for a fit, a risk number or rows of a pair",
                     "Add --fit best, --risk or --pair NAME?");
    const io::MeasuredFriction measured =
        io::measured_friction(io::texts_of_files(options.texts).front(), console::say_note);
    const analysis::FrictionTrace& trace = measured.trace;
    if (!options.into.empty()) {
        console::print_data(io::case_with_friction(io::read_case(load_source(options.into)), measured));
        console::say(fmt::format("static {}, kinetic {}", console::coefficient_text(trace.all.static_friction),
                                 console::coefficient_text(trace.all.kinetic_friction)));
        return;
    }
    console::print(options.json ? io::friction_json(measured.test, trace) + "\n"
                                : console::friction_text(measured.test, trace));
}

using noise_library::Sensitivity;

struct SensitivityCommand {
    LibraryOption library;
    SelectionOptions selection;
    std::string over = "preload";
    std::size_t bins = 0;
    std::string by = "category";
    std::string figure;
    pictures::Sheet sheet;
    bool records = false;
    bool json = false;
};

void run_sensitivity(const SensitivityCommand& command) {
    noise_library::Library library =
        noise_library::open_library(command.library.file, noise_library::Access::read, waiting());
    noise_library::SensitivityOptions options;
    options.quantity = command.over;
    options.bins = command.bins;
    options.judge = command.by == "category" ? noise_library::Judge::stridor : noise_library::Judge::engineer;
    const Sensitivity result = noise_library::sensitivity_in(library, query_of(command.selection), options);
    if (!command.figure.empty()) pictures::draw(pictures::sensitivity(result), command.figure, command.sheet);
    console::print(command.json ? io::sensitivity_json(library.file(), result) + "\n"
                                : console::sensitivity_text(result, command.records ? console::SensitivityRows::records
                                                                                    : console::SensitivityRows::bins));
}

}  // namespace

void add_rig(CLI::App& program) {
    CLI::App* rig =
        program.add_subcommand("rig", "Measurements on a test rig: friction from a force, and what moves the noise.");
    rig->require_subcommand(1);
    add_rig_friction(*rig);
    add_rig_sensitivity(*rig);
}

void add_rig_friction(CLI::App& rig) {
    auto options = std::make_shared<FrictionOptions>();
    CLI::App* command =
        rig.add_subcommand("friction", "Friction coefficients and force drops of a measured friction force.");
    command->add_option("file", options->texts.files, "measurement: CSV, UFF58 or WAV; - reads stdin; several to fit")
        ->required();
    io::FrictionTexts& shared = options->texts.shared;
    command
        ->add_option("--preload", shared.preload,
                     "force that presses the parts together; of several files \"10 N, 40 N\"")
        ->type_name("FORCE")
        ->required();
    command->add_option("--channel", shared.channel, "the friction force: name or number (default: the only one in N)")
        ->type_name("NAME|NUMBER");
    command
        ->add_option("--velocity-channel", shared.velocity_channel,
                     "the imposed velocity (default: the only one in m/s)")
        ->type_name("NAME|NUMBER");
    command
        ->add_option("--normal-channel", shared.normal_channel,
                     "the pressing force (default: the one that says so, else the preload)")
        ->type_name("NAME|NUMBER");
    command
        ->add_option("--velocity", shared.velocity, "nominal velocity of the test; of several files \"1 mm/s, 4 mm/s\"")
        ->type_name("VELOCITY");
    command->add_option("--full-scale", shared.full_scale, "what 1 in an uncalibrated file stands for")
        ->type_name("VALUE");
    command->add_option("--least-drop", shared.least_drop, "smallest drop, as a share of the force's level")
        ->check(CLI::Range(1e-4, 1.0))
        ->capture_default_str();
    command->add_option("--longest-drop", shared.longest_drop, "a fall that takes longer is drift")
        ->type_name("TIME")
        ->capture_default_str();
    std::vector<std::string> laws{"best"};
    laws.insert(laws.end(), analysis::fitted_names.begin(), analysis::fitted_names.end());
    CLI::Option* fit =
        command->add_option("--fit", options->fit, "fit the laws over the speed of slip, and use this or the best one")
            ->check(one_of(laws));
    CLI::Option* figure =
        add_figure_option(*command, options->figure, options->sheet, "draw points, laws and what is left");
    figure->needs(fit);
    CLI::Option* risk =
        command->add_flag("--risk", options->risk, "a number from 1 to 10 for each run, and what the model says")
            ->excludes(fit);
    command->add_option("--risk-range", options->ranges, "other ends of a figure's ranks, \"impulse_rate=0.1:50\"")
        ->type_name("FIGURE=FROM:TO")
        ->allow_extra_args(false)
        ->needs(risk);
    command->add_option("--mass", options->texts.mass, "the rig's moving mass, for --risk and --fit; or fit")
        ->type_name("MASS");
    command->add_option("--stiffness", options->texts.stiffness, "of the rig's spring, for the same; or fit")
        ->type_name("STIFFNESS");
    command->add_option("--damping", options->texts.damping, "of the rig (default: none)")->type_name("DAMPING");
    CLI::Option* pair =
        command
            ->add_option("--pair", options->pair.name,
                         "print rows of pairs.toml, of this pair; with --fit they have the law's numbers")
            ->type_name("NAME")
            ->excludes(risk)
            ->excludes(figure);
    command
        ->add_option("--temperature", options->pair.temperature,
                     "of the test, for --fit and --pair; of several files \"23 degC, 60 degC\"")
        ->type_name("TEMPERATURE")
        ->excludes(risk);
    command->add_option("--humidity", options->pair.humidity, "of the test, for the row; of several files a list")
        ->type_name("HUMIDITY")
        ->needs(pair);
    CLI::Option* into =
        command->add_option("--into", options->into, "print this case with the coefficients, or the law, put in")
            ->type_name("CASE")
            ->excludes(risk)
            ->excludes(pair);
    add_json_option(*command, options->json,
                    "stridor.friction/1, with --fit stridor.friction-fit/1, with --risk stridor.friction-risk/1")
        ->excludes(into)
        ->excludes(pair);
    command->footer(
        "Examples:\n  stridor rig friction seal.csv --preload \"10 N\" --velocity \"4 mm/s\"\n"
        "  stridor rig friction seal.uff --preload \"40 N\" --channel \"friction force\" --json\n"
        "  stridor rig friction seal.csv --preload \"10 N\" --into seal.toml > measured.toml\n"
        "  stridor rig friction slow.csv fast.csv --preload \"10 N\" --velocity \"1 mm/s, 20 mm/s\" --fit best");
    command->callback([options] { friction(*options); });
}

void add_rig_sensitivity(CLI::App& rig) {
    auto options = std::make_shared<SensitivityCommand>();
    CLI::App* command = rig.add_subcommand(
        "sensitivity", "How category, level and dominant frequency move over a quantity across records of a library.");
    command
        ->add_option("--over", options->over,
                     "preload, velocity, temperature, humidity, or any other number of the records")
        ->type_name("FIELD")
        ->capture_default_str();
    add_selection_options(*command, options->selection);
    command->add_option("--bins", options->bins, "number of bins (default: a bin per value up to 10 values, else 6)")
        ->check(CLI::Range(1, 1000));
    command->add_option("--by", options->by, "whose word counts: category (Stridor's) or denomination (the engineer's)")
        ->check(one_of({"category", "denomination"}))
        ->capture_default_str();
    command->add_flag("--records", options->records, "a row per record instead of bins");
    add_figure_option(*command, options->figure, options->sheet, "draw the records");
    add_json_option(*command, options->json, "stridor.sensitivity/1");
    add_library_option(*command, options->library);
    command->footer(
        "Level and dominant frequency are the figures `level` and `dominant_frequency` of an entry.\n"
        "Examples:\n  stridor rig sensitivity --over preload --where \"recorded = rig\" --figure preload.png\n"
        "  stridor rig sensitivity --over temperature --by denomination --records");
    command->callback([options] { run_sensitivity(*options); });
}

}  // namespace stridor::app
