#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/advice/advice.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/advice_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/advice/json_advice.hpp"
#include "stridor/io/chart/range_text.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct AdviseCommand {
    CaseOptions input;
    std::vector<std::string> over;        // "key", "key=from:to"
    std::vector<std::string> tolerances;  // "key=10%", "key=2 N normal"
    std::size_t samples = advice::ChanceOptions{}.samples;
    std::uint64_t seed = advice::ChanceOptions{}.seed;
    int threads = 0;
    bool json = false;
};

Error unreadable(const std::string& option, const std::string& text, const std::string& expected,
                 const std::string& example) {
    return {ErrorKind::input, {option + " \"" + text + "\" cannot be read", "expected " + expected, example}};
}

std::string_view unit_named(const parameters::Case& c, const std::string& name) {
    return parameters::unit_of(advice::quantity_named(c, name));
}

advice::AskedRange range_from(const parameters::Case& c, const std::string& text) {
    const std::optional<io::RangeText> said = io::split_range(text);
    if (!said) return {std::string(base::trimmed(text))};
    if (said->parts.size() != 2)
        throw unreadable("--over", text, "KEY or KEY=FROM:TO", "For example contact.kinetic_friction=0:0.8.");
    advice::AskedRange range{std::string(said->key)};
    const io::RangeEnds ends = io::read_range_ends(said->parts[0], said->parts[1], unit_named(c, range.name));
    range.from = ends.from;
    range.to = ends.to;
    return range;
}

// "10%", "10 % normal", "2 N"
advice::AskedTolerance tolerance_from(const parameters::Case& c, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw unreadable("--tolerance", text, "KEY=AMOUNT, in percent or with a unit", "For example preload=10%.");
    advice::AskedTolerance tolerance{std::string(base::trimmed(text.substr(0, equals)))};
    std::string amount(base::trimmed(text.substr(equals + 1)));
    for (std::size_t k = 0; k < advice::spread_names.size(); ++k) {
        const std::string_view name = advice::spread_names[k];
        if (!amount.ends_with(name)) continue;
        tolerance.spread = static_cast<advice::Spread>(k);
        amount = std::string(base::trimmed(amount.substr(0, amount.size() - name.size())));
    }
    if (amount.empty())
        throw unreadable("--tolerance", text, "KEY=AMOUNT, in percent or with a unit", "For example preload=10%.");
    if (amount.ends_with('%'))
        tolerance.relative = base::parse_quantity(amount, "1");
    else
        tolerance.absolute = base::parse_quantity(amount, unit_named(c, tolerance.name));
    return tolerance;
}

// what is wrong with an option is told with the option's name
template <typename Read>
auto named(const char* option, const std::string& text, Read read) {
    try {
        return read();
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), base::Place{option, 0, 0, text});
    }
}

// "2 of 4: nearest design, 1820 runs"
std::string stage_text(const advice::AdviceProgress& progress) {
    const auto number = static_cast<std::size_t>(progress.stage);
    return fmt::format("{} of {}: {}, {} runs", number + 1, advice::advice_stage_names.size(),
                       advice::advice_stage_names[number], progress.runs);
}

advice::Advice advice_on(const parameters::Case& c, const AdviseCommand& command) {
    advice::AdviceOptions options;
    for (const std::string& text : command.over)
        options.over.push_back(named("--over", text, [&] { return range_from(c, text); }));
    for (const std::string& text : command.tolerances)
        options.tolerances.push_back(named("--tolerance", text, [&] { return tolerance_from(c, text); }));
    options.chance = {command.samples, command.seed};
    options.threads = command.threads;
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
    const advice::Advice advice = advice_on(c, command);
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
                     "change only this quantity, within its usual range or FROM:TO (repeatable); without it, all that "
                     "have a usual range")
        ->type_name("KEY[=FROM:TO]")
        ->allow_extra_args(false);
    advise_command
        ->add_option(
            "--tolerance", command->tolerances,
            "chance of noise if a quantity lies within +-AMOUNT: preload=10%, \"mu_d=0.05 normal\" (repeatable)")
        ->type_name("KEY=AMOUNT")
        ->allow_extra_args(false);
    advise_command->add_option("--samples", command->samples, "designs sampled within the tolerances")
        ->check(CLI::Range(std::size_t{1}, advice::most_samples))
        ->capture_default_str();
    advise_command->add_option("--seed", command->seed, "of the random shifts of the samples")->capture_default_str();
    advise_command->add_option("--threads", command->threads, "number of threads (default: one per processor)")
        ->check(CLI::Range(0, 4096));
    advise_command->add_flag("--json", command->json, "print one JSON document (schema stridor.advice/1)");
    advise_command->footer(
        "Examples:\n  stridor advise squeal.toml\n"
        "  stridor advise squeal.toml --over preload=5:50 --over kinetic_friction\n"
        "  stridor advise quiet.toml --tolerance preload=10% --tolerance \"mu_d=0.05 normal\"");
    advise_command->callback([command] { advise(*command); });
}

}  // namespace stridor::app
