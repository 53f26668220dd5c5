#include "stridor/console/results/rig_text.hpp"

#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace stridor::console {

namespace {

using analysis::FrictionFigures;
using analysis::FrictionTrace;

void add_figures(TextTable& table, const FrictionFigures& figures) {
    add_row(table,
            figures.direction == 0  ? "all"
            : figures.direction > 0 ? "going"
                                    : "coming",
            coefficient_text(figures.static_friction), coefficient_text(figures.kinetic_friction),
            fmt::format("{:.4f}", figures.mean_friction), figures.drops,
            number_or_dash(figures.drop_rate, "{:.4g} 1/s"), number_or_dash(figures.mean_drop, "{:.4g} N"),
            number_or_dash(figures.largest_drop, "{:.4g} N"), number_or_dash(figures.variation, "{:.4g}"));
}

// "v_s 0.0204 m/s"
std::string value_text(const analysis::FittedNumber& number) {
    const std::string_view unit = parameters::unit_of(*number.field);
    return fmt::format("{} {:.4g}{}", number.field->symbol, number.value, after_number(unit == "1" ? "" : unit));
}

// "0.0195 to 0.0213"
template <typename Number>
std::string interval_text(const Number& number) {
    return std::isfinite(number.to) ? fmt::format("{:.4g} to {:.4g}", number.from, number.to)
                                    : fmt::format("{:.4g} or more", number.from);
}

std::string points_text(const analysis::FrictionFit& fit) {
    const std::string points = counted(fit.data.points.size(), "point", "points") + " at " +
                               counted(fit.speeds, "speed", "speeds") + " of slip";
    const std::string slips = counted(fit.slips, "slip", "slips") + " through the model of the rig";
    const bool has_points = !fit.data.points.empty();
    if (!has_points && fit.slips == 0) return "";
    std::string text = fmt::format("{}, as good as {:.0f} independent {}",
                                   !has_points      ? slips
                                   : fit.slips == 0 ? points
                                                    : points + ", and " + slips,
                                   fit.independent, has_points && fit.slips == 0 ? "ones" : "samples");
    if (has_points && fit.data.longest_block > 0.0)
        text += fmt::format("; means over {:.3g} to {:.3g} s", fit.data.shortest_block, fit.data.longest_block);
    return text + "\n";
}

// "stribeck, with intervals of 95 %", its numbers below
std::string law_text(const analysis::FittedLaw& law, const std::string& where) {
    const bool is_table = law.contact.friction == parameters::FrictionKind::table;
    std::string text =
        fmt::format("\n{}{}{}\n", analysis::fitted_names[law.kind], where, is_table ? "" : ", with intervals of 95 %");
    if (is_table) {
        for (std::size_t k = 0; k < law.contact.friction_table.speeds.size(); ++k)
            text += fmt::format("  {:>10.4g} mm/s  {:.4g}\n", 1e3 * law.contact.friction_table.speeds[k],
                                law.contact.friction_table.coefficients[k]);
    } else {
        for (const analysis::FittedNumber& number : law.numbers)
            text += fmt::format("  {:<18} {}\n", value_text(number), interval_text(number));
    }
    for (const analysis::RigNumber& number : law.rig)
        text += fmt::format("  {:<18} {}\n", fmt::format("{} {:.4g} {}", number.symbol, number.value, number.unit),
                            interval_text(number));
    return text;
}

using noise_library::Bin;
using noise_library::CategoryRange;
using noise_library::RankCorrelation;
using noise_library::Sensitivity;

std::string number(double value) {
    return std::isnan(value) ? "-" : fmt::format("{:.5g}", value);
}

std::string name_of(const std::string& category) {
    return category.empty() ? "unknown" : category;
}

std::string range_text(const Bin& bin) {
    return bin.from == bin.to ? number(bin.from) : number(bin.from) + " to " + number(bin.to);
}

// columns of both tables; below their headings stand the units
TextColumn level_column(const Sensitivity& result) {
    return right("level", 2 + std::max<std::size_t>(10, result.level_unit.size()));
}

std::string unit_text(const Sensitivity& result) {
    return result.unit == "1" ? "" : result.unit;
}

std::string bins_table(const Sensitivity& result) {
    TextTable table{{right(result.quantity), right("records", 9), level_column(result), right("frequency", 12)}};
    table.heading = Style::bold;
    for (const CategoryRange& category : result.categories)
        table.columns.push_back(right(name_of(category.category)));
    add_row(table, unit_text(result), "", result.level_unit, "Hz");
    for (const Bin& bin : result.bins) {
        add_row(table, range_text(bin), bin.records, number(bin.level), number(bin.frequency));
        for (const CategoryRange& category : result.categories) {
            const auto found = std::find_if(bin.categories.begin(), bin.categories.end(),
                                            [&](const auto& count) { return count.category == category.category; });
            table.rows.back().push_back(found == bin.categories.end() ? "-" : std::to_string(found->records));
        }
    }
    return text_of(table);
}

std::string categories_table(const Sensitivity& result) {
    std::string text;
    for (const CategoryRange& category : result.categories)
        text += fmt::format("{:<12} {}, {} {} to {}{}, median {}\n", name_of(category.category),
                            counted(category.records, "record", "records"), result.quantity, number(category.lowest),
                            number(category.highest), after_number(result.unit), number(category.median));
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
    TextTable table{{right("id", 6), right(result.quantity, 14), left("  category", 14), level_column(result),
                     right("frequency", 12)}};
    add_row(table, "", unit_text(result), "", result.level_unit, "Hz");
    for (const noise_library::Observation& record : result.records)
        add_row(table, record.id, number(record.quantity), "  " + name_of(record.category), number(record.level),
                number(record.frequency));
    return text_of(table);
}

}  // namespace

std::string coefficient_text(const analysis::MeasuredCoefficient& c) {
    if (!std::isfinite(c.value)) return "-";
    return std::isfinite(c.uncertainty) && c.count > 1 ? fmt::format("{:.4f} +- {:.4f}", c.value, c.uncertainty)
                                                       : fmt::format("{:.4f}", c.value);
}

std::string friction_text(const io::FrictionTest& test, const FrictionTrace& trace) {
    std::string text = styled(test.file, Style::bold, STDOUT_FILENO) + "\n";
    text += fmt::format("{:.4g} s at {:g} Hz, preload {:g} N", test.duration, test.rate, test.preload);
    if (std::isfinite(test.velocity)) text += fmt::format(", {:.4g} mm/s", 1e3 * test.velocity);
    if (!test.condition.empty()) text += " (" + test.condition + ")";
    text += fmt::format(
        "\nforce \"{}\"{}{}; noise {:.2g} N, drops from {:.3g} N on\n\n", test.channel,
        test.velocity_channel.empty() ? ", direction by its sign" : ", velocity \"" + test.velocity_channel + "\"",
        test.normal_channel.empty() ? "" : ", normal force \"" + test.normal_channel + "\"", trace.noise,
        trace.threshold * test.preload);
    TextTable table{{left("", 8), right("static", 18), right("kinetic", 18), right("mean", 9), right("drops", 7),
                     right("rate", 11), right("mean drop", 11), right("largest", 11), right("variation", 11)}};
    for (const FrictionFigures& figures : trace.directions)
        add_figures(table, figures);
    if (trace.directions.size() > 1) add_figures(table, trace.all);
    text += text_of(table) + fmt::format("\nkinetic from {}",
                                         analysis::kinetic_source_names[static_cast<std::size_t>(trace.all.source)]);
    if (trace.all.drops > 0 && std::isfinite(trace.all.distance))
        text += fmt::format("; {:.4g} drops per millimetre",
                            static_cast<double>(trace.all.drops) / (1e3 * trace.all.distance));
    return text + "; +- is one standard uncertainty\n";
}

std::string friction_fit_text(const io::FittedFriction& fitted, std::size_t law) {
    const analysis::FrictionFit& fit = fitted.fit;
    std::string text;
    for (const io::FrictionTest& test : fitted.tests) {
        text += styled(test.file, Style::bold, STDOUT_FILENO) +
                fmt::format(": {:.4g} s at {:g} Hz, preload {:g} N", test.duration, test.rate, test.preload);
        if (std::isfinite(test.velocity)) text += fmt::format(", {:.4g} mm/s", 1e3 * test.velocity);
        text += "\n";
    }
    if (fitted.over)
        for (std::size_t k = 0; k < fitted.over->temperatures.size(); ++k)
            text += fmt::format("{:g} degC: {}", fitted.over->temperatures[k],
                                points_text(fitted.over->fits[fitted.over->exponents[law]][k]));
    else
        text += points_text(fit);
    TextTable table{{left("law"), right("deviation"), right("difference"), left("  numbers")}};
    table.heading = Style::bold;
    for (const analysis::FittedLaw& each : fit.laws) {
        std::string numbers;
        for (const analysis::FittedNumber& number : each.numbers)
            numbers += "  " + value_text(number);
        if (fitted.over)
            numbers = "  " + counted(each.free_numbers, "number", "numbers");
        else if (each.contact.friction == parameters::FrictionKind::table)
            numbers = "  " + counted(each.contact.friction_table.speeds.size(), "row", "rows");
        add_row(table, analysis::fitted_names[each.kind], fmt::format("{:.2g}", each.deviation),
                fmt::format("{:.1f}", each.difference), numbers);
    }
    for (const analysis::UnfittedLaw& each : fit.unfitted)
        add_row(table, analysis::fitted_names[each.kind], "-", "-", "  " + each.why);
    text += "\n" + text_of(table);
    if (!fitted.over) return text + law_text(fit.laws[law], "") + "\n" + analysis::words_of(fit) + "\n";
    for (std::size_t k = 0; k < fitted.over->temperatures.size(); ++k)
        text += law_text(analysis::law_at(*fitted.over, law, k),
                         fmt::format(" at {:g} degC", fitted.over->temperatures[k]));
    return text + "\n" + analysis::words_of(*fitted.over) + "\n";
}

std::string risk_text(const io::RigRisk& risk) {
    TextTable table{{left("run")}};
    table.heading = Style::bold;
    for (const analysis::RiskScale& scale : risk.scales) {
        std::string heading(scale.key);
        std::replace(heading.begin(), heading.end(), '_', ' ');
        table.columns.push_back(right(heading));
        table.columns.push_back(right("rank"));
    }
    table.columns.push_back(right("number"));
    table.columns.push_back(left("  model"));
    for (const io::RunRisk& run : risk.runs) {
        std::vector<std::string> row{run.test.file};
        for (std::size_t k = 0; k < analysis::risk_figures; ++k) {
            row.push_back(std::isfinite(run.risk.figures[k])
                              ? fmt::format("{:.3g} {}", run.risk.figures[k], risk.scales[k].unit)
                              : "-");
            row.push_back(number_or_dash(run.risk.ranks[k], "{:.1f}"));
        }
        row.push_back(std::to_string(run.risk.number));
        row.push_back("  " + (run.category.empty() ? "-" : run.category));
        table.rows.push_back(std::move(row));
    }
    std::string text = text_of(table) + "\nranks from 1 to 10:";
    for (std::size_t k = 0; k < analysis::risk_figures; ++k)
        text += fmt::format("{} {} {:g} to {:g} {}", k == 0 ? "" : ",", risk.scales[k].key, risk.scales[k].low,
                            risk.scales[k].high, risk.scales[k].unit);
    return text + fmt::format("\nrisk number {}: {}; by Stridor's own rule, not VDA 230-206's tables\n", risk.number,
                              analysis::risk_word(risk.number));
}

std::string sensitivity_text(const Sensitivity& result, SensitivityRows rows) {
    std::string text = rows == SensitivityRows::records ? records_table(result) : bins_table(result);
    text += "\n" + categories_table(result) + "\n";
    text += correlation_line("level", result.level) + correlation_line("dominant frequency", result.frequency);
    if (result.left_out > 0)
        text +=
            fmt::format("left out: {} without a {}\n", counted(result.left_out, "record", "records"), result.quantity);
    return text;
}

}  // namespace stridor::console
