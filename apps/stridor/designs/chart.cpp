#include "arguments.hpp"
#include "commands.hpp"
#include "crews.hpp"
#include "designs/chart_run.hpp"
#include "stridor/console/results/stability_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/chart_csv.hpp"
#include "stridor/io/chart/chart_exports.hpp"
#include "stridor/io/chart/json_chart.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/diagram.hpp"
#include "stridor/sweep/study_work.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

namespace stridor::app {

namespace {

struct ChartOptions {
    CaseOptions input;
    io::AxisTexts axes;
    io::ExportTexts exports;
    std::string out;
    int threads = 0;
    bool json = false;
    bool preview = false;
    std::string share;
    SlurmOptions slurm;
    pictures::Sheet sheet;
};

void write_diagram(const sweep::SweepResult& result, const std::filesystem::path& out, const io::ChartExports& exports,
                   const ChartOptions& options) {
    const std::vector<sweep::DiagramCell> cells = compute_diagram(result, out / "diagram.sqlite", options.threads);
    if (io::holds(exports, "csv"))
        storage::write_file((out / "diagram.csv").string(), io::diagram_csv(result.study, cells));
    if (const std::vector<std::string> endings = io::picture_endings(exports); !endings.empty())
        pictures::draw_diagram(result, cells, out, endings, options.sheet);
}

void chart(const ChartOptions& options) {
    sweep::Study study = io::read_study(load_source(options.input.file, options.input.overrides), options.axes);
    if (options.preview) study = sweep::preview(std::move(study));
    if (only_helps()) {
        help_with(sweep::work_of(study), options.threads);
        if (sweep::has_one_axis(study)) help_with(sweep::diagram_work(study), options.threads);
        return;
    }
    const io::ChartExports exports = io::chart_exports(study, options.exports);
    if (!exports.left_out.empty()) console::say_note(exports.left_out);
    const std::string name =
        std::filesystem::path(options.input.file).stem().string() + (options.preview ? "-preview" : "");
    const std::filesystem::path out = options.out.empty() ? name : options.out;
    storage::make_folder(out, "Choose another --out.");
    if (options.slurm.shares > 0) return print_slurm_script(study, out, options.slurm, options.threads);
    if (!options.share.empty()) return compute_share(study, out, options.share, options.threads);
    expect_merged(study, out);
    // in a new folder it stands there from the start, for who asks how far the chart is
    const std::filesystem::path chart_file = out / "chart.toml";
    if (!std::filesystem::exists(chart_file)) storage::write_file(chart_file.string(), io::study_toml(study));
    const sweep::SweepResult result = compute(study, out / "chart.sqlite", options.threads);
    // the resolved chart, overrides included, stands beside its results: what a reproduce command runs
    storage::write_file(chart_file.string(), io::study_toml(study));
    if (const std::string failures = console::failures_text(result, chart_file.string()); !failures.empty())
        console::say(failures);
    sweep::require_result(result);
    // the pictures first: they are there whatever becomes of a table
    const std::vector<std::string> endings = io::picture_endings(exports);
    if (!sweep::has_one_axis(study))
        pictures::draw_charts(result, out, endings, options.sheet);
    else if (!endings.empty() || io::holds(exports, "csv"))
        write_diagram(result, out, exports, options);
    io::write_chart_tables(result, out, exports);
    if (!sweep::holds_design(study)) console::say(console::outside_text(study));
    if (options.json) {
        console::print(io::chart_json(result) + "\n");
        return;
    }
    console::print(console::cells_text(result) + console::starts_text(result));
    std::string line;
    for (const std::string& file : io::file_names(exports, study))
        line += (line.empty() ? "" : " ") + (out / file).string();
    console::print(line + "\n");
}

// "png, svg ... (default: png,svg; no csv above a million cells)"
std::string files_help() {
    std::string all, usual, few;
    for (const io::ChartFile& file : io::chart_files()) {
        all += (all.empty() ? "" : ", ") + std::string(file.name);
        if (file.is_usual) usual += (usual.empty() ? "" : ",") + std::string(file.name);
        if (file.is_for_few) few += "; no " + std::string(file.name) + " above a million cells";
    }
    return "what is written: " + all + " (default: " + usual + few + ")";
}

}  // namespace

void add_chart(CLI::App& program) {
    auto options = std::make_shared<ChartOptions>();
    CLI::App* command = program.add_subcommand(
        "chart",
        "Compute and draw a noise chart over two parameters, or a diagram over one; resumes where it was stopped.");
    add_case_options(*command, options->input);
    add_no_early_option(*command, options->input);
    command
        ->add_option(
            "--x", options->axes.x,
            "the axis x instead of the file's [chart]: preload=1:40, \"incidence_angle=20:85 deg:60\"; without "
            "POINTS 40, without SCALE what is usual for the quantity (linear or log)")
        ->type_name("KEY=FROM:TO[:POINTS[:SCALE]]");
    command
        ->add_option("--y", options->axes.y,
                     "the axis y, likewise; without it --x alone gives a diagram over x (200 points)")
        ->type_name("KEY=FROM:TO[:POINTS[:SCALE]]");
    add_output_folder(*command, options->out,
                      "folder for store, figures and tables (default: the file's name, with -preview for one)");
    command->add_option("--files", options->exports.files, files_help())
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NAME,...");
    command
        ->add_option("--figures", options->exports.figures,
                     "the figures in tables, beside category and status: names, or all (default: all; above a million "
                     "cells those that are drawn)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NAME,...");
    add_threads_option(*command, options->threads);
    command->add_flag("--preview", options->preview,
                      "a quick look: at most 64 by 64 points, refined, of a constant drive a quarter of the time");
    CLI::Option* json =
        add_json_option(*command, options->json, "stridor.chart/1", "print the chart as one JSON document");
    CLI::Option* share =
        command
            ->add_option("--shard", options->share,
                         "compute one share of the chart into a store of its own, counted from 0; auto: that of a task "
                         "of a Slurm array; `stridor merge` joins them")
            ->type_name("INDEX/COUNT|auto")
            ->excludes(json);
    CLI::Option* slurm = command
                             ->add_option("--slurm", options->slurm.shares,
                                          "print a job script that computes the chart in so many shares on a cluster "
                                          "with Slurm; nothing is submitted")
                             ->type_name("SHARES")
                             ->check(CLI::Range(std::size_t{1}, sweep::most_shares))
                             ->excludes(json)
                             ->excludes(share);
    add_sheet_options(*command, options->sheet);
    for (const char* drawn_last : {"--title", "--width"})
        command->get_option(drawn_last)->excludes(share)->excludes(slurm);
    command->add_option("--time", options->slurm.time, "limit of time of each of its tasks, as Slurm writes it")
        ->type_name("TIME")
        ->needs(slurm);
    command->footer(
        "The case's own values are marked as the design. The key chart.refine (0 to 6) computes cells closely only "
        "where they differ; chart.starts runs each from several starts and shows the worst.\n"
        "Ctrl-C stops and keeps all finished cells; the same command goes on. A killed run loses at most half a second "
        "of work.\n"
        "Examples:\n  stridor chart squeal.toml --x preload=1:40 --y mu_d=0.2:0.8 --out pair\n"
        "  stridor chart squeal.toml --x mu_d=0:0.8 --out friction\n"
        "  stridor init noise-chart -o pair.toml\n  stridor chart pair.toml --out pair\n"
        "  stridor chart pair.toml --out quick --set chart.x.points=12 --set chart.y.points=12\n"
        "  stridor chart pair.toml --out pair --files nc,png --figures frequency,joint_level\n"
        "  stridor chart pair.toml --out pair --shard 3/16\n"
        "  stridor chart pair.toml --out pair --slurm 16 --time 2:00:00 | sbatch");
    command->callback([options] { chart(*options); });
}

}  // namespace stridor::app
