// Between the samples x[m] of the old rate stand up - 1 zeros; a low pass h at the rate `up` times higher makes a
// smooth signal of them, of which every down-th sample is kept:
//
//     y[n] = up Σₘ h[n down - m up] x[m]
//
// Only every up-th tap meets a sample that is not zero: which ones depends on the phase (n down) mod up alone. Each
// phase has its own row of taps, so no zero is ever multiplied.

#include "stridor/signal/resample.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace stridor::signal {

namespace {

constexpr double most = 4096.0;  // largest number of a ratio: its rows of taps then stay below 10 MB

// frames that are read at a time
constexpr std::size_t resampled_block = 1U << 14U;

// four sums, so that one addition need not wait for the other; their order never changes
double product(const double* a, const double* b, std::size_t count) {
    double sum[4] = {};
    std::size_t k = 0;
    for (; k + 4 <= count; k += 4)
        for (std::size_t lane = 0; lane < 4; ++lane)
            sum[lane] += a[k + lane] * b[k + lane];
    for (; k < count; ++k)
        sum[0] += a[k] * b[k];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

void require_rate(double rate) {
    if (!(rate > 0.0) || !std::isfinite(rate))
        throw Error(ErrorKind::input,
                    {"a sampling rate of " + base::shortest(rate) + " Hz is none", "it must be a positive number", ""});
}

}  // namespace

RateRatio rate_ratio(double from, double to) {
    require_rate(from);
    require_rate(to);
    // continued fraction of to / from: each convergent is the nearest ratio of numbers up to its own
    double value = to / from;
    double up[2] = {1.0, 0.0};
    double down[2] = {0.0, 1.0};
    for (int k = 0; k < 32; ++k) {
        const double whole = std::floor(value);
        const double next_up = whole * up[0] + up[1];
        const double next_down = whole * down[0] + down[1];
        if (next_up > most || next_down > most) break;
        up[1] = std::exchange(up[0], next_up);
        down[1] = std::exchange(down[0], next_down);
        const double rest = value - whole;
        // what rounding leaves of a quotient that ends here
        if (rest < 1e-9 || std::abs(up[0] * from - down[0] * to) <= 1e-12 * up[0] * from) break;
        value = 1.0 / rest;
    }
    if (up[0] < 1.0 || down[0] < 1.0 || std::abs(up[0] * from / (down[0] * to) - 1.0) > 1e-3)
        throw Error(ErrorKind::input,
                    {"a signal of " + base::shortest(from) + " Hz cannot be resampled to " + base::shortest(to) + " Hz",
                     "the rates are too far apart", ""});
    return {static_cast<int>(up[0]), static_cast<int>(down[0])};
}

LowPass low_pass_for(RateRatio ratio) {
    const double lower = 1.0 / std::max(ratio.up, ratio.down);  // of both rates, as a share of `up` times the old one
    return {0.45 * lower, 0.5 * lower};
}

Resampler::Resampler(RateRatio ratio, const LowPass& design) : ratio_(ratio) {
    STRIDOR_EXPECT(ratio.up >= 1 && ratio.down >= 1);
    const std::vector<double> all = low_pass_taps(design);
    const auto up = static_cast<std::size_t>(ratio.up);
    const std::size_t half = all.size() / 2;
    const std::size_t side = half / up + 1;  // input samples on either side that a tap can reach
    width_ = 2 * side;
    reach_ = side;
    before_ = side - 1;
    taps_.assign(up * width_, 0.0);
    // output at phase p lies p/up after input sample i; row entry j meets input i - (side - 1) + j
    for (std::size_t phase = 0; phase < up; ++phase)
        for (std::size_t j = 0; j < width_; ++j) {
            const std::ptrdiff_t place =
                static_cast<std::ptrdiff_t>(half + phase + (side - 1) * up) - static_cast<std::ptrdiff_t>(j * up);
            if (place >= 0 && place < static_cast<std::ptrdiff_t>(all.size()))
                taps_[phase * width_ + j] = static_cast<double>(ratio.up) * all[static_cast<std::size_t>(place)];
        }
    history_.assign(before_, 0.0);
}

// makes the output samples that need no input beyond the first `known`
void Resampler::produce(std::vector<double>& output, std::uint64_t known) {
    const auto up = static_cast<std::uint64_t>(ratio_.up);
    const auto down = static_cast<std::uint64_t>(ratio_.down);
    for (;; ++produced_) {
        const std::uint64_t fine = produced_ * down;
        const std::uint64_t sample = fine / up;
        if (sample + reach_ >= known) break;
        const std::size_t phase = fine % up;
        // the zeros in front shift the input, so that the row begins at place `sample`
        output.push_back(product(&taps_[phase * width_], &history_[sample - dropped_], width_));
    }
    const std::uint64_t needed = std::min<std::uint64_t>(produced_ * down / up, dropped_ + history_.size());
    if (needed - dropped_ > history_.size() / 2) {
        history_.erase(history_.begin(), history_.begin() + static_cast<std::ptrdiff_t>(needed - dropped_));
        dropped_ = needed;
    }
}

std::vector<double> Resampler::push(std::span<const double> input) {
    history_.insert(history_.end(), input.begin(), input.end());
    received_ += input.size();
    std::vector<double> output;
    output.reserve(input.size() * static_cast<std::size_t>(ratio_.up) / static_cast<std::size_t>(ratio_.down) + 1);
    produce(output, received_);
    return output;
}

std::vector<double> Resampler::finish() {
    history_.insert(history_.end(), width_, 0.0);
    std::vector<double> output;
    produce(output, received_ + reach_);  // all that fall on or after an input sample and before the next
    return output;
}

Signal resampled(const Signal& signal, double rate) {
    Resampler resampler(rate_ratio(signal.rate, rate));
    Signal result{rate, signal.unit, resampler.push(signal.samples)};
    const std::vector<double> rest = resampler.finish();
    result.samples.insert(result.samples.end(), rest.begin(), rest.end());
    return result;
}

namespace {

class Resampled final : public Source {
public:
    Resampled(std::unique_ptr<Source> source, double rate) : source_(std::move(source)), layout_(source_->layout()) {
        const RateRatio ratio = rate_ratio(layout_.rate, rate);
        const auto up = static_cast<std::uint64_t>(ratio.up);
        const auto down = static_cast<std::uint64_t>(ratio.down);
        layout_.rate = rate;
        if (layout_.frames) layout_.frames = (*layout_.frames * up + down - 1) / down;
        channels_.assign(width(), Resampler(ratio));
        ready_.resize(width());
    }

    const ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        STRIDOR_EXPECT(frames.size() % width() == 0);
        const std::size_t wanted = frames.size() / width();
        std::size_t count = 0;
        while (count < wanted) {
            if (next_ == ready_.front().size() && !refill()) break;
            const std::size_t some = std::min(wanted - count, ready_.front().size() - next_);
            for (std::size_t k = 0; k < some; ++k)
                for (std::size_t channel = 0; channel < width(); ++channel)
                    frames[(count + k) * width() + channel] = ready_[channel][next_ + k];
            count += some;
            next_ += some;
        }
        return count;
    }

private:
    std::size_t width() const { return layout_.channels.size(); }

    // the next output samples; are there any more?
    bool refill() {
        next_ = 0;
        std::vector<double> block(resampled_block * width());
        while (!is_finished_) {
            const std::size_t count = source_->read(block);
            is_finished_ = count == 0;
            std::vector<double> one(count);
            for (std::size_t channel = 0; channel < width(); ++channel) {
                for (std::size_t frame = 0; frame < count; ++frame)
                    one[frame] = block[frame * width() + channel];
                ready_[channel] = is_finished_ ? channels_[channel].finish() : channels_[channel].push(one);
            }
            if (!ready_.front().empty()) return true;
        }
        for (std::vector<double>& channel : ready_)
            channel.clear();
        return false;
    }

    std::unique_ptr<Source> source_;
    ChannelLayout layout_;
    std::vector<Resampler> channels_;
    std::vector<std::vector<double>> ready_;  // shape [channel][frame]
    std::size_t next_ = 0;                    // first frame of ready_ that nobody has read
    bool is_finished_ = false;
};

}  // namespace

std::unique_ptr<Source> resampled(std::unique_ptr<Source> source, double rate) {
    if (source->layout().rate == rate) return source;
    return std::make_unique<Resampled>(std::move(source), rate);
}

}  // namespace stridor::signal
