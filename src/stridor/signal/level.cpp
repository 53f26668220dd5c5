#include "stridor/signal/level.hpp"

#include "stridor/base/decibels.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/signal/side_by_side.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::signal {

namespace {

struct Reference {
    std::string_view unit;
    double value;
    std::string_view name;
};

constexpr std::array<Reference, 4> references{{
    {"Pa", 2e-5, "20 uPa"},
    {"m/s", 1e-9, "1e-9 m/s"},
    {"m/s^2", 1e-6, "1e-6 m/s^2"},
    {"N", 1e-6, "1e-6 N"},
}};

const Reference* find_reference(std::string_view unit) {
    const auto found = std::find_if(references.begin(), references.end(),
                                    [&](const Reference& reference) { return reference.unit == unit; });
    return found == references.end() ? nullptr : &*found;
}

constexpr std::size_t most_kept = 8192;
constexpr double interval = 0.05;  // [s]

}  // namespace

double reference_of(std::string_view unit) {
    const Reference* found = find_reference(unit);
    return found == nullptr ? 1.0 : found->value;
}

std::string level_unit(std::string_view unit) {
    const Reference* found = find_reference(unit);
    if (found != nullptr) return "dB re " + std::string(found->name);
    return unit == "FS" ? "dB re FS" : "dB re 1 " + std::string(unit);
}

double level_of(double mean_square, double reference) {
    return base::decibels_of_power(mean_square / (reference * reference));
}

LevelMeter::LevelMeter(double rate, double reference, double time_constant)
    : rate_(rate),
      reference_(reference),
      state_{.share = 1.0 - base::exponential(-1.0 / (rate * time_constant))},
      stride_(std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(interval * rate)))),
      until_(stride_) {}

void LevelMeter::push(std::span<const double> samples) {
    push_side_by_side(samples, *this);
}

void LevelMeter::end(const State& state, std::size_t count) {
    state_ = state;
    until_ -= count;
    if (until_ == 0) keep();
}

void LevelMeter::keep() {
    kept_.push_back(state_.peak);
    greatest_ = std::max(greatest_, state_.peak);
    state_.peak = 0.0;
    if (kept_.size() == most_kept) {
        for (std::size_t k = 0; 2 * k < kept_.size(); ++k)
            kept_[k] = std::max(kept_[2 * k], kept_[2 * k + 1]);
        kept_.resize(most_kept / 2);
        stride_ *= 2;
    }
    until_ = stride_;
}

LevelHistory LevelMeter::history() const {
    LevelHistory result;
    result.interval = static_cast<double>(stride_) / rate_;
    for (const double mean_square : kept_)
        result.decibels.push_back(level_of(mean_square, reference_));
    result.greatest = level_of(std::max(greatest_, state_.peak), reference_);
    return result;
}

}  // namespace stridor::signal
