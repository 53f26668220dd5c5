#include "sound.hpp"

#include "stridor/base/error.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/sweep/run_sound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

namespace stridor::app {

namespace {

[[noreturn]] void fail(const char* what) {
    throw Error(ErrorKind::io, {what, std::strerror(errno), "Set TMPDIR to a folder with more space?"});
}

void require_result(const integration::Outcome& outcome) {
    if (outcome.reason == integration::Reason::cancelled)
        throw Error(ErrorKind::interrupted, {fmt::format("stopped at {:.6g} s of the motion", outcome.time),
                                             "half a sound is not kept", "Run the same command again."});
    if (!integration::has_result(outcome))
        throw Error(ErrorKind::numerical,
                    {fmt::format("the motion cannot be heard beyond {:.6g} s", outcome.time),
                     std::string(integration::reason_names[static_cast<std::size_t>(outcome.reason)]),
                     "`stridor simulate` with the same case says more."});
}

}  // namespace

Spool::Spool(double rate, std::string unit) : layout_{rate, {{"", std::move(unit)}}, 0}, file_(std::tmpfile()) {
    if (!file_) fail("no temporary file could be made");
}

void Spool::append(std::span<const double> samples) {
    if (std::fwrite(samples.data(), sizeof(double), samples.size(), file_.get()) != samples.size())
        fail("the sound could not be kept in a temporary file");
    for (const double sample : samples)
        square_sum_ += sample * sample;
    peak_ = std::max(peak_, signal::peak(samples));
    *layout_.frames += samples.size();
}

void Spool::rewind() {
    if (std::fflush(file_.get()) != 0) fail("the sound could not be kept in a temporary file");
    std::rewind(file_.get());
}

double Spool::mean_square() const {
    return frames() > 0 ? square_sum_ / static_cast<double>(frames()) : 0.0;
}

std::size_t Spool::read(std::span<double> frames) {
    const std::size_t count = std::fread(frames.data(), sizeof(double), frames.size(), file_.get());
    if (count < frames.size() && std::ferror(file_.get()) != 0) fail("the temporary file could not be read");
    return count;
}

Rendering render(const parameters::Case& c, const signal::AuralisationSettings& settings, record::KeepHistory history,
                 const std::stop_token& stop, const RenderProgress& progress) {
    sweep::check_audible(c, settings);
    auto sound = std::make_unique<Spool>(settings.rate, signal::unit_of(settings.pickup.quantity));
    signal::Auralisation auralisation(settings);
    record::Request request;
    request.history = history;
    request.trace = auralisation.request(c.run.duration, [&](std::span<const double> block) { sound->append(block); });
    request.trace.taker = [&progress, taker = request.trace.taker](const record::Trace& trace) {
        taker(trace);
        if (progress) progress(trace.time.back());
    };
    integration::Motion motion = integration::simulate(c, request, stop);
    require_result(motion.outcome);
    sound->append(auralisation.finish());
    sound->rewind();
    return {std::move(sound), std::move(motion.record)};
}

std::unique_ptr<Spool> render(const parameters::Case& c, const signal::AuralisationSettings& settings,
                              const std::stop_token& stop, const RenderProgress& progress) {
    return render(c, settings, record::KeepHistory::no, stop, progress).sound;
}

}  // namespace stridor::app
