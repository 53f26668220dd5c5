#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/following_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/simulation/followed_motion.hpp"
#include "stridor/pictures/following.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/sweep/following.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct FollowOptions {
    CaseOptions input;
    std::string over;  // "key=from:to[:points]"
    std::string of = "stick";
    std::string figure;
    std::string csv;
    pictures::Sheet sheet;
    bool json = false;
};

sweep::Following followed(const parameters::Case& c, const FollowOptions& options, const Interrupt& interrupt) {
    console::ShareDisplay display("followed:", console::TimeLeft::shown);
    const auto show = [&](std::size_t done, std::size_t all) {
        display.show(static_cast<double>(done) / static_cast<double>(all));
    };
    return at_option("--over", options.over, [&] {
        return sweep::follow(c, io::read_scan_range(options.over), {interrupt.token(), show});
    });
}

const sweep::CellFigure& figure_named(const std::string& name) {
    std::vector<std::string_view> names;
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        names.push_back(figure.name);
    return sweep::cell_figures()[base::place_of_choice("--of", name, names)];
}

void follow(const FollowOptions& options) {
    const sweep::CellFigure& figure = figure_named(options.of);
    const parameters::Case c = load_case(options.input);
    const Interrupt interrupt;
    const sweep::Following following = followed(c, options, interrupt);
    if (!options.figure.empty()) pictures::draw(pictures::following(following, figure), options.figure, options.sheet);
    if (!options.csv.empty()) console::write_output(options.csv, io::following_csv(following));
    console::print(options.json ? io::following_json(following) + "\n" : console::following_text(following));
}

}  // namespace

void add_follow(CLI::App& program) {
    auto options = std::make_shared<FollowOptions>();
    CLI::App* command = program.add_subcommand(
        "follow", "Follow a motion along a quantity, up and then down, each run from the end of the one before.");
    add_case_options(*command, options->input);
    command->add_option("--over", options->over, "the quantity and its values; ends may carry units")
        ->type_name("KEY=FROM:TO[:POINTS]")
        ->required();
    command->add_option("--of", options->of, "the figure that is drawn")->type_name("FIGURE")->capture_default_str();
    add_figure_option(*command, options->figure, options->sheet, "draw it over the quantity");
    add_csv_option(*command, options->csv, "write all figures of each run to FILE.csv");
    add_json_option(*command, options->json, "stridor.following/1");
    command->footer(
        "Where the ways up and down have other verdicts the system has hysteresis: what it does depends on its "
        "history.\n"
        "Examples:\n  stridor follow squeal.toml --over drive.velocity=0.05:0.5\n"
        "  stridor follow squeal.toml --over \"preload=5 N:50 N:91\" --figure hysteresis.png");
    command->callback([options] { follow(*options); });
}

}  // namespace stridor::app
