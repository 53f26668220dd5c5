#include "commands.hpp"
#include "figures.hpp"
#include "library.hpp"
#include "rig.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/figures/sensitivity.hpp"
#include "stridor/io/library/json_library.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/sensitivity.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace stridor::app {

namespace {

using noise_library::Bin;
using noise_library::CategoryRange;
using noise_library::RankCorrelation;
using noise_library::Sensitivity;

struct SensitivityCommand {
    LibraryOption library;
    SelectionOptions selection;
    std::string over = "preload";
    std::size_t bins = 0;
    std::string by = "category";
    std::string figure;
    bool records = false;
    bool json = false;
};

// the unit of what the records are laid out over; throws for what is no number
std::string unit_over(const std::string& name, noise_library::Library& library) {
    const noise_library::Field* field = noise_library::find_field(name);
    if (field != nullptr && std::holds_alternative<noise_library::Quantity>(field->kind))
        return std::string(unit_of(*field));
    std::vector<std::string> names = noise_library::field_names(
        [](const noise_library::Field& each) { return std::holds_alternative<noise_library::Quantity>(each.kind); });
    for (const noise_library::FigureKind& figure : library.figures()) {
        if (figure.name == name) return figure.unit;
        names.push_back(figure.name);
    }
    throw Error(ErrorKind::input,
                {"--over " + name + " is no quantity",
                 field == nullptr ? "there is no field or figure of that name" : "it is words",
                 base::did_you_mean(name, names, "`stridor library fields` lists them, with units.")});
}

std::string with_unit(const std::string& unit) {
    return unit.empty() || unit == "1" ? "" : " " + unit;
}

std::string number(double value, const char* missing = "-") {
    return std::isnan(value) ? missing : fmt::format("{:.5g}", value);
}

std::string name_of(const std::string& category) {
    return category.empty() ? "unknown" : category;
}

std::string range_text(const Bin& bin) {
    return bin.from == bin.to ? number(bin.from) : number(bin.from) + " to " + number(bin.to);
}

// letters of a range of `Bin`s, wide enough for them all
std::size_t widest(const Sensitivity& result) {
    std::size_t width = result.quantity.size();
    for (const Bin& bin : result.bins)
        width = std::max(width, range_text(bin).size());
    return width;
}

std::string bins_table(const Sensitivity& result) {
    const std::size_t width = widest(result);
    const std::size_t level_width = std::max<std::size_t>(10, result.level_unit.size());
    const auto line = [&](const std::string& range, const std::string& records, const std::string& level,
                          const std::string& frequency) {
        return fmt::format("{:>{}}  {:>7}  {:>{}}  {:>10}", range, width, records, level, level_width, frequency);
    };
    std::string names = line(result.quantity, "records", "level", "frequency");
    std::string units = line(result.unit == "1" ? "" : result.unit, "", result.level_unit, "Hz");
    for (const CategoryRange& category : result.categories)
        names += "  " + name_of(category.category);
    std::string text = styled(names, Style::bold, STDOUT_FILENO) + "\n" + units + "\n";
    for (const Bin& bin : result.bins) {
        text += line(range_text(bin), std::to_string(bin.records), number(bin.level), number(bin.frequency));
        for (const CategoryRange& category : result.categories) {
            const auto found = std::find_if(bin.categories.begin(), bin.categories.end(),
                                            [&](const auto& count) { return count.category == category.category; });
            text += fmt::format("  {:>{}}", found == bin.categories.end() ? "-" : std::to_string(found->records),
                                name_of(category.category).size());
        }
        text += "\n";
    }
    return text;
}

std::string categories_table(const Sensitivity& result) {
    std::string text;
    for (const CategoryRange& category : result.categories)
        text += fmt::format("{:<12} {} {}, {} {} to {}{}, median {}\n", name_of(category.category), category.records,
                            category.records == 1 ? "record" : "records", result.quantity, number(category.lowest),
                            number(category.highest), with_unit(result.unit), number(category.median));
    return text;
}

std::string correlation_line(const char* what, const RankCorrelation& correlation) {
    if (std::isnan(correlation.coefficient))
        return fmt::format("{:<20} no rank correlation: {}\n", what,
                           correlation.records < 3
                               ? fmt::format("{} of at least 3 records have both", correlation.records)
                               : "all values are equal");
    return fmt::format("{:<20} rank correlation {:+.3f} (Spearman, n = {}, p = {:.2g})\n", what,
                       correlation.coefficient, correlation.records, correlation.p_value);
}

std::string records_table(const Sensitivity& result) {
    const std::size_t width = std::max<std::size_t>(10, result.level_unit.size());
    const auto line = [&](const std::string& id, const std::string& quantity, const std::string& category,
                          const std::string& level, const std::string& frequency) {
        return fmt::format("{:>6}  {:>12}  {:<12}  {:>{}}  {:>10}\n", id, quantity, category, level, width, frequency);
    };
    std::string text = line("id", result.quantity, "category", "level", "frequency");
    text += line("", result.unit == "1" ? "" : result.unit, "", result.level_unit, "Hz");
    for (const noise_library::Observation& record : result.records)
        text += line(std::to_string(record.id), number(record.quantity), name_of(record.category), number(record.level),
                     number(record.frequency));
    return text;
}

std::string report(const Sensitivity& result, const SensitivityCommand& command) {
    std::string text = command.records ? records_table(result) : bins_table(result);
    text += "\n" + categories_table(result) + "\n";
    text += correlation_line("level", result.level) + correlation_line("dominant frequency", result.frequency);
    if (result.left_out > 0)
        text += fmt::format("left out: {} {} without a {}\n", result.left_out,
                            result.left_out == 1 ? "record" : "records", result.quantity);
    return text;
}

void run_sensitivity(const SensitivityCommand& command) {
    noise_library::Library library = open_library(command.library, noise_library::Access::read);
    noise_library::Query query = query_of(command.selection);
    query.extent = noise_library::EntryExtent::figures;
    noise_library::SensitivityOptions options;
    options.quantity = command.over;
    options.unit = unit_over(command.over, library);
    options.bins = command.bins;
    options.judge = command.by == "category" ? noise_library::Judge::stridor : noise_library::Judge::engineer;
    const Sensitivity result = noise_library::sensitivity(library.find(query), options);
    if (result.records.empty())
        throw Error(ErrorKind::input,
                    {"there are no records over " + command.over,
                     result.left_out == 0 ? "no entry meets the conditions"
                                          : fmt::format("it is unknown in all {} of them", result.left_out),
                     "Say it with `stridor library edit ID --" + command.over + " VALUE`."});
    if (!command.figure.empty()) draw(figures::sensitivity(result), command.figure);
    print(command.json ? io::sensitivity_json(library.file(), result) + "\n" : report(result, command));
}

}  // namespace

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
        ->check(CLI::IsMember({"category", "denomination"}))
        ->capture_default_str();
    command->add_flag("--records", options->records, "a row per record instead of bins");
    command->add_option("--figure", options->figure, "draw the records to FILE.png, FILE.svg or FILE.pdf")
        ->type_name("FILE");
    command->add_flag("--json", options->json, "print one JSON document (schema stridor.sensitivity/1)");
    add_library_option(*command, options->library);
    command->footer(
        "Level and dominant frequency are the figures `level` and `dominant_frequency` of an entry.\n"
        "Examples:\n  stridor rig sensitivity --over preload --where \"recorded = rig\" --figure preload.png\n"
        "  stridor rig sensitivity --over temperature --by denomination --records");
    command->callback([options] { run_sensitivity(*options); });
}

}  // namespace stridor::app
