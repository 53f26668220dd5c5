#include "arguments.hpp"
#include "commands.hpp"
#include "designs/chart_run.hpp"
#include "interrupt.hpp"
#include "sounds/compare.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/heard_modes.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/pictures/contact_states.hpp"
#include "stridor/pictures/friction_law.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/modal_spectrum.hpp"
#include "stridor/pictures/mode_shapes.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/rate_map.hpp"
#include "stridor/pictures/time_history.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/paper_charts.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace stridor::app {

namespace {

using parameters::Case;
using parameters::PaperCase;

constexpr double trace_interval = 20e-6;  // [s] 50 samples a period at 1 kHz

record::Record recorded(const Case& c, const record::TraceRequest& trace, const std::stop_token& stop) {
    integration::Motion motion = integration::simulate(c, {record::KeepHistory::yes, trace}, stop);
    if (const std::optional<Error> failure = integration::failure(c, motion)) {
        base::Problem problem = failure->problem();
        problem.what = "\"" + c.title + "\": " + problem.what;
        throw Error(failure->kind(), problem);
    }
    return std::move(motion.record);
}

using NamedCase = std::pair<std::string, Case>;

drawing::Scene states_scene(const std::vector<NamedCase>& cases, const drawing::Extent& time,
                            const std::stop_token& stop) {
    std::vector<pictures::StatesOfCase> states;
    for (const auto& [name, c] : cases)
        states.push_back({name, c, recorded(c, {}, stop).histories});
    return pictures::contact_states(states, time);
}

struct PaperOptions {
    std::string out = "figures";
    int threads = 0;
};

void announce(const std::filesystem::path& stem, const char* what) {
    console::print(fmt::format("{0}.png {0}.svg  {1}\n", stem.string(), what));
}

// pictures in the order of what they cost, so that something is there to look at soon
void draw_paper(const PaperOptions& options) {
    const std::filesystem::path out(options.out);
    storage::make_folder(out, "Choose another --out.");
    {
        const Interrupt interrupt;
        const Case squeal = parameters::paper_case(PaperCase::squeal);
        pictures::draw_both(pictures::friction_law(squeal.contact), out / "figure-3");
        announce(out / "figure-3", "friction law");
        pictures::draw_both(
            pictures::motion_scene(squeal,
                                   recorded(squeal, {0.0, squeal.run.duration, trace_interval}, interrupt.token()), {}),
            out / "figure-5");
        announce(out / "figure-5", "time history of the squeal case with its contact states");
        std::vector<NamedCase> cases;
        for (const PaperCase which : {PaperCase::quiet, PaperCase::squeal, PaperCase::squeak, PaperCase::creak})
            cases.emplace_back(
                which == PaperCase::quiet ? "no noise" : parameters::paper_case_names[static_cast<std::size_t>(which)],
                parameters::paper_case(which));
        // long enough for ten slips of the creak, short enough to see single stays of the squeal
        pictures::draw_both(states_scene(cases, pictures::telling_stretch(squeal, 40e-3), interrupt.token()),
                            out / "figure-7");
        announce(out / "figure-7", "contact states of the four cases of Table 1");
    }
    std::vector<sweep::SweepResult> maps;
    for (const double angle : {70.0, 150.0})
        maps.push_back(
            compute(sweep::figure_6(angle), out / fmt::format("figure-6-{:g}.sqlite", angle), options.threads));
    pictures::draw_both(pictures::rate_map(maps), out / "figure-6");
    announce(out / "figure-6", "contact-state rates over velocity and preload, 70 and 150 deg");
    const sweep::SweepResult pair = compute(sweep::figure_8(), out / "figure-8.sqlite", options.threads);
    pictures::draw_both(pictures::noise_chart(pair), out / "figure-8");
    announce(out / "figure-8", "noise charts over preload and kinetic friction");
}

struct OneFigureOptions {
    CaseOptions input;
    std::string output = "figure.png";
};

CLI::App* add_one(CLI::App& figure, const char* name, const char* description,
                  const std::shared_ptr<OneFigureOptions>& options) {
    CLI::App* command = figure.add_subcommand(name, description);
    add_case_options(*command, options->input);
    add_output_file(*command, options->output, "FILE.png, FILE.svg or FILE.pdf")->capture_default_str();
    return command;
}

void draw_law(const OneFigureOptions& options) {
    pictures::draw(pictures::friction_law_of(load_case(options.input)), options.output);
}

void draw_states(const OneFigureOptions& options) {
    const Case c = load_case(options.input);
    const Interrupt interrupt;
    if (pictures::shows_many_contacts(c))
        return pictures::draw(pictures::motion_scene(c, recorded(c, {}, interrupt.token()), ""), options.output);
    pictures::draw(
        states_scene({{c.title.empty() ? options.input.file : c.title, c}}, {0.0, c.run.duration}, interrupt.token()),
        options.output);
}

void draw_modes(const OneFigureOptions& options) {
    const Case c = load_case(options.input);
    pictures::draw(pictures::mode_shapes(analysis::with_modes(analysis::scan_stability(c, std::nullopt))),
                   options.output);
}

struct ModalOptions {
    OneFigureOptions figure;
    hearing::AskedMotion asked;
};

void draw_modal_spectrum(const ModalOptions& options) {
    const Case c = load_case(options.figure.input);
    const Interrupt interrupt;
    const hearing::HeardModes heard = hearing::heard_modes(c, options.asked, interrupt.token());
    pictures::draw(pictures::modal_spectrum(c.title, heard.of, heard.modes, heard.spectrum), options.figure.output);
}

void add_modal_spectrum(CLI::App& figure) {
    auto options = std::make_shared<ModalOptions>();
    auto shared = std::shared_ptr<OneFigureOptions>(options, &options->figure);
    CLI::App* command = add_one(
        figure, "modal-spectrum",
        "Spectrum of a velocity, and which free modes (of the structure with open contacts) carry its lines.", shared);
    command
        ->add_option("--of", options->asked.of,
                     "joint (what rubs; of several contacts the strongest), plate, or the name of a contact, output "
                     "or row")
        ->type_name("joint|plate|NAME")
        ->capture_default_str();
    command->add_option("--component", options->asked.component, "x along the surface, y across it")
        ->check(one_of({"x", "y"}));
    command->callback([options] { draw_modal_spectrum(*options); });
}

}  // namespace

void add_figure(CLI::App& program) {
    CLI::App* figure = program.add_subcommand("figure", "Draw the figures of the paper, or a single one of a case.");
    figure->require_subcommand(1);

    auto paper = std::make_shared<PaperOptions>();
    CLI::App* all = figure->add_subcommand(
        "paper", "Figures 3, 5, 6, 7 and 8 of the paper from its own cases (a few seconds on two cores).");
    add_output_folder(*all, paper->out, "folder")->capture_default_str();
    add_threads_option(*all, paper->threads);
    all->callback([paper] { draw_paper(*paper); });

    auto law = std::make_shared<OneFigureOptions>();
    add_one(*figure, "friction-law", "Friction over relative velocity (Figure 3).", law)->callback([law] {
        draw_law(*law);
    });
    auto states = std::make_shared<OneFigureOptions>();
    add_one(*figure, "contact-states", "Contact states over time (Figure 7).", states)->callback([states] {
        draw_states(*states);
    });
    auto modes = std::make_shared<OneFigureOptions>();
    add_one(
        *figure, "mode-shapes",
        "Modes of steady sliding: motion of the contacts, what each adds to the growth, free modes they are made of.",
        modes)
        ->callback([modes] { draw_modes(*modes); });
    add_modal_spectrum(*figure);
    add_figure_compare(*figure);
    figure->footer(
        "A time history (Figure 5) is drawn by `stridor simulate CASE --figure`, a chart (Figures 6, 8) by `stridor "
        "chart`, modes by "
        "`stridor stability CASE --over ... --figure`.\n"
        "Examples:\n  stridor figure paper --out figures\n  stridor figure contact-states creak.toml -o creak.svg\n"
        "  stridor figure compare vehicle.wav rig.wav squeal.toml -o figure-4.png");
}

}  // namespace stridor::app
