#include "stridor/io/sound/json_compare.hpp"

#include "stridor/io/json_parts.hpp"
#include "stridor/signal/level.hpp"

namespace stridor::io {

namespace {

using base::Json;
using classification::ComparedFigure;
using classification::ComparedSound;
using classification::FigureDifference;
using classification::Likeness;

Json figures_object(const ComparedSound& sound) {
    Json object = Json::object();
    for (const ComparedFigure& figure : classification::compared_figures())
        object[std::string(figure.name)] = figure.value(sound);  // NaN becomes null
    return object;
}

Json contact_array(const ComparedSound& sound) {
    return json_parts::array_of(sound.contact.verdicts, [](const classification::Verdict& verdict) -> Json {
        const analysis::Evidence& evidence = verdict.evidence;
        return {{"phase", record::phase_names[static_cast<std::size_t>(evidence.phase)]},
                {"category", classification::name(verdict.category)},
                {"slip", evidence.rates.slip},
                {"stick", evidence.rates.stick},
                {"separation", evidence.rates.separation},
                {"regularity", evidence.alternation.regularity},
                {"frequency", evidence.alternation.frequency}};
    });
}

Json sound_object(const ComparedSound& sound) {
    return {{"name", sound.name},
            {"label", sound.label},
            {"origin", sound.origin},
            {"what", sound.what},
            {"rate", sound.rate},
            {"compared_at", sound.analysis.rate},
            {"duration", sound.length},
            {"unit", sound.analysis.unit},
            {"level_unit", signal::level_unit(sound.analysis.unit)},
            {"category", classification::name(sound.heard.category)},
            {"shares", json_parts::named(classification::category_names, sound.heard.shares)},
            {"reasons", sound.heard.reasons},
            {"contact", contact_array(sound)},
            {"figures", figures_object(sound)}};
}

Json differences_array(const Likeness& likeness) {
    return json_parts::array_of(likeness.differences, [](const FigureDifference& each) -> Json {
        return {{"figure", each.name},   {"unit", each.unit},   {"first", each.first},
                {"second", each.second}, {"steps", each.steps}, {"share", each.share}};
    });
}

Json figure_units() {
    Json units = {{"rate", "Hz"}, {"compared_at", "Hz"}, {"duration", "s"}};
    for (const ComparedFigure& figure : classification::compared_figures())
        units["figures." + std::string(figure.name)] = figure.unit.empty() ? "level_unit" : figure.unit;
    return units;
}

Json value_object(const sweep::Axis& axis, int index) {
    return {{"parameter", axis.parameter}, {"value", sweep::value_at(axis, index)}, {"index", index}};
}

Json match_object(const MatchReport& report, const hearing::SoundMatch& match) {
    const sweep::CellPlace place = sweep::place_of(report.study, match.cell.index);
    const auto direction = static_cast<std::size_t>(report.study.directions[place.direction]);
    ComparedSound sound;
    sound.profile = match.cell.profile;
    sound.analysis.unit = report.motion.find("acceleration") == std::string::npos ? "m/s" : "m/s^2";
    return {{"x", value_object(report.study.x, place.ix)},
            {"y", value_object(report.study.y, place.iy)},
            {"direction", parameters::direction_names[direction]},
            {"distance", match.likeness.distance},
            {"category", classification::name(match.cell.heard)},
            {"contact_category", classification::name(match.cell.contact)},
            {"figures", figures_object(sound)},
            {"differences", differences_array(match.likeness)},
            {"reproduce", sweep::reproduce_command(report.study, place, report.chart)}};
}

}  // namespace

std::string compare_json(std::span<const ComparedSound> sounds) {
    Json document = json_parts::opening("compare");
    document["sounds"] = json_parts::array_of(sounds, [](const auto& each) { return sound_object(each); });
    Json pairs = Json::array();
    for (std::size_t a = 0; a < sounds.size(); ++a)
        for (std::size_t b = a + 1; b < sounds.size(); ++b) {
            const Likeness likeness = classification::likeness(sounds[a].profile, sounds[b].profile);
            const bool is_known = !is_silent(sounds[a].profile) && !is_silent(sounds[b].profile);
            pairs.push_back({{"first", a + 1},
                             {"second", b + 1},
                             {"distance", is_known ? Json(likeness.distance) : Json()},
                             {"differences", differences_array(likeness)}});
        }
    document["pairs"] = std::move(pairs);
    document["units"] = figure_units();
    return base::text_of(document);
}

std::string match_json(const MatchReport& report) {
    Json document = json_parts::opening("match");
    document["recording"] = sound_object(report.recording);
    document["chart"] = {{"file", report.chart},
                         {"motion", report.motion},
                         {"rate", report.rate},
                         {"cells", sweep::cell_count(report.study)},
                         {"heard", report.result.heard},
                         {"without_result", report.result.without_result},
                         {"ruled_out", report.result.ruled_out},
                         {"extent", report.extent == hearing::SearchExtent::every ? "every" : "search"},
                         {"level", report.level == classification::LevelUse::counted ? "counted" : "ignored"}};
    document["matches"] = json_parts::array_of(
        report.result.best, [&](const hearing::SoundMatch& match) { return match_object(report, match); });
    document["units"] = figure_units();
    return base::text_of(document);
}

}  // namespace stridor::io
