#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/results/evaluation_text.hpp"
#include "stridor/console/results/published_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/pictures/held_numbers.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/verification/check.hpp"
#include "stridor/verification/published.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct VerifyOptions {
    bool is_published = false;
    bool json = false;
    std::string figure;
    pictures::Sheet sheet;
};

void expect_none(std::size_t failed) {
    if (failed > 0)
        throw Error(ErrorKind::numerical,
                    {fmt::format("{} checks fail", failed), "this build does not compute what it should",
                     "Please report the table above with your compiler and processor."});
}

void verify() {
    console::print(console::check_heading());
    std::size_t total = 0;
    std::size_t failed = 0;
    for (const verification::CheckGroup& group : verification::check_groups()) {
        console::print(console::styled(std::string(group.title), console::Style::bold, STDOUT_FILENO) + " (" +
                       std::string(group.source) + ")\n");
        for (const verification::Check& check : group.run()) {
            console::print(console::check_row(check));
            ++total;
            failed += check.passes() ? 0 : 1;
        }
    }
    console::print(fmt::format("{} of {} checks hold\n", total - failed, total));
    expect_none(failed);
}

// words and zeros have no share
std::vector<pictures::HeldPoint> points_of(const std::vector<verification::HeldSystem>& systems) {
    std::vector<pictures::HeldPoint> points;
    for (const verification::HeldSystem& system : systems)
        for (const verification::HeldNumber& held : system.numbers) {
            const verification::PublishedNumber& number = *held.published;
            const double size = std::abs(number.theirs);
            if (is_word(number) || size == 0.0) continue;
            points.push_back({number.quantity,
                              number_text(number, number.theirs) + " | " + number_text(number, held.ours),
                              static_cast<std::size_t>(system.published->origin), number.tolerance / size,
                              std::abs(held.difference()) / size});
        }
    return points;
}

void verify_published(const VerifyOptions& options) {
    const bool json = options.json;
    std::vector<verification::HeldSystem> systems;
    std::size_t total = 0;
    std::size_t failed = 0;
    if (!json) console::print(console::published_heading());
    for (const verification::PublishedSystem& system : verification::published_systems()) {
        systems.push_back(verification::held(system));
        for (const verification::HeldNumber& number : systems.back().numbers) {
            ++total;
            failed += number.agrees() ? 0 : 1;
        }
        if (!json) console::print(console::published_text(systems.back()));
    }
    if (json)
        console::print(verification::published_json(systems) + "\n");
    else
        console::print(console::not_reproduced_text() +
                       fmt::format("{} of {} published numbers agree, {} results are not reproduced\n", total - failed,
                                   total, verification::not_reproduced().size()));
    if (!options.figure.empty())
        pictures::draw(pictures::held_numbers(points_of(systems), verification::origin_names), options.figure,
                       options.sheet);
    expect_none(failed);
}

}  // namespace

void add_verify(CLI::App& program) {
    auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = program.add_subcommand(
        "verify", "Compute the numbers this program must reproduce, and hold them against closed forms.");
    CLI::Option* published =
        command->add_flag("--published", options->is_published,
                          "hold results that others published against those of the case files in cases/published");
    add_json_option(*command, options->json, "stridor.published/1")->needs(published);
    add_figure_option(*command, options->figure, options->sheet, "draw both beside each other")->needs(published);
    command->footer("Takes about a second, with --published some seconds. Exit code 3 if any check fails.");
    command->callback([options] { options->is_published ? verify_published(*options) : verify(); });
}

}  // namespace stridor::app
