#include "stridor/recordings/mat/mat.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/child_process.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/mat/mat_choice.hpp"
#include "stridor/recordings/mat/mat_header.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/signal_csv_header.hpp"
#include "stridor/recordings/time_grid.hpp"

#if STRIDOR_HAS_MATIO
#    include "stridor/recordings/mat/matio_answers.hpp"
#    include "stridor/storage/new_file.hpp"
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <utility>

namespace stridor::recordings {

namespace {

constexpr std::uint64_t most_numbers = std::uint64_t{1} << 28U;  // the library holds whole variables
constexpr std::uint64_t most_numbers_per_byte = 1032;            // what deflate can pack into one, each number a byte
constexpr std::uint64_t memory_of_library = std::uint64_t{3} << 30U;  // [bytes] the most numbers, packed and unpacked
constexpr unsigned processor_time = 60;                               // [s] of which 2 GiB of packed numbers need 20

Error damage(const std::string& file, const std::string& why) {
    return refusal(file, "the MAT file is damaged", why);
}

template <typename Plain>
void ask(mat::Answers& answers, std::span<const Plain> plain) {
    answers.send(std::as_bytes(plain));
}

template <typename Plain>
Plain answer(mat::Answers& answers, const std::string& file) {
    Plain plain{};
    if (!answers.receive(std::as_writable_bytes(std::span(&plain, 1)))) throw damage(file, answers.ending());
    return plain;
}

std::vector<mat::Variable> variables_of(mat::Answers& answers, const std::string& file) {
    const auto opened = answer<mat::Opened>(answers, file);
    if (opened.is_open != 1) throw damage(file, "it cannot be opened");
    if (opened.variables > mat::most_variables)
        throw refusal(file, "the MAT file has too many variables",
                      "at most " + std::to_string(mat::most_variables) + " are looked at");
    std::vector<mat::Variable> variables;
    for (std::uint32_t k = 0; k < opened.variables; ++k) {
        const auto head = answer<mat::VariableHead>(answers, file);
        constexpr std::uint64_t longest = std::uint64_t{1} << 48U;  // keeps products of sizes within their type
        const bool is_sound = head.kind < mat::MatKind::count && head.name_length <= mat::longest_name &&
                              head.rows <= longest && head.columns <= longest;
        if (!is_sound) throw damage(file, "what it says of its variable " + std::to_string(k + 1) + " makes no sense");
        std::string name(head.name_length, '\0');
        if (!answers.receive(std::as_writable_bytes(std::span(name)))) throw damage(file, answers.ending());
        const bool is_empty = head.rows == 0 || head.columns == 0;
        const bool is_number = head.kind <= mat::MatKind::integers;
        variables.push_back({base::visible(name), is_number && is_empty ? mat::MatKind::nothing : head.kind, head.rows,
                             head.columns, head.value});
    }
    return variables;
}

// asks for columns; their numbers come next
void begin(mat::Answers& answers, std::span<const mat::MatColumn> columns, const std::string& file) {
    const std::uint64_t count = columns.size();
    ask(answers, std::span(&count, 1));
    ask(answers, columns);
    if (answer<std::uint32_t>(answers, file) != 1) throw damage(file, "its numbers cannot be read");
}

time_grid::Times times_of(mat::Answers& answers, const mat::MatChoice& choice, const std::string& file) {
    time_grid::Times times;
    const auto precision = [&](double time) {
        // singles know seven digits, wherever the point stands
        return choice.has_single_times ? time_grid::Precision{400, 7} : time_grid::precision_of(base::shortest(time));
    };
    begin(answers, std::span(&*choice.time, 1), file);
    for (std::uint64_t frame = 0; frame < choice.frames; ++frame) {
        const auto time = answer<double>(answers, file);
        times.last = time;
        if (frame >= time_grid::looked_at) continue;
        const bool increases = std::isfinite(time) && (frame == 0 || time > times.first.back());
        if (!increases)
            throw refusal(file, "the times do not increase",
                          choice.time_name + "(" + std::to_string(frame + 1) + ") is " + base::shortest(time),
                          "Give the rate: --rate 48000.");
        times.first.push_back(time);
        times.precision = time_grid::finer(times.precision, precision(time));
    }
    if (!std::isfinite(times.last) || times.last <= times.first.back()) times.last = times.first.back();
    times.precision = time_grid::finer(times.precision, precision(times.last));
    return times;
}

bool are_whole(std::span<const double> times) {
    return std::all_of(times.begin(), times.end(), [](double time) { return time == std::round(time); });
}

// the rate that the file tells, held against its times; or theirs
void settle_rate(mat::MatChoice& choice, const time_grid::Times& times, std::vector<std::string>& notes,
                 const std::string& file) {
    constexpr double lowest_heard = 40.0;  // [Hz] twice the lowest frequency of a sound
    if (choice.is_time_guessed && are_whole(times.first))
        throw refusal(file, "the file does not tell its sampling rate",
                      choice.time_name + " counts in whole steps, and does not say that they are seconds",
                      "Give it (--rate 48000), or save it there: fs = 48000.");
    if (choice.rate && times.first.size() < 2) return;
    const SnappedRate snapped = times.first.size() > 1 ? time_grid::rate_of(times) : SnappedRate{};
    const bool is_rate =
        std::isfinite(snapped.rate) && snapped.rate > 0.0 && snapped.rate <= signal_table::highest_rate;
    if (!is_rate) throw refusal(file, "the times in " + choice.time_name + " give no sampling rate");
    const bool agrees = !choice.rate || std::abs(*choice.rate / snapped.rate - 1.0) <= 0.01;
    if (!agrees)
        throw refusal(file, "the file tells two sampling rates",
                      base::shortest(*choice.rate) + " Hz, and " + base::shortest(snapped.rate) +
                          " Hz by the times in " + choice.time_name,
                      "Say which one it is: --rate " + base::shortest(*choice.rate) + ".");
    if (choice.rate && !time_grid::missed(times, *choice.rate, choice.frames - 1, times.last)) return;
    choice.rate = snapped.rate;
    if (!snapped.note.empty()) notes.push_back(snapped.note);
    if (snapped.rate < lowest_heard)
        notes.push_back(choice.time_name + " was taken for seconds, which gives " + base::shortest(snapped.rate) +
                        " Hz; if it is in milliseconds, say --rate " + base::shortest(1e3 * snapped.rate));
}

class MatSource final : public signal::Source {
public:
    MatSource(std::shared_ptr<mat::Answers> answers, const mat::MatChoice& choice,
              std::optional<time_grid::Times> times, const std::string& file)
        : answers_(std::move(answers)),
          times_(std::move(times)),
          time_name_(choice.time_name),
          file_(file),
          layout_{*choice.rate, choice.channels, choice.frames} {
        std::vector<mat::MatColumn> columns = choice.columns;
        if (times_) columns.insert(columns.begin(), *choice.time);
        width_ = columns.size();
        begin(*answers_, columns, file_);
    }

    const signal::ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        const std::size_t width = layout_.channels.size();
        STRIDOR_EXPECT(frames.size() % width == 0);
        const auto count =
            static_cast<std::size_t>(std::min<std::uint64_t>(frames.size() / width, *layout_.frames - next_));
        block_.resize(count * width_);
        if (!answers_->receive(std::as_writable_bytes(std::span(block_)))) throw damage(file_, answers_->ending());
        for (std::size_t frame = 0; frame < count; ++frame, ++next_) {
            const double* row = block_.data() + frame * width_;
            if (times_) check_time(*row++);
            std::copy_n(row, width, frames.data() + frame * width);
        }
        return count;
    }

private:
    void check_time(double time) const {
        const std::optional<double> due = time_grid::missed(*times_, layout_.rate, next_, time);
        if (due)
            throw refusal(
                file_, "the times are not evenly spaced",
                "at " + base::shortest(layout_.rate) + " Hz, " + time_name_ + "(" + std::to_string(next_ + 1) +
                    ") is due to be " + base::shortest(*due) + ", not " + base::shortest(time),
                "Resample the signals to an even step, or say the rate: --rate " + base::shortest(layout_.rate) + ".");
    }

    std::shared_ptr<mat::Answers> answers_;
    std::optional<time_grid::Times> times_;
    std::string time_name_;
    std::string file_;
    signal::ChannelLayout layout_;
    std::size_t width_ = 0;  // [1] numbers of a frame, with the time
    std::vector<double> block_;
    std::uint64_t next_ = 0;
};

#if STRIDOR_HAS_MATIO

/// The library in its confined process.
class MatioProcess final : public mat::Answers {
public:
    MatioProcess(const Matio& matio, const SignalInput& input, unsigned openings)
        : input_(with_a_name(input.bytes)),
          process_(base::Confines{memory_of_library, processor_time, 120, openings, *input_->descriptor()},
                   [&](const base::ChildProcess::Channel& channel) { answer_with_matio(matio, channel); }) {}

    void send(std::span<const std::byte> bytes) override { process_.send(bytes); }
    bool receive(std::span<std::byte> into) override { return process_.receive(into); }
    std::string ending() override {
        const std::string ending = process_.ending();
        if (process_.was_not_confined())
            throw Error(ErrorKind::io,
                        {"no MAT file is read on this machine", "it does not let a process be confined (seccomp)",
                         "Convert the file elsewhere: stridor convert IN.mat OUT.csv"});
        return "reading it, " + ending;
    }

private:
    // the library wants a file, and HDF5 one that has a name
    std::shared_ptr<const Bytes> with_a_name(std::shared_ptr<const Bytes> bytes) {
        if (bytes->descriptor()) return bytes;
        const std::string copy = (folder_.emplace().path() / "recording.mat").string();
        std::ofstream file(copy, std::ios::binary);
        constexpr std::size_t block = 1U << 20U;
        for (std::uint64_t offset = 0; offset < bytes->size(); offset += block)
            file << text_at(*bytes, offset, block);
        file.close();
        if (!file)
            throw Error(ErrorKind::io, {"cannot write \"" + copy + "\"", "the disk may be full",
                                        "Set TMPDIR to a folder with more room."});
        return open_bytes(copy);
    }

    std::optional<storage::PrivateFolder> folder_;
    std::shared_ptr<const Bytes> input_;
    base::ChildProcess process_;
};

#endif

}  // namespace

bool is_mat(std::string_view beginning) {
    return mat::version_of(beginning).has_value();
}

RawSignal open_mat_answers(std::shared_ptr<mat::Answers> answers, std::uint64_t file_size, const mat::Wishes& wishes,
                           const std::string& file) {
    const std::vector<mat::Variable> variables = variables_of(*answers, file);
    mat::MatChoice choice = mat::choose(variables, wishes, file);
    const std::uint64_t width = choice.columns.size() + 1;  // with the times
    if (choice.frames > file_size * most_numbers_per_byte / width)
        throw damage(file, "its variables are larger than its bytes can hold");
    if (choice.frames > most_numbers / width)
        throw refusal(file, "the MAT file is too long",
                      "at most " + std::to_string(most_numbers) + " numbers are read from one",
                      "Save it in parts, or as WAV: audiowrite.");
    RawSignal raw;
    raw.format = "MAT";
    raw.doubt = Doubt::numbers_and_counters;
    raw.notes = choice.notes;
    raw.metadata = choice.metadata;
    raw.left_out = choice.left_out;
    raw.time = choice.time_name;
    std::optional<time_grid::Times> times;
    if (choice.time) {
        times = times_of(*answers, choice, file);
        settle_rate(choice, *times, raw.notes, file);
    }
    raw.source = std::make_unique<MatSource>(std::move(answers), choice, std::move(times), file);
    return raw;
}

RawSignal open_mat(const SignalInput& input, const mat::Wishes& wishes) {
    const std::string what = "this is a MAT file of MATLAB";
#if STRIDOR_HAS_MATIO
    if (const Matio* matio = matio_library()) {
        const std::optional<mat::Version> version = mat::version_of(text_at(*input.bytes, 0, 1024));
        if (!version) throw refusal(input.name, "this is no MAT file");
        mat::check_length(input, *version);
        const bool is_hdf5 = *version == mat::Version::seven_three;
        // the library opens HDF5 a second time
        auto process = std::make_shared<MatioProcess>(*matio, input, is_hdf5 ? 2 : 1);
        RawSignal raw = open_mat_answers(std::move(process), input.bytes->size(), wishes, input.name);
        raw.format = is_hdf5 ? "MAT 7.3" : *version == mat::Version::five ? "MAT 5" : "MAT 4";
        return raw;
    }
    throw refusal(input.name, what, "libmatio, which reads it, is not on this machine",
                  "Install it (Debian: apt-get install libmatio11), or write a table in MATLAB: "
                  "writetable(table(time, force), \"OUT.csv\")");
#else
    static_cast<void>(wishes);
    throw refusal(input.name, what, "this program was built without libmatio, which reads it",
                  "Write a table in MATLAB: writetable(table(time, force), \"OUT.csv\")");
#endif
}

}  // namespace stridor::recordings
