#include "bindings.hpp"
#include "handles.hpp"
#include "stridor/advice/advice.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/io/advice/advice_texts.hpp"
#include "stridor/io/arrow_stream.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/library/library_texts.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/io/sound/json_sound.hpp"
#include "stridor/io/sound/listening_texts.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "work.hpp"

#include <pybind11/stl.h>

#include <array>
#include <map>
#include <string>
#include <vector>

/// Answers that are documents: what the program prints with --json.
namespace stridor::binding {

namespace {

using Texts = std::vector<std::string>;

py::str stability(const CaseHandle& c, const std::string& over) {
    return python_text(unlocked([&](const std::stop_token&) {
        const std::optional<analysis::ScanRange> range =
            over.empty() ? std::nullopt : std::optional(io::read_scan_range(over));
        return io::stability_json(analysis::scan_stability(*c.of, range));
    }));
}

py::str advise(const CaseHandle& c, const Texts& over, const Texts& tolerances, const std::array<Texts, 2>& runs,
               std::size_t samples, int threads, const py::object& progress) {
    advice::AdviceOptions options;
    for (const std::string& text : over)
        options.over.push_back(io::read_asked_range(*c.of, text));
    for (const std::string& text : tolerances)
        options.tolerances.push_back(io::read_asked_tolerance(*c.of, text));
    if (samples < 1 || samples > advice::most_samples)
        base::refuse("samples = " + std::to_string(samples) + " is out of range", "",
                     "Take 1 to " + std::to_string(advice::most_samples) + ".");
    options.runs = io::read_asked_runs(runs[0], runs[1]);
    options.chance.samples = samples;
    options.crew = crew::thread_crews(threads);
    options.progress = [&](const advice::AdviceProgress& now) {
        call_python(progress, [&] { progress(static_cast<int>(100.0 * now.share), 100, py::dict()); });
    };
    return python_text(unlocked([&](const std::stop_token& stop) {
        options.stop = stop;
        return io::advice_json(advice::advise(*c.of, options));
    }));
}

// writes the sound of a case into a WAV file; what was made of it, as JSON
py::str listen(const CaseHandle& c, const std::array<std::string, 6>& asked, const std::string& file) {
    return python_text(unlocked([&](const std::stop_token& stop) {
        io::ListeningTexts texts;
        texts.direction = asked[0], texts.of = asked[1], texts.quantity = asked[2];
        texts.component = asked[3], texts.rate = asked[4], texts.seconds = asked[5];
        const std::string text = io::case_toml(*c.of, {.comments = io::Comments::none, .heading = ""});
        const io::ListeningChoice choice = io::chosen_case(texts, {text, "the case", {}});
        const hearing::HeardMotion motion = hearing::heard_motion(choice.c, io::asked_motion(texts), stop);
        const sound::AuralisationSettings settings = io::listening_settings(texts, choice.c, motion);
        const std::unique_ptr<hearing::RenderedSound> sound = hearing::render(choice.c, settings, stop, [](double) {});
        io::SoundInfo info = io::sound_info(texts, choice, motion, settings, *sound);
        info.file = file;
        const std::string history = recordings::case_mark + text;
        recordings::write_wav(file, *sound,
                              {recordings::WavSamples::pcm_24,
                               {{info.full_scale, info.unit}},
                               io::sound_description(info, choice.c),
                               history.size() > recordings::longest_history ? std::string() : history});
        return io::listen_json(choice.c, info);
    }));
}

py::str classify(const std::string& path, const Texts& full_scales, const std::string& channel) {
    return python_text(unlocked([&](const std::stop_token& stop) {
        recordings::OpenOptions options;
        options.full_scales = recordings::parse_full_scales(full_scales);
        options.channel_name = channel;
        const std::unique_ptr<recordings::SignalFile> file = recordings::open_signal(path, options);
        io::SoundReport report;
        report.file = file->facts().name;
        report.format = file->facts().format;
        report.notes = file->facts().notes;
        report.channels = sound::analyse(*file, [&](std::uint64_t) {
            if (stop.stop_requested()) throw Error(ErrorKind::interrupted, {"stopped", "", "Run it again."});
        });
        for (const sound::SoundAnalysis& analysis : report.channels)
            report.verdicts.push_back(classification::verdict_on(analysis, report.thresholds));
        report.loudest = sound::loudest(report.channels);
        return io::classify_json(report);
    }));
}

py::str find(const std::string& library, const Texts& conditions, const std::string& words, const std::string& sort) {
    return python_text(unlocked([&](const std::stop_token&) {
        noise_library::Library opened = noise_library::open_library(library, noise_library::Access::read);
        noise_library::Query query = noise_library::parse_query(conditions, words, sort);
        query.extent = noise_library::EntryExtent::whole;
        std::string document;
        io::library_json(opened, query, [&](std::string_view piece) { document += piece; });
        return document;
    }));
}

using TableColumn =
    std::tuple<std::string, int, py::array_t<double>, std::vector<std::string>, std::map<std::string, std::string>>;

// a stream for whoever takes it; where nobody does it ends with the capsule
py::capsule arrow_stream(const std::vector<TableColumn>& columns, const std::map<std::string, std::string>& about) {
    io::ArrowTable table{{}, about};
    for (const auto& [name, kind, values, texts, of] : columns)
        table.columns.push_back(
            {name, of, static_cast<io::ArrowKind>(kind), {values.data(), values.data() + values.size()}, texts});
    auto* stream = new ArrowArrayStream(io::arrow_stream(std::move(table)));
    return py::capsule(stream, "arrow_array_stream", [](PyObject* capsule) {
        auto* owned = static_cast<ArrowArrayStream*>(PyCapsule_GetPointer(capsule, "arrow_array_stream"));
        if (owned->release != nullptr) owned->release(owned);
        delete owned;
    });
}

}  // namespace

void bind_answers(py::module_& module) {
    module.def("arrow_stream", &arrow_stream, py::arg("columns"), py::arg("about"));
    module.def("stability", &stability, py::arg("case"), py::arg("over"));
    module.def("advise", &advise, py::arg("case"), py::arg("over"), py::arg("tolerances"), py::arg("runs"),
               py::arg("samples"), py::arg("threads"), py::arg("progress"));
    module.def("listen", &listen, py::arg("case"), py::arg("asked"), py::arg("file"));
    module.def("classify", &classify, py::arg("path"), py::arg("full_scales"), py::arg("channel"));
    module.def("find", &find, py::arg("library"), py::arg("conditions"), py::arg("words"), py::arg("sort"));
}

}  // namespace stridor::binding
