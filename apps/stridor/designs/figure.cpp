#include "arguments.hpp"
#include "commands.hpp"
#include "designs/chart_run.hpp"
#include "interrupt.hpp"
#include "sounds/compare.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/own_structure/toml_structure.hpp"
#include "stridor/io/structure/mode_files.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/pictures/contact_states.hpp"
#include "stridor/pictures/friction_law.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/modes.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/time_history.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/ready_charts.hpp"

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
    pictures::Sheet sheet;
};

void draw_and_tell(const drawing::Scene& scene, const PaperOptions& options, const char* name, const char* what) {
    const std::filesystem::path stem = std::filesystem::path(options.out) / name;
    pictures::draw_both(scene, stem, options.sheet);
    console::print(fmt::format("{0}.png {0}.svg  {1}\n", stem.string(), what));
}

// pictures in the order of what they cost, so that something is there to look at soon
void draw_paper(const PaperOptions& options) {
    const std::filesystem::path out(options.out);
    storage::make_folder(out, "Choose another --out.");
    {
        const Interrupt interrupt;
        const Case squeal = parameters::paper_case(PaperCase::squeal);
        draw_and_tell(pictures::friction_law(squeal.contact()), options, "figure-3", "friction law");
        draw_and_tell(pictures::motion_scene(
                          squeal, recorded(squeal, {0.0, squeal.run.duration, trace_interval}, interrupt.token()), {}),
                      options, "figure-5", "time history of the squeal case with its contact states");
        std::vector<NamedCase> cases;
        for (const PaperCase which : {PaperCase::quiet, PaperCase::squeal, PaperCase::squeak, PaperCase::creak})
            cases.emplace_back(
                which == PaperCase::quiet ? "no noise" : parameters::paper_case_names[static_cast<std::size_t>(which)],
                parameters::paper_case(which));
        // long enough for ten slips of the creak, short enough to see single stays of the squeal
        draw_and_tell(states_scene(cases, pictures::telling_stretch(squeal, 40e-3), interrupt.token()), options,
                      "figure-7", "contact states of the four cases of Table 1");
    }
    std::vector<sweep::SweepResult> maps;
    for (const double angle : {70.0, 150.0})
        maps.push_back(
            compute(sweep::figure_6(angle), out / fmt::format("figure-6-{:g}.sqlite", angle), options.threads));
    draw_and_tell(pictures::rate_map(maps), options, "figure-6",
                  "contact-state rates over velocity and preload, 70 and 150 deg");
    const sweep::SweepResult pair = compute(sweep::figure_8(), out / "figure-8.sqlite", options.threads);
    draw_and_tell(pictures::noise_chart(pair), options, "figure-8", "noise charts over preload and kinetic friction");
}

struct OneFigureOptions {
    CaseOptions input;
    std::string output = "figure.png";
    pictures::Sheet sheet;
};

void draw(const drawing::Scene& scene, const OneFigureOptions& options) {
    pictures::draw(scene, options.output, options.sheet);
}

CLI::App* add_one(CLI::App& figure, const char* name, const char* description,
                  const std::shared_ptr<OneFigureOptions>& options) {
    CLI::App* command = figure.add_subcommand(name, description);
    add_case_options(*command, options->input);
    add_output_file(*command, options->output, "FILE.png, FILE.svg or FILE.pdf")->capture_default_str();
    add_sheet_options(*command, options->sheet);
    return command;
}

struct LawOptions {
    OneFigureOptions figure;
    bool has_visited = false;
};

// [1] samples of the window: extremes of a slip that lasts a thousandth of it are met within a percent
constexpr double law_samples = 1e5;

void draw_law(const LawOptions& options) {
    const Case c = load_case(options.figure.input);
    if (!options.has_visited) return draw(pictures::friction_law_of(c), options.figure);
    const Interrupt interrupt;
    const record::TraceRequest judged{c.run.duration - c.run.window, c.run.duration, c.run.window / law_samples};
    draw(pictures::friction_law_of(c, pictures::visited_velocities(c, recorded(c, judged, interrupt.token()).trace)),
         options.figure);
}

void draw_states(const OneFigureOptions& options) {
    const Case c = load_case(options.input);
    const Interrupt interrupt;
    if (pictures::shows_many_contacts(c))
        return draw(pictures::motion_scene(c, recorded(c, {}, interrupt.token()), ""), options);
    draw(states_scene({{c.title.empty() ? options.input.file : c.title, c}}, {0.0, c.run.duration}, interrupt.token()),
         options);
}

struct ModesOptions {
    OneFigureOptions figure;
    std::string mesh;  // deck with the elements
};

void draw_modes(const ModesOptions& options) {
    const io::TomlSource source = load_source(options.figure.input.file, options.figure.input.overrides);
    const analysis::StabilityScan scan =
        analysis::with_modes(analysis::scan_stability(io::read_case(source), std::nullopt));
    const std::string& file = options.figure.output;
    const io::ModeFiles kind = io::mode_files_of(file);
    if (kind == io::ModeFiles::none) return draw(pictures::mode_shapes(scan), options.figure);
    const io::NodeMesh mesh = io::node_mesh(io::part_of_case(io::parse_toml(source)), options.mesh);
    if (mesh.left_out > 0)
        console::say(
            fmt::format("stridor: note: {} of {} elements have nodes whose motion was not kept and are left "
                        "out. Reduce the part with --recover and a set of all nodes.",
                        mesh.left_out, mesh.left_out + mesh.elements.size()));
    io::write_modes(file, kind, mesh, scan);
}

void add_mode_shapes(CLI::App& figure) {
    auto options = std::make_shared<ModesOptions>();
    auto shared = std::shared_ptr<OneFigureOptions>(options, &options->figure);
    CLI::App* command = add_one(
        figure, "mode-shapes",
        "Modes of steady sliding: motion of the contacts, what each adds to the growth, free modes they are made of; "
        "of a finite-element part also as .vtu (real and imaginary part) or .pvd (a cycle in 24 steps) for ParaView.",
        shared);
    command->add_option("--mesh", options->mesh, "deck of CalculiX or Abaqus whose elements a .vtu or .pvd shows")
        ->type_name("FILE.inp");
    command->callback([options] { draw_modes(*options); });
}

struct ModalOptions {
    OneFigureOptions figure;
    hearing::AskedMotion asked;
};

void draw_modal_spectrum(const ModalOptions& options) {
    const Case c = load_case(options.figure.input);
    const Interrupt interrupt;
    const hearing::HeardModes heard = hearing::heard_modes(c, options.asked, interrupt.token());
    draw(pictures::modal_spectrum(c.title, heard.of, heard.modes, heard.spectrum), options.figure);
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
    add_sheet_options(*all, paper->sheet);
    all->callback([paper] { draw_paper(*paper); });

    auto law = std::make_shared<LawOptions>();
    CLI::App* friction =
        add_one(*figure, "friction-law", "Friction over relative velocity (Figure 3).", {law, &law->figure});
    friction->add_flag("--visited", law->has_visited,
                       "compute the motion, too, and shade the velocities at which it slips");
    friction->callback([law] { draw_law(*law); });
    auto states = std::make_shared<OneFigureOptions>();
    add_one(*figure, "contact-states", "Contact states over time (Figure 7).", states)->callback([states] {
        draw_states(*states);
    });
    add_mode_shapes(*figure);
    add_modal_spectrum(*figure);
    add_figure_compare(*figure);
    figure->footer(
        "A time history (Figure 5) is drawn by `stridor simulate CASE --figure`, a chart (Figures 6, 8) by `stridor "
        "chart`, modes by "
        "`stridor stability CASE --over ... --figure`.\n"
        "Examples:\n  stridor figure paper --out figures\n  stridor figure contact-states creak.toml -o creak.svg\n"
        "  stridor figure contact-states creak.toml --title none --width \"85 mm\" -o creak.pdf\n"
        "  stridor figure mode-shapes lip.toml --mesh lip.inp -o modes.pvd\n"
        "  stridor figure compare vehicle.wav rig.wav squeal.toml -o figure-4.png");
}

}  // namespace stridor::app
