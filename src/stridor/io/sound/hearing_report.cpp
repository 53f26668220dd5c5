#include "stridor/io/sound/hearing_report.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/hearing/heard_recordings.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/sound/feature_table.hpp"

#include <algorithm>
#include <utility>

namespace stridor::io {

namespace {

using base::Json;
using base::csv_text::TableColumn;
using classification::Category;
using classification::Confusion;
using hearing::Half;
using hearing::HeardSound;
using json_parts::name_of;
using sound::SoundFeature;

// features that the rules look at
bool is_told(const SoundFeature& feature) {
    return feature.told != SoundFeature::Told::in_entries;
}

std::string_view word(Category category) {
    return classification::name(category);
}

std::string_view word(parameters::Direction direction) {
    return name_of(parameters::direction_names, direction);
}

Json table_object(const Confusion& table) {
    Json counts = Json::object();
    Json shares = Json::object();
    for (std::size_t truth = 0; truth < table.counts.size(); ++truth) {
        const std::string name(classification::category_names[truth]);
        for (std::size_t heard = 0; heard < table.counts.size(); ++heard)
            counts[name][std::string(classification::category_names[heard])] = table.counts[truth][heard];
        shares[name] = classification::agreement_on(table, static_cast<Category>(truth));
    }
    shares.erase(std::string(word(Category::undecided)));
    const Confusion decided = classification::decided(table);
    return {
        {"sounds", classification::total(table)},          {"decided", classification::total(decided)},
        {"agreement", classification::agreement(decided)}, {"mean_agreement", classification::mean_agreement(decided)},
        {"agreement_by_category", std::move(shares)},      {"counts", std::move(counts)}};
}

template <typename Tables>
Json tables_object(const Tables& of) {
    return {{"all", table_object(of(Half::both))},
            {"even", table_object(of(Half::even))},
            {"odd", table_object(of(Half::odd))}};
}

Json sound_object(const HeardSound& sound) {
    const bool is_done = sound.cell.status == sweep::Status::done;
    return {{"status", name_of(sweep::status_names, sound.cell.status)},
            {"contact_states", is_done ? Json(word(sound.cell.category)) : Json()},
            {"by_ear", is_done ? Json(word(sound.heard)) : Json()},
            {"reason", sound.reason}};
}

Json chart_object(const HeardChart& chart) {
    const auto direction_word = [](parameters::Direction direction) { return word(direction); };
    std::size_t failed = 0;
    for (const HeardSound& sound : chart.sounds)
        failed += sound.cell.status == sweep::Status::done ? 0 : 1;
    const bool is_file = chart.set == sweep::PlaneSet::file;
    return {{"file", is_file ? Json(chart.name) : Json()},
            {"plane", is_file ? Json() : Json(chart.name)},
            {"set", name_of(sweep::plane_set_names, chart.set)},
            {"case", json_parts::case_object(chart.study.base)},
            {"x", json_parts::axis_object(chart.study.x)},
            {"y", json_parts::axis_object(chart.study.y)},
            {"directions", json_parts::array_of(chart.study.directions, direction_word)},
            {"cells", chart.sounds.size()},
            {"failed", failed},
            {"tables", tables_object([&](Half half) { return hearing::confusion(chart.sounds, half); })}};
}

Json sets_object(const HearingReport& report) {
    Json sets = Json::object();
    for (const sweep::PlaneSet set : sets_of(report))
        sets[std::string(name_of(sweep::plane_set_names, set))] = table_object(confusion(report, set));
    return sets;
}

Json perturbations_array(const HearingReport& report) {
    Json array = Json::array();
    for (std::size_t k = 0; k < hearing::perturbations().size(); ++k)
        array.push_back(
            {{"name", hearing::perturbations()[k].name}, {"table", table_object(perturbed_confusion(report, k))}});
    return array;
}

Json recording_object(const hearing::HeardRecording& recording) {
    Json accepted =
        json_parts::array_of(recording.expectation.categories, [](Category category) { return word(category); });
    return {{"file", recording.expectation.file},     {"expected", recording.expectation.words},
            {"accepted", std::move(accepted)},        {"by_ear", word(recording.heard)},
            {"is_right", is_right(recording)},        {"reason", recording.reason},
            {"source", recording.expectation.source}, {"is_sure", recording.expectation.is_sure},
            {"probability", recording.probability}};
}

Json score_object(const hearing::RecordingScore& score) {
    const auto share = [](const hearing::RightShare& of) -> Json {
        return {{"what", of.what}, {"right", of.right}, {"count", of.count}, {"low", of.low}, {"high", of.high}};
    };
    const auto row = [](const hearing::HeardRow& of) -> Json {
        return {{"expected", of.expected}, {"by_ear", json_parts::named(classification::category_names, of.heard)}};
    };
    const auto bin = [](const hearing::CalibrationBin& of) -> Json {
        return {{"from", of.from},
                {"to", of.to},
                {"count", of.count},
                {"right", of.right},
                {"probability", of.probability}};
    };
    const auto point = [](const hearing::AbstentionPoint& of) -> Json {
        return {{"probability", of.probability}, {"decided", of.decided}, {"right", of.right}};
    };
    return {{"shares", json_parts::array_of(score.shares, share)},
            {"rows", json_parts::array_of(score.rows, row)},
            {"calibration", json_parts::array_of(score.bins, bin)},
            {"abstention", json_parts::array_of(score.decided, point)}};
}

std::vector<TableColumn> columns() {
    std::vector<TableColumn> columns{{"chart"},  {"index"},          {"x"},      {"y"},     {"direction"},
                                     {"status"}, {"contact_states"}, {"by_ear"}, {"agrees"}};
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        columns.push_back({std::string(figure.name), std::string(figure.unit)});
    for (const SoundFeature& feature : sound::feature_table)
        if (is_told(feature)) columns.push_back({"ear_" + std::string(feature.name), std::string(feature.unit)});
    for (const hearing::Perturbation& perturbation : hearing::perturbations())
        columns.push_back({std::string(perturbation.name)});
    columns.push_back({"reason"});
    columns.push_back({"plane"});
    return columns;
}

void add_row(base::csv_text::Table& table, const HeardSound& sound, const std::string& plane) {
    const bool is_done = sound.cell.status == sweep::Status::done;
    table.word(name_of(sweep::status_names, sound.cell.status));
    table.word(is_done ? word(sound.cell.category) : "");
    table.word(is_done ? word(sound.heard) : "");
    table.word(!is_done ? "" : sound.cell.category == sound.heard ? "1" : "0");
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        table.number(figure_of(sound.cell, figure));
    for (const SoundFeature& feature : sound::feature_table)
        if (is_told(feature) && is_done)
            table.number(sound.features.*feature.member);
        else if (is_told(feature))
            table.word("");
    for (std::size_t k = 0; k < hearing::perturbations().size(); ++k)
        table.word(sound.perturbed.empty() ? "" : word(sound.perturbed[k]));
    table.word(is_done ? sound.reason : sound.cell.message);
    table.word(plane);
    table.end_row();
}

}  // namespace

std::vector<HeardChart> built_in_charts(std::string_view set, const std::vector<std::string>& overrides) {
    std::vector<HeardChart> charts;
    for (const sweep::ReadyChart& chart : sweep::ready_charts())
        if (set == "all" || set == name_of(sweep::plane_set_names, chart.set))
            charts.push_back({chart.name, chart.set, read_study({study_toml(chart.study), chart.name, overrides}), {}});
    return charts;
}

Confusion confusion(const HearingReport& report, Half half) {
    Confusion table;
    for (const HeardChart& chart : report.charts)
        table = classification::sum(table, hearing::confusion(chart.sounds, half));
    return table;
}

Confusion confusion(const HearingReport& report, sweep::PlaneSet set) {
    Confusion table;
    for (const HeardChart& chart : report.charts)
        if (chart.set == set) table = classification::sum(table, hearing::confusion(chart.sounds));
    return table;
}

std::vector<sweep::PlaneSet> sets_of(const HearingReport& report) {
    std::vector<sweep::PlaneSet> sets;
    for (std::size_t k = 0; k < sweep::plane_set_names.size(); ++k) {
        const auto set = static_cast<sweep::PlaneSet>(k);
        const auto is_of_it = [&](const HeardChart& chart) { return chart.set == set; };
        if (std::any_of(report.charts.begin(), report.charts.end(), is_of_it)) sets.push_back(set);
    }
    return sets;
}

Confusion perturbed_confusion(const HearingReport& report, std::optional<std::size_t> perturbation) {
    Confusion table;
    for (const HeardChart& chart : report.charts)
        table = classification::sum(table, hearing::perturbed_confusion(chart.sounds, perturbation));
    return table;
}

std::string hearing_json(const HearingReport& report) {
    Json document = json_parts::opening("evaluate");
    document["table_1"] = json_parts::array_of(report.cases, [](const hearing::HeardCase& heard) -> Json {
        return {{"case", heard.name},
                {"going", sound_object(heard.phases[0])},
                {"coming", sound_object(heard.phases[1])},
                {"whole", {{"by_ear", word(heard.whole)}, {"reason", heard.reason}}}};
    });
    if (!report.charts.empty()) {
        document["charts"] = json_parts::array_of(report.charts, [](const auto& each) { return chart_object(each); });
        document["tables"] = tables_object([&](Half half) { return confusion(report, half); });
        document["sets"] = sets_object(report);
        document["perturb_every"] = report.options.perturb_every;
        if (report.options.perturb_every > 0) {
            document["unperturbed"] = table_object(perturbed_confusion(report, std::nullopt));
            document["perturbed"] = perturbations_array(report);
        }
    }
    document["recordings"] =
        json_parts::array_of(report.recordings, [](const auto& each) { return recording_object(each); });
    if (!report.recordings.empty()) document["score"] = score_object(hearing::score_of(report.recordings));
    document["thresholds"] = json_parts::thresholds_object(report.options.settings.thresholds);
    return base::text_of(document);
}

std::string hearing_csv(const HearingReport& report) {
    base::csv_text::Facts facts = base::csv_text::origin("evaluate");
    for (std::size_t k = 0; k < report.charts.size(); ++k) {
        const sweep::Study& study = report.charts[k].study;
        facts.emplace_back("chart_" + std::to_string(k + 1),
                           study.base.title + "; x: " + study.x.parameter + ", y: " + study.y.parameter);
    }
    base::csv_text::Table table(facts, columns());
    std::string text = table.take();
    for (std::size_t k = 0; k < report.charts.size(); ++k)
        for (const HeardSound& sound : report.charts[k].sounds) {
            const sweep::Study& study = report.charts[k].study;
            const sweep::CellPlace place = sweep::place_of(study, sound.index);
            table.number(static_cast<double>(k + 1));
            table.number(static_cast<double>(sound.index));
            table.number(sweep::value_at(study.x, place.ix));
            table.number(sweep::value_at(study.y, place.iy));
            table.word(word(study.directions[place.direction]));
            add_row(table, sound, report.charts[k].name);
            text += table.take();
        }
    return text;
}

}  // namespace stridor::io
