#include "stridor/recordings/open_signal.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/audio/audio.hpp"
#include "stridor/recordings/audio/compressed_audio.hpp"
#include "stridor/recordings/mat/mat.hpp"
#include "stridor/recordings/mat/mat_choice.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/recording_files.hpp"
#include "stridor/recordings/sidecar.hpp"
#include "stridor/recordings/table/csv_table.hpp"
#include "stridor/recordings/table/signal_csv.hpp"
#include "stridor/recordings/uff58/uff58.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <system_error>
#include <utility>

namespace stridor::recordings {

namespace {

constexpr std::size_t sniffed = 4096;               // [bytes]
constexpr std::size_t longest_sidecar = 1U << 20U;  // [bytes]

bool is_text(std::string_view beginning) {
    return std::none_of(beginning.begin(), beginning.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 32 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\v';
    });
}

/// A format of measurements that is known by its mark and not read.
struct Foreign {
    std::string_view mark;
    std::string_view name;
    std::string_view way_out;
};

constexpr std::array foreign_formats{
    Foreign{"TDSm", "a TDMS file of LabVIEW or DIAdem",
            "Export it as CSV from there, or with Python's npTDMS: "
            "TdmsFile(\"IN.tdms\").as_dataframe(time_index=True).to_csv(\"OUT.csv\", index_label=\"time\")"},
    Foreign{"MDF     ", "an MDF file", "Export it as CSV from the program that wrote it."},
    Foreign{"UnFinMF ", "an MDF file", "Finalize it, then export it as CSV, with the program that wrote it."},
    Foreign{"DIAEXTENDED", "the header of a DIAdem file", "Export it as text (ASCII) from DIAdem."},
    Foreign{"PK\x03\x04", "a zip archive, as spreadsheets (.xlsx, .ods) are", "Save the sheet as CSV."},
    Foreign{"\xD0\xCF\x11\xE0", "a spreadsheet of old (.xls)", "Save the sheet as CSV."},
    Foreign{"\x1F\x8B", "a packed file", "Unpack it: gunzip FILE."},
    Foreign{"\x93NUMPY", "an array of NumPy",
            "Write it as CSV: numpy.savetxt(\"OUT.csv\", array, delimiter=\",\", header=\"time [s],force [N]\")"},
    Foreign{"\x89HDF\r\n\x1a\n", "an HDF5 file",
            "Write its time and samples as CSV, with the columns \"time [s]\" and \"NAME [UNIT]\"."}};

void refuse_foreign(std::string_view beginning, const std::string& name) {
    for (const Foreign& foreign : foreign_formats)
        if (beginning.starts_with(foreign.mark))
            throw refusal(name, "this is " + std::string(foreign.name), "Stridor does not read it",
                          std::string(foreign.way_out));
}

// Spreadsheets and DIAdem write "Unicode text" so. It is turned into UTF-8 as a whole.
RawSignal open_utf16_table(const SignalInput& input, csv_table::Utf16 form, const OpenOptions& options) {
    constexpr std::uint64_t largest = 1U << 28U;  // [bytes]
    if (input.bytes->size() > largest)
        throw refusal(input.name, "the text in UTF-16 is too long", "at most 256 MiB of it are read",
                      "Save it as UTF-8.");
    SignalInput table = input;
    table.bytes = bytes_of(csv_table::utf8_of(text_at(*input.bytes, 0, largest), form));
    return open_signal_csv(table, options.rate, options.channel_name);
}

RawSignal open_raw(const SignalInput& input, const OpenOptions& options) {
    const std::string beginning = text_at(*input.bytes, 0, sniffed);
    if (beginning.empty()) throw refusal(input.name, "the file is empty");
    if (is_audio(beginning)) return open_audio(input);
    if (is_compressed_audio(beginning)) return open_compressed_audio(input);
    if (is_uff(beginning)) return open_uff58(input, options.dataset);
    if (is_mat(beginning)) return open_mat(input, {options.rate, options.channel_name});
    refuse_foreign(beginning, input.name);
    // behind all marks: soft samples of 16 bits, of which half the bytes are NUL, look like a text in UTF-16
    if (const auto form = csv_table::utf16_in(beginning)) return open_utf16_table(input, *form, options);
    if (is_text(beginning) && has_sound_name(input.name))
        throw refusal(input.name, "this is text and no sound", "a sound file begins with the mark of its format",
                      "If it is a table, give it a name that ends in .csv.");
    if (is_text(beginning)) return open_signal_csv(input, options.rate, options.channel_name);
    throw refusal(input.name, "the format of the file is not known",
                  "it is no sound file, no table, no UFF and no MAT file",
                  "Convert it to WAV, CSV or UFF 58 first. If it holds bare samples of 16 bits: sox -t raw -r 48000 -e "
                  "signed -b 16 -c 1 IN OUT.wav");
}

std::string label(const signal::Channel& channel, std::size_t index) {
    return channel.name.empty() ? "channel " + std::to_string(index + 1) : "channel \"" + channel.name + "\"";
}

using Places = std::vector<std::size_t>;  // of channels in the file, from 0

/// Gathers from every origin what a recording's channels are in.
class Calibrator {
public:
    /// Full scales are given for one, for all channels of the file, or for those at `places`.
    Calibrator(const RawSignal& raw, const OpenOptions& options, const std::optional<Sidecar>& sidecar,
               const Places& places)
        : raw_(raw),
          options_(options),
          sidecar_(sidecar),
          places_(places),
          described_(calibration_in(raw.description)) {}

    void apply(signal::ChannelLayout& layout, SignalFacts& facts) const {
        for (std::size_t k = 0; k < layout.channels.size(); ++k) {
            signal::Channel& channel = layout.channels[k];
            const std::string written = channel.unit;
            facts.units_in_file.push_back(written);
            const auto [scale, origin] = calibration(k, written);
            const bool is_known = origin != Calibration::file || is_known_unit(written);
            if (!is_known)
                facts.notes.push_back("the unit \"" + written + "\" of " + label(channel, k) +
                                      " is not known; its numbers are kept as they are");
            channel.unit = scale.unit;
            facts.full_scales.push_back(scale);
            facts.calibrations.push_back(origin);
        }
        const bool is_doubtful = !described_ && mentions_level(raw_.description);
        if (is_doubtful)
            facts.notes.push_back("the description speaks of dBFS, but not as in \"0dBFS = 109.7 dBSPL\": \"" +
                                  raw_.description + "\"");
    }

private:
    static bool mentions_level(std::string_view text) {
        return text.find("dBFS") != std::string_view::npos || text.find("dbfs") != std::string_view::npos;
    }

    std::pair<FullScale, Calibration> calibration(std::size_t k, const std::string& written) const {
        const std::vector<FullScale>& given = options_.full_scales;
        if (given.size() == 1) return {given.front(), Calibration::option};
        const bool is_for_all = given.size() == raw_.source->layout().channels.size();
        const auto place = std::find(places_.begin(), places_.end(), k);
        if (!given.empty() && (is_for_all || place != places_.end()))
            return {given[is_for_all ? k : static_cast<std::size_t>(place - places_.begin())], Calibration::option};
        const bool has_sidecar = sidecar_ && k < sidecar_->channels.size() && sidecar_->channels[k].full_scale;
        if (has_sidecar) return {*sidecar_->channels[k].full_scale, Calibration::sidecar};
        if (described_) return {*described_, Calibration::description};
        const FullScale unit = unit_of_label(written);
        return {unit, unit.unit == signal::full_scale ? Calibration::none : Calibration::file};
    }

    const RawSignal& raw_;
    const OpenOptions& options_;
    const std::optional<Sidecar>& sidecar_;
    const Places& places_;
    std::optional<FullScale> described_;
};

void apply_sidecar(const Sidecar& sidecar, signal::ChannelLayout& layout, const std::string& name) {
    if (!sidecar.channels.empty() && sidecar.channels.size() != layout.channels.size())
        throw refusal(name, "the sidecar names " + std::to_string(sidecar.channels.size()) + " channels",
                      "the recording has " + std::to_string(layout.channels.size()));
    for (std::size_t k = 0; k < sidecar.channels.size(); ++k)
        if (sidecar.channels[k].name) layout.channels[k].name = *sidecar.channels[k].name;
    if (!sidecar.rate) return;
    const bool agrees = std::abs(*sidecar.rate - layout.rate) <= 1.0;
    if (!agrees)
        throw refusal(name, "the sidecar gives a rate of " + base::shortest(*sidecar.rate) + " Hz",
                      "the recording has " + base::shortest(layout.rate) + " Hz", "Is it of another recording?");
    layout.rate = *sidecar.rate;
}

// "channel 1" is what writers call a channel without a name
void drop_made_up_names(signal::ChannelLayout& layout) {
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (layout.channels[k].name == "channel " + std::to_string(k + 1)) layout.channels[k].name.clear();
}

// `width` channels are left of those in the file
void check_options(const OpenOptions& options, std::size_t width, std::size_t of_file, const std::string& name) {
    const std::size_t given = options.full_scales.size();
    if (given > 1 && given != width && given != of_file)
        throw refusal(name, std::to_string(given) + " full scales are given",
                      "the recording has " + std::to_string(width) + " channels", "Give one for all or one for each.");
    if (options.channel && (*options.channel < 1 || *options.channel > width))
        throw refusal(name, "there is no channel " + std::to_string(*options.channel),
                      "the recording has " + std::to_string(width));
}

Places places_of_all(const signal::ChannelLayout& layout) {
    Places places(layout.channels.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    return places;
}

// the channels that are signals; all where none is
Places signals_in(RawSignal& raw, const std::optional<Sidecar>& sidecar, SignalFacts& facts) {
    const signal::ChannelLayout layout = raw.source->layout();
    const std::vector<ChannelFault> faults = channel_faults(*raw.source);
    const auto is_signal = [&](std::size_t k) {
        // a sidecar that gives its unit says that it is one
        const bool has_unit = sidecar && k < sidecar->channels.size() && sidecar->channels[k].full_scale;
        const bool is_counter = faults[k].kind == FaultKind::counter;
        return is_counter ? has_unit || raw.doubt != Doubt::numbers_and_counters : faults[k].kind == FaultKind::none;
    };
    Places places = places_of_all(layout);
    std::erase_if(places, [&](std::size_t k) { return !is_signal(k); });
    if (places.empty()) return places_of_all(layout);
    for (const std::size_t k : places_of_all(layout)) {
        if (is_signal(k)) continue;
        facts.notes.push_back(label(layout.channels[k], k) + " was left out: it " + faults[k].why);
        facts.left_out.push_back(label(layout.channels[k], k) + ": " + faults[k].why);
    }
    return places;
}

// what was left out may be asked for by its name; numbers count what is left
Places picked(const OpenOptions& options, const signal::ChannelLayout& layout, const Places& places,
              const std::string& name) {
    if (options.channel) return {places[*options.channel - 1]};
    if (options.channel_name.empty()) return places;
    signal::ChannelLayout left{layout.rate, {}, {}};
    for (const std::size_t k : places)
        left.channels.push_back(layout.channels[k]);
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (layout.channels[k].name == options.channel_name) return {k};
    try {
        return {places[signal::channel_named(left, options.channel_name)]};
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), base::Place{name, 0, 0, ""});
    }
}

std::optional<std::string> sidecar_text(const std::string& path) {
    if (path == storage::standard_input) return std::nullopt;
    const std::string beside = sidecar_path(path);
    std::error_code code;
    if (!std::filesystem::is_regular_file(beside, code)) return std::nullopt;
    const auto bytes = open_bytes(beside);
    if (bytes->size() > longest_sidecar) throw refusal(beside, "the sidecar is too long", "1 MiB is read at most");
    return text_at(*bytes, 0, longest_sidecar);
}

}  // namespace

SignalFile::SignalFile(RawSignal raw, signal::ChannelLayout layout, SignalFacts facts, std::vector<std::size_t> picked)
    : raw_(std::move(raw)),
      layout_(std::move(layout)),
      facts_(std::move(facts)),
      picked_(std::move(picked)) {
    const auto pick = [&](auto& all) {
        auto whole = std::exchange(all, {});
        for (const std::size_t k : picked_)
            all.push_back(whole[k]);
    };
    pick(layout_.channels);
    pick(facts_.full_scales);
    pick(facts_.calibrations);
    pick(facts_.units_in_file);
}

double SignalFile::sample(std::size_t index, std::size_t channel) const {
    const double value = block_[index] * facts_.full_scales[channel].value;
    if (signal::is_sample(value)) return value;
    const std::uint64_t frame = frames_ + index / raw_.source->layout().channels.size();
    throw Error(ErrorKind::input, signal::sample_problem(value, layout_.channels[channel], frame + 1),
                base::Place{facts_.name, 0, 0, ""});
}

std::size_t SignalFile::read(std::span<double> frames) {
    const std::size_t width = picked_.size();
    const std::size_t file_width = raw_.source->layout().channels.size();
    STRIDOR_EXPECT(frames.size() % width == 0);
    block_.resize(frames.size() / width * file_width);
    const std::size_t count = raw_.source->read(block_);
    bool are_samples = true;
    for (std::size_t k = 0; k < width; ++k) {
        const double scale = facts_.full_scales[k].value;
        const double* from = block_.data() + picked_[k];
        double* to = frames.data() + k;
        for (std::size_t frame = 0; frame < count; ++frame) {
            to[frame * width] = from[frame * file_width] * scale;
            are_samples = are_samples & signal::is_sample(to[frame * width]);
        }
    }
    // the first that is none says so
    for (std::size_t frame = 0; frame < count && !are_samples; ++frame)
        for (std::size_t k = 0; k < width; ++k)
            static_cast<void>(sample(frame * file_width + picked_[k], k));
    frames_ += count;
    return count;
}

bool is_recording(std::string_view beginning) {
    return is_audio(beginning) || is_compressed_audio(beginning) || is_uff(beginning) || is_mat(beginning);
}

SignalInput open_input(const std::string& path) {
    if (path.ends_with(".toml"))
        throw refusal(path, "this is a case, not a recording", "a case is simulated",
                      fmt::format("`stridor simulate {0}` judges it; `stridor listen {0} -o sound.wav` makes it a "
                                  "recording.",
                                  path));
    return {open_bytes(path), path == storage::standard_input ? "standard input" : path, sidecar_text(path)};
}

std::unique_ptr<SignalFile> open_signal(const SignalInput& input, const OpenOptions& options) {
    RawSignal raw = open_raw(input, options);
    signal::ChannelLayout layout = raw.source->layout();
    drop_made_up_names(layout);
    std::optional<Sidecar> sidecar;
    if (input.sidecar) sidecar = parse_sidecar(*input.sidecar, sidecar_path(input.name));
    SignalFacts facts{input.name, raw.format, {}, {}, raw.notes, raw.metadata, raw.time, raw.left_out};
    Places places = places_of_all(layout);
    if (raw.doubt != Doubt::none && places.size() > 1) {
        places = signals_in(raw, sidecar, facts);
        raw.source.reset();  // it is at its end
        raw = open_raw(input, options);
    }
    if (sidecar) {
        apply_sidecar(*sidecar, layout, sidecar_path(input.name));
        facts.metadata.insert(facts.metadata.end(), sidecar->metadata.begin(), sidecar->metadata.end());
    }
    check_options(options, places.size(), layout.channels.size(), input.name);
    Calibrator(raw, options, sidecar, places).apply(layout, facts);
    Places chosen = picked(options, layout, places, input.name);
    return std::make_unique<SignalFile>(std::move(raw), std::move(layout), std::move(facts), std::move(chosen));
}

std::unique_ptr<SignalFile> open_signal(const std::string& path, const OpenOptions& options) {
    return open_signal(open_input(path), options);
}

std::string given_calibration(const SignalFacts& facts) {
    bool is_given = false;
    bool is_one = true;
    std::string all;
    for (std::size_t k = 0; k < facts.full_scales.size(); ++k) {
        const Calibration origin = facts.calibrations[k];
        is_given |=
            origin == Calibration::option || origin == Calibration::sidecar || origin == Calibration::description;
        is_one = is_one && facts.full_scales[k] == facts.full_scales.front();
        all += (k > 0 ? "; full scale = " : "full scale = ") + base::shortest(facts.full_scales[k].value) + " " +
               facts.full_scales[k].unit;
    }
    if (!is_given) return "";
    return is_one ? all.substr(0, all.find(';')) : all;
}

}  // namespace stridor::recordings
