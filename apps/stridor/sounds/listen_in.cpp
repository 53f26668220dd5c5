#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "sounds/clip_keeper.hpp"
#include "sounds/live_input.hpp"
#include "sounds/sound_options.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/console/redrawn_block.hpp"
#include "stridor/console/results/live_text.hpp"
#include "stridor/console/results/sound_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/live_ear.hpp"
#include "stridor/io/sound/live_events.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace stridor::app {

namespace {

using Clock = std::chrono::steady_clock;

struct ListenInOptions {
    LiveInputOptions input;
    SoundOptions thresholds;  // of these alone
    KeepOptions keep;
    std::string patience = "5 s";
    std::string longest_take = "1 h";
    std::string began;  // "2026-11-27T15:42:25Z"
    bool json = false;
};

double seconds_of(const std::string& option, const std::string& text, double least) {
    const double seconds = at_option(option, text, [&] { return base::parse_quantity(text, "s"); });
    if (seconds >= least) return seconds;
    throw Error(ErrorKind::input,
                {fmt::format("{} {} is too short", option, text), fmt::format("at least {} s are needed", least), ""});
}

double now() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

// what the options say, read before the input is opened: a slip of the pen is told at once, and not when samples come
struct LiveWishes {
    explicit LiveWishes(const ListenInOptions& options)
        : thresholds(thresholds_of(options.thresholds)),
          patience(seconds_of("--patience", options.patience, 0.1)),
          longest_take(seconds_of("--longest-take", options.longest_take, 10.0)),
          about(entry_of(options.keep)) {
        if (!options.began.empty())
            began = at_option("--began", options.began, [&] { return io::seconds_of_stamp(options.began); });
    }

    parameters::SoundThresholds thresholds;
    double patience;      // [s]
    double longest_take;  // [s]
    noise_library::Entry about;
    std::optional<double> began{};  // [s since 1970]
};

/// Hears a sound that is not over, and tells what it hears.
class Watch {
public:
    Watch(const ListenInOptions& options, const LiveWishes& wishes, LiveSamples& samples)
        : options_(options),
          samples_(samples),
          begin_(wishes.began.value_or(now())),
          thresholds_(wishes.thresholds),
          patience_(wishes.patience),
          keeper_(options.keep, wishes.about, samples.input(), samples.clip_samples(), samples.full_scales()),
          ear_(samples.input().layout, {thresholds_, wishes.longest_take, 30.0},
               {[this](const hearing::LivePassage& passage) { tell(passage); },
                [this](const hearing::LiveNoise& noise, signal::Source& clip) { tell(noise, clip); },
                [this](const hearing::LiveTake& take) { tell(take); }}) {
        if (options.json) print(io::begin_event(samples.input(), begin_));
    }

    /// Hears until the sound is over or a stop is requested, and sums up. Sound that is there already is heard, too.
    void hear(const Interrupt& interrupt) {
        std::exception_ptr failure;
        try {
            while (hear_next(interrupt)) {
            }
        } catch (const Error& error) {
            // what was heard before is summed up
            failure = std::current_exception();
            sum_.why = error.problem().what;
        }
        ear_.finish();
        sum_.heard = ear_.heard();
        block_.clear();
        print(options_.json ? io::end_event(sum_, begin_) : console::live_sum_line(sum_));
        if (failure) std::rethrow_exception(failure);
        keeper_.expect_no_failure();
    }

private:
    bool hear_next(const Interrupt& interrupt) {
        constexpr std::chrono::milliseconds moment{100};
        constexpr std::size_t most_rest = std::size_t{1} << 20U;  // samples: what pipes hold
        const bool is_stopped = interrupt.is_requested();
        LivePiece piece = samples_.next(is_stopped ? std::chrono::milliseconds(0) : moment);
        switch (piece.kind) {
            case LivePiece::Kind::samples:
                if (is_stopped) rest_ += piece.frames.size();
                // what stood still had its time
                if (is_starved_ && options_.began.empty()) begin_ = now() - ear_.heard();
                came_ = Clock::now();
                is_starved_ = false;
                ear_.push(piece.frames);
                sum_.heard = ear_.heard();
                break;
            case LivePiece::Kind::lost:
                tell_gap({ear_.heard(), piece.seconds, samples_.input().name + ": " + piece.words});
                begin_ += piece.seconds.value_or(0.0);
                break;
            case LivePiece::Kind::end:
                sum_.why = piece.words;
                if (piece.is_cut) tell_gap({ear_.heard(), std::nullopt, piece.words});
                return false;
            case LivePiece::Kind::nothing:
                if (!is_stopped && !goes_on_starved()) return false;
                break;
        }
        if (block_.is_due()) {
            guess();
            draw();
        }
        if (!is_stopped || (piece.kind == LivePiece::Kind::samples && rest_ < most_rest)) return true;
        sum_.why = "stopped";
        return false;
    }

    // is there more to come, though nothing came for some time?
    bool goes_on_starved() {
        const double waited = std::chrono::duration<double>(Clock::now() - came_).count();
        if (is_starved_ || waited < patience_) return true;
        if (samples_.is_whole()) {
            sum_.why = "the file is whole";
            return false;
        }
        is_starved_ = true;
        // the head of a recorder that died promises nothing, for ever
        const std::string_view end = options_.input.follows ? "; the file's head does not end it, Ctrl-C does" : "";
        tell_gap({ear_.heard(), std::nullopt, fmt::format("nothing came for {}{}", options_.patience, end)});
        return true;
    }

    void tell_gap(const io::LiveGap& gap) {
        ear_.gap();
        ++sum_.gaps;
        tell(options_.json ? io::gap_event(gap, begin_) : console::live_gap_line(gap));
    }

    void tell(const hearing::LivePassage& passage) {
        const bool is_noise = passage.category() != classification::Category::none &&
                              passage.category() != classification::Category::undecided;
        if (options_.json)
            tell(io::passage_event(passage, samples_.input(), begin_));
        else if (is_noise)
            tell(console::live_passage_line(passage, samples_.input()));
    }

    void tell(const hearing::LiveNoise& noise, signal::Source& clip) {
        ++sum_.noises;
        const io::KeptClip kept = keeper_.keep(noise, clip, begin_ + noise.from);
        tell(options_.json ? io::noise_event(noise, samples_.input(), kept, begin_)
                           : console::live_noise_line(noise, kept));
    }

    void tell(const hearing::LiveTake& take) {
        ++sum_.takes;
        const io::SoundReport report = io::report_of(take, samples_.input(), thresholds_);
        if (options_.json) return tell(io::take_event(take, report, begin_));
        tell(fmt::format("take {}, {:.3f} to {:.3f} s{}", take.number, take.from, take.to,
                         take.from > 0.0 ? "; the times below count from its beginning" : ""));
        tell(console::verdict_text(report));
    }

    void tell(const std::string& line) {
        block_.clear();
        print(line);
        draw();
    }

    void print(const std::string& line) { console::print(line.ends_with('\n') ? line : line + "\n"); }

    // once a second of sound, for who watches
    void guess() {
        if (ear_.heard() < guessed_ + 1.0) return;
        guessed_ = ear_.heard();
        ear_.guess();
    }

    void draw() {
        constexpr int standard_error = 2;
        const auto columns = static_cast<std::size_t>(console::terminal_columns(standard_error));
        block_.draw(console::live_block(samples_.input(), ear_.courses(), sum_, columns - 1));
    }

    const ListenInOptions& options_;
    LiveSamples& samples_;
    double begin_;  // [s since 1970] of the sound at 0 s, if nothing had been lost
    parameters::SoundThresholds thresholds_;
    double patience_;  // [s]
    ClipKeeper keeper_;
    hearing::LiveEar ear_;
    io::LiveSum sum_{};
    console::RedrawnBlock block_;
    Clock::time_point came_ = Clock::now();  // the last samples
    std::size_t rest_ = 0;                   // samples since the stop
    bool is_starved_ = false;
    double guessed_ = 0.0;  // [s] what was heard then
};

void listen_in(const ListenInOptions& options) {
    const LiveWishes wishes(options);
    const Interrupt interrupt;
    LiveSamples samples(options.input, interrupt.token());
    say_unused(options.thresholds, judges_of(samples.input().layout.channels));
    Watch(options, wishes, samples).hear(interrupt);
}

}  // namespace

void add_listen_in(CLI::App& program) {
    auto options = std::make_shared<ListenInOptions>();
    CLI::App* command = program.add_subcommand(
        "listen-in",
        "Listen to a sound that is not over, from a device, a pipe or a file that grows: tell each noise as it is "
        "heard, keep a clip of it, and judge the whole as classify does.");
    add_live_input_options(*command, options->input);
    add_keep_options(*command, options->keep);
    command
        ->add_option(
            "--patience", options->patience,
            "without a sample for so long there is a gap, or a growing file whose head agrees is whole (default: 5 s)")
        ->type_name("TIME");
    command
        ->add_option("--longest-take", options->longest_take,
                     "judge the whole anew after so long; more fills more memory (default: 1 h)")
        ->type_name("TIME");
    command
        ->add_option("--began", options->began, "when the sound began, for stamps: 2026-11-27T15:42:25Z (default: now)")
        ->type_name("TIME");
    command->add_option("--set", options->thresholds.thresholds, "another threshold: --set certainty=0.7 (repeatable)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    add_json_option(*command, options->json, "stridor.listen-in/1", "print one JSON document per event, a line each");
    command->footer(
        "It ends with the sound, by Ctrl-C or by SIGTERM, sums up, and leaves exit code 0; 5 if a clip could not be "
        "kept, or the recorder failed.\n"
        "Devices need arecord (Debian: alsa-utils) or parec (pulseaudio-utils; PipeWire too).\n"
        "Examples:\n  stridor listen-in --device hw:1,0 --channels 4 --raw s24le --keep cobbles\n"
        "  ffmpeg -loglevel error -i rtsp://... -f wav - | stridor listen-in --json\n"
        "  stridor listen-in --follow drive.wav --library drive.sqlite --about system=dashboard");
    command->callback([options] { listen_in(*options); });
}

}  // namespace stridor::app
