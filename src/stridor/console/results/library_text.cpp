#include "stridor/console/results/library_text.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/noise_library/field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace stridor::console {

using noise_library::Entry;
using noise_library::EntryField;
using noise_library::FigureKind;

namespace {

std::string number_text(double value) {
    return std::isnan(value) ? std::string() : fmt::format("{:.6g}", value);
}

std::string with_unit(double value, std::string_view unit) {
    return std::isnan(value) ? "" : number_text(value) + after_number(unit);
}

// a column with its heading, its unit and a cell of each entry; numbers to the right
void add_column(TextTable& table, const std::string& name, const std::vector<Entry>& entries,
                const std::vector<FigureKind>& figures) {
    const EntryField* field = noise_library::find_field(name);
    const auto figure =
        std::find_if(figures.begin(), figures.end(), [&](const FigureKind& each) { return each.name == name; });
    if (field == nullptr && figure == figures.end() && name != "id") {
        std::vector<std::string> names = noise_library::field_names([](const EntryField&) { return true; });
        for (const FigureKind& each : figures)
            names.push_back(each.name);
        throw Error(ErrorKind::input, {"\"" + name + "\" is no field", "no entry has a figure of that name either",
                                       base::did_you_mean(name, names, "`stridor library fields` lists them.")});
    }
    // levels of recordings that were calibrated differently do not compare
    const auto unit_of_figure = [&] {
        std::string unit;
        for (const Entry& entry : entries)
            for (const noise_library::Figure& each : entry.figures)
                if (each.name == name && each.unit != unit) unit = unit.empty() ? each.unit : "mixed";
        return unit;
    };
    const bool is_words = field != nullptr && !std::holds_alternative<noise_library::EntryQuantity>(field->kind);
    table.columns.push_back(is_words ? left(name) : right(name));
    const std::string unit(field != nullptr ? noise_library::unit_of(*field) : name == "id" ? "" : unit_of_figure());
    table.rows.front().push_back(unit == "1" ? "" : unit);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const Entry& entry = entries[k];
        std::string cell = name == "id" ? std::to_string(entry.id)
                           : is_words   ? noise_library::words_in(entry, *field)
                                        : number_text(noise_library::number_of(entry, name));
        // lines of notes would tear the table
        std::replace(cell.begin(), cell.end(), '\n', ' ');
        table.rows[k + 1].push_back(std::move(cell));
    }
}

}  // namespace

std::string entry_table(const std::vector<Entry>& entries, const std::vector<std::string>& columns,
                        const std::vector<FigureKind>& figures) {
    TextTable table{{}};
    table.heading = Style::bold;
    table.rows.resize(entries.size() + 1);
    for (const std::string& name : columns)
        add_column(table, name, entries, figures);
    return text_of(table);
}

std::string entry_line(const Entry& entry) {
    return fmt::format("{:>4}  {}  {:.4g} s, {:g} Hz, {:g} channel{}\n", entry.id, entry.file, entry.duration,
                       entry.rate, entry.channels, entry.channels == 1.0 ? "" : "s");
}

std::string judged_line(const Entry& entry) {
    std::string line = entry_line(entry);
    if (!entry.category.empty()) line.insert(line.size() - 1, ": " + entry.category);
    return line;
}

std::string summary_text(const noise_library::Arrivals& arrivals) {
    constexpr std::size_t most_known = 10;  // more are no news
    std::string text = fmt::format("added {}, known {}, refused {}", arrivals.added.size(), arrivals.known.size(),
                                   arrivals.refused.size());
    if (arrivals.left > 0) text += fmt::format(", not looked at {}", arrivals.left);
    if (arrivals.passed_over > 0)
        text += fmt::format("; passed over {} that by name {} no recording{}", arrivals.passed_over,
                            arrivals.passed_over == 1 ? "is" : "are", arrivals.passed_over == 1 ? "" : "s");
    if (arrivals.known.size() <= most_known)
        for (const noise_library::KnownRecording& known : arrivals.known)
            text += fmt::format("\nknown    {}: entry {} has its sound", known.file, known.id);
    for (const recordings::RefusedRecording& refused : arrivals.refused)
        text += "\nrefused  " + refused.reason;
    return text;
}

std::string entry_page(const noise_library::Library& library, const Entry& entry) {
    std::size_t width = 17;
    for (const noise_library::Figure& figure : entry.figures)
        width = std::max(width, figure.name.size() + 1);
    std::string text = styled(fmt::format("entry {}", entry.id), Style::bold, STDOUT_FILENO) + "\n";
    for (const EntryField& field : noise_library::fields()) {
        const std::string_view unit = noise_library::unit_of(field);
        std::string value = unit.empty() ? noise_library::words_in(entry, field)
                                         : with_unit(noise_library::quantity_in(entry, field), unit);
        if (value.empty() || field.name == "audio") continue;
        if (noise_library::is_document(field)) value = fmt::format("(--field {} prints it)", field.name);
        text += fmt::format("{:<{}}", field.name, width);
        // further lines of notes stand below the first
        for (const char c : value)
            text += c == '\n' ? "\n" + std::string(width, ' ') : std::string(1, c);
        text += "\n";
    }
    for (const noise_library::Figure& figure : entry.figures)
        text += fmt::format("{:<{}}{}\n", figure.name, width, with_unit(figure.value, figure.unit));
    return text + fmt::format("{:<{}}{}\n", "audio", width, library.audio_file(entry).string());
}

std::string fields_text(const std::vector<FigureKind>& figures) {
    TextTable table{{left("field", 17), left("unit", 6), left("what it says", 1)}};
    for (const EntryField& field : noise_library::fields()) {
        const bool is_own = field.writer == noise_library::Writer::user;
        add_row(table, field.name, unit_of(field),
                std::string(field.sentence) + (is_own ? "" : " (written by Stridor)"));
    }
    for (const FigureKind& figure : figures)
        add_row(table, figure.name, figure.unit, "figure");
    return text_of(table);
}

std::string ids_text(const std::vector<std::int64_t>& ids) {
    return fmt::format("{} {}", ids.size() == 1 ? "entry" : "entries", fmt::join(ids, ", "));
}

std::vector<std::string> finding_lines(const noise_library::Findings& findings) {
    std::vector<std::string> lines = findings.saved.damages;
    for (const noise_library::LostEntry& lost : findings.saved.lost)
        lines.push_back(fmt::format("entry {} is not what was written", lost.id));
    for (const noise_library::DamagedSound& sound : findings.damaged_sounds)
        lines.push_back(fmt::format("the audio {} of {} is {}", noise_library::path_of(sound.name).string(),
                                    ids_text(sound.entries), sound.is_missing ? "missing" : "damaged"));
    return lines;
}

}  // namespace stridor::console
