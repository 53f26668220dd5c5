#include "stridor/console/results/live_text.hpp"

#include "stridor/console/results/text_table.hpp"
#include "stridor/signal/level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace stridor::console {

namespace {

std::string level_words(double level, const std::string& unit) {
    return std::isfinite(level) ? fmt::format("{:.1f} {}", level, signal::level_unit(unit)) : "silence";
}

constexpr std::size_t most_channels = 8;   // of a block; more do not fit a screen
constexpr std::size_t label_columns = 34;  // before the course

// eighths of a line's height; the range of the minute is the height, at least 20 dB
std::string course_bars(const hearing::LiveCourse& course, std::size_t first) {
    constexpr std::array<std::string_view, 8> bars{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    constexpr double least_range = 20.0;  // [dB]
    constexpr double most_range = 60.0;   // [dB]
    double high = -std::numeric_limits<double>::infinity();
    double low = std::numeric_limits<double>::infinity();
    for (const double second : course.seconds) {
        const double level = signal::level_of(second, 1.0);
        high = std::max(high, level);
        if (std::isfinite(level)) low = std::min(low, level);
    }
    const double range = std::isfinite(high) ? std::clamp(high - low, least_range, most_range) : least_range;
    std::string text;
    for (std::size_t k = first; k < course.seconds.size(); ++k) {
        const double level = signal::level_of(course.seconds[k], 1.0);
        const double share = std::isfinite(level) ? std::clamp(1.0 - (high - level) / range, 0.0, 1.0) : 0.0;
        text += bars[static_cast<std::size_t>(std::lround(7.0 * share))];
    }
    return text;
}

std::string noise_letters(const hearing::LiveCourse& course, std::size_t first) {
    using classification::Category;
    std::string text;
    for (std::size_t k = first; k < course.categories.size(); ++k) {
        const Category category = course.categories[k];
        text += category == Category::squeal   ? 'l'
                : category == Category::squeak ? 'k'
                : category == Category::creak  ? 'c'
                                               : ' ';
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

// "   now squeak 0.74"; nothing where no noise is
std::string guess_words(const hearing::LiveGuess& guess) {
    using classification::Category;
    if (guess.category == Category::none || guess.category == Category::undecided) return {};
    std::string words = fmt::format("   now {}", classification::name(guess.category));
    if (guess.probability > 0.0) words += fmt::format(" {:.2f}", guess.probability);
    return words;
}

std::string clock_text(double seconds) {
    const auto whole = static_cast<long>(seconds);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

std::string live_passage_line(const hearing::LivePassage& passage, const io::LiveInput& input) {
    const signal::Channel& channel = input.layout.channels[passage.channel];
    std::string line =
        fmt::format("{:>9.3f} - {:>9.3f} s  {:<9}", passage.from, passage.to, classification::name(passage.category()));
    line += passage.verdict.probability > 0.0 ? fmt::format("{:>5.2f}", passage.verdict.probability) : "     ";
    line += fmt::format("  {:>7}", level_words(passage.level, channel.unit));
    if (passage.frequency > 0.0) line += fmt::format("  {:>6.0f} Hz", passage.frequency);
    if (input.layout.channels.size() > 1) line += fmt::format("  channel {}", passage.channel + 1);
    if (!channel.name.empty()) line += " (" + channel.name + ")";
    return line;
}

std::string live_noise_line(const hearing::LiveNoise& noise, const io::KeptClip& kept) {
    std::string line = fmt::format("noise {}: {}, {:.3f} to {:.3f} s{}", noise.number,
                                   classification::name(noise.strongest.category()), noise.from, noise.to,
                                   noise.is_cut ? ", and on" : "");
    if (!kept.file.empty()) line += ", kept in " + kept.file;
    if (kept.entry > 0) line += fmt::format(", entry {} of the library", kept.entry);
    if (!kept.failure.empty()) line += ", not kept: " + kept.failure;
    return line;
}

std::string live_gap_line(const io::LiveGap& gap) {
    const std::string missing = gap.seconds ? fmt::format("{:.3f} s are missing ({})", *gap.seconds, gap.why) : gap.why;
    return fmt::format("gap at {:.3f} s: {}", gap.at, missing);
}

std::string live_sum_line(const io::LiveSum& sum) {
    return fmt::format("heard {:.3f} s in {}, {}, {}: {}", sum.heard, counted(sum.takes, "take", "takes"),
                       counted(sum.noises, "noise", "noises"), counted(sum.gaps, "gap", "gaps"), sum.why);
}

std::string live_block(const io::LiveInput& input, std::span<const hearing::LiveCourse> courses, const io::LiveSum& sum,
                       std::size_t columns) {
    std::string head =
        fmt::format("{}  {}  {}, {}  {}", clock_text(sum.heard), input.name, counted(sum.noises, "noise", "noises"),
                    counted(sum.gaps, "gap", "gaps"), input.format);
    std::string text = head.substr(0, columns) + "\n";
    const std::size_t room = columns > label_columns + 10 ? columns - label_columns - 1 : 0;
    for (std::size_t k = 0; k < std::min(courses.size(), most_channels); ++k) {
        const hearing::LiveCourse& course = courses[k];
        const signal::Channel& channel = input.layout.channels[k];
        const double level = signal::level_of(course.now, signal::reference_of(channel.unit));
        const std::string label =
            fmt::format("{:>2} {:<8} {:>20}", k + 1, channel.name.substr(0, 8), level_words(level, channel.unit));
        const std::size_t first = course.seconds.size() - std::min(course.seconds.size(), room);
        text += label.substr(0, columns);
        if (room > 0)
            text += "  " + course_bars(course, first) + "\n" +
                    fmt::format("{:<{}}", guess_words(course.guess), label_columns) + noise_letters(course, first);
        text += "\n";
    }
    if (courses.size() > most_channels) text += fmt::format("and {} channels more\n", courses.size() - most_channels);
    return text;
}

}  // namespace stridor::console
