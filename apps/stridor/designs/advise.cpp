#include "arguments.hpp"
#include "commands.hpp"
#include "crews.hpp"
#include "interrupt.hpp"
#include "stridor/advice/advice.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/advice_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/advice/advice_texts.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct AdviseCommand {
    CaseOptions input;
    RunsOptions runs;
    std::vector<std::string> over;        // "key", "key=from:to"
    std::vector<std::string> tolerances;  // "key=10%", "key=2 N normal"
    std::size_t samples = advice::ChanceOptions{}.samples;
    std::uint64_t seed = advice::ChanceOptions{}.seed;
    int threads = 0;
    bool json = false;
};

// "2 of 4: nearest design, 1820 runs"
std::string stage_text(const advice::AdviceProgress& progress) {
    const auto number = static_cast<std::size_t>(progress.stage);
    return fmt::format("{} of {}: {}, {} runs", number + 1, advice::advice_stage_names.size(),
                       advice::advice_stage_names[number], progress.runs);
}

advice::AdviceOptions advice_options(const parameters::Case& c, const AdviseCommand& command) {
    advice::AdviceOptions options;
    for (const std::string& text : command.over)
        options.over.push_back(io::read_asked_range(c, text));
    for (const std::string& text : command.tolerances)
        options.tolerances.push_back(io::read_asked_tolerance(c, text));
    options.runs = io::read_asked_runs(command.runs.directions, command.runs.starts);
    options.chance = {command.samples, command.seed};
    options.crew = crews(command.threads);
    return options;
}

advice::Advice advice_on(const parameters::Case& c, advice::AdviceOptions options) {
    const Interrupt interrupt;
    options.stop = interrupt.token();
    console::ShareDisplay display("advice:", console::TimeLeft::shown);
    options.progress = [&](const advice::AdviceProgress& progress) {
        display.show(progress.share, stage_text(progress));
    };
    return advice::advise(c, options);
}

void advise(const AdviseCommand& command) {
    const parameters::Case c = load_case(command.input);
    const advice::AdviceOptions options = advice_options(c, command);
    if (only_helps())
        return help_with(advice::work_of(advice::design_space(c, options.over, options.runs)), command.threads);
    const advice::Advice advice = advice_on(c, options);
    console::print(command.json ? io::advice_json(advice) + "\n" : console::advice_text(advice));
    if (command.json || !console::has_terminal() || !advice.recommended) return;
    std::string next = "next: stridor simulate " + base::shell_word(command.input.file);
    for (const std::string& text : command.input.overrides)
        next += " --set " + base::shell_word(text);
    console::say(console::styled(next + " " + advice::settings_of(advice.space, advice.changes[*advice.recommended]),
                                 console::Style::dim, 2));
}

}  // namespace

void add_advise(CLI::App& program) {
    auto command = std::make_shared<AdviseCommand>();
    CLI::App* advise_command = program.add_subcommand(
        "advise", "What keeps it quiet: margins, the smallest quieting change, the chance of noise under tolerances.");
    add_case_options(*advise_command, command->input);
    advise_command
        ->add_option("--over", command->over,
                     "change only this quantity, within its usual range (a tenth to ten times the design's value) or "
                     "FROM:TO (repeatable); without it, all that have a usual range, but none of the drive")
        ->type_name("KEY[=FROM:TO]")
        ->allow_extra_args(false);
    advise_command
        ->add_option(
            "--tolerance", command->tolerances,
            "chance of noise if a quantity lies within +-AMOUNT, evenly spread: preload=10%; with a third of it as "
            "standard deviation: \"mu_d=0.05 normal\" (repeatable); without it, of a quiet design, within the usual "
            "tolerances of parts")
        ->type_name("KEY=AMOUNT")
        ->allow_extra_args(false);
    advise_command->add_option("--samples", command->samples, "designs sampled within the tolerances")
        ->check(CLI::Range(std::size_t{1}, advice::most_samples))
        ->capture_default_str();
    advise_command->add_option("--seed", command->seed, "of the random shifts of the samples")->capture_default_str();
    add_runs_options(*advise_command, command->runs);
    add_threads_option(*advise_command, command->threads);
    add_json_option(*advise_command, command->json, "stridor.advice/1");
    advise_command->footer(
        "The change is verified by running it. A quiet design is told with the nearest change of one quantity that "
        "ends the silence, within 5 %, and with its chance of noise.\n"
        "Examples:\n  stridor advise squeal.toml\n"
        "  stridor advise squeal.toml --over preload=5:50 --over kinetic_friction\n"
        "  stridor advise quiet.toml --tolerance preload=10% --tolerance \"mu_d=0.05 normal\"");
    advise_command->callback([command] { advise(*command); });
}

}  // namespace stridor::app
