#include "stridor/console/results/match_text.hpp"

#include "stridor/console/terminal.hpp"
#include "stridor/sweep/cell_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stridor::console {

namespace {

// "dominant frequency 425 -> 431 Hz"
std::string difference_words(const classification::FigureDifference& each) {
    std::string name(each.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    const std::string unit = each.unit == "1" ? "" : " " + std::string(each.unit);
    return fmt::format("{} {:.3g} -> {:.3g}{}", name, each.first, each.second, unit);
}

std::string differences(const classification::Likeness& likeness) {
    std::string text;
    for (std::size_t k = 0; k < std::min<std::size_t>(3, likeness.differences.size()); ++k)
        if (likeness.differences[k].share >= 0.1)
            text += (text.empty() ? "" : ", ") + difference_words(likeness.differences[k]);
    return text.empty() ? "nothing" : text;
}

std::string search_words(const io::MatchReport& report) {
    const hearing::SoundSearchResult& result = report.result;
    std::string text = fmt::format("listened to {} of {} cells", result.heard, sweep::cell_count(report.study));
    if (result.ruled_out > 0) text += fmt::format("; {} ruled out by the store", result.ruled_out);
    if (result.without_result > 0) text += fmt::format("; {} without a result", result.without_result);
    return text + "\n";
}

}  // namespace

std::string match_name(const sweep::Study& study, const hearing::SoundMatch& match) {
    const sweep::CellPlace place = sweep::place_of(study, match.cell.index);
    const auto direction = static_cast<std::size_t>(study.directions[place.direction]);
    return sweep::cell_name(study, place) + ",direction=" + std::string(parameters::direction_names[direction]);
}

std::string match_text(const io::MatchReport& report) {
    const sweep::Study& study = report.study;
    std::string text = fmt::format("{}: {} by ear\n{}: x is {}, y is {}; {}\n{}\n", report.recording.name,
                                   classification::name(report.recording.heard.category), report.chart,
                                   study.x.parameter, study.y.parameter, report.motion, search_words(report));
    text += fmt::format("{:>3} {:>9}  {:<9}{:<9}{:<40}  what differs\n", "", "distance", "by ear", "contact", "cell");
    for (std::size_t k = 0; k < report.result.best.size(); ++k) {
        const hearing::SoundMatch& match = report.result.best[k];
        text += fmt::format("{:>3} {:>9.3f}  {:<9}{:<9}{:<40}  {}\n", k + 1, match.likeness.distance,
                            classification::name(match.cell.heard), classification::name(match.cell.contact),
                            match_name(study, match), differences(match.likeness));
    }
    return text;
}

}  // namespace stridor::console
