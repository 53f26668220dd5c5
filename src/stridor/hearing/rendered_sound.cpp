#include "stridor/hearing/rendered_sound.hpp"

#include "stridor/base/error.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stridor::hearing {

RenderedSound::RenderedSound(double rate, std::string unit) : layout_{rate, {{"", std::move(unit)}}, 0} {}

void RenderedSound::append(std::span<const double> samples) {
    const std::span<const std::byte> bytes = std::as_bytes(samples);
    file_.append({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    for (const double sample : samples)
        square_sum_ += sample * sample;
    peak_ = std::max(peak_, sound::peak(samples));
    *layout_.frames += samples.size();
}

void RenderedSound::rewind() {
    next_ = 0;
}

double RenderedSound::mean_square() const {
    return frames() > 0 ? square_sum_ / static_cast<double>(frames()) : 0.0;
}

std::size_t RenderedSound::read(std::span<double> frames) {
    const std::span<std::byte> bytes = std::as_writable_bytes(frames);
    const std::size_t count = file_.read_at(next_, {reinterpret_cast<char*>(bytes.data()), bytes.size()});
    next_ += count;
    return count / sizeof(double);
}

Rendering render(const parameters::Case& c, const sound::AuralisationSettings& settings, record::KeepHistory history,
                 const std::stop_token& stop, const RenderProgress& progress) {
    check_audible(c, settings);
    auto sound = std::make_unique<RenderedSound>(settings.rate, sound::unit_of(settings.pickup.quantity));
    sound::Auralisation auralisation(settings);
    record::Request request;
    request.history = history;
    request.trace = auralisation.request(c.run.duration, [&](std::span<const double> block) { sound->append(block); });
    request.trace.taker = [&progress, taker = request.trace.taker](const record::Trace& trace) {
        taker(trace);
        if (progress) progress(trace.time.back());
    };
    integration::Motion motion = integration::simulate(c, request, stop);
    if (const std::optional<Error> failure = integration::failure(c, motion)) throw Error(*failure);
    sound->append(auralisation.finish());
    sound->rewind();
    return {std::move(sound), std::move(motion.record)};
}

std::unique_ptr<RenderedSound> render(const parameters::Case& c, const sound::AuralisationSettings& settings,
                                      const std::stop_token& stop, const RenderProgress& progress) {
    return render(c, settings, record::KeepHistory::no, stop, progress).sound;
}

}  // namespace stridor::hearing
