#pragma once

#include "stridor/classification/verdict.hpp"
#include "stridor/sound/passages.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace stridor::classification {

/// What the ear can hear in a passage of a recording. Rubbing without noise, and other sounds such as wind, water,
/// steps, voices and engines, are both `Category::none`.
enum class EarOutcome : std::uint8_t { rubbing, other, squeal, squeak, creak };

inline constexpr std::array<std::string_view, 5> heard_names{"rubbing", "other", "squeal", "squeak", "creak"};

/// Returns the category of what was heard.
constexpr Category category_of(EarOutcome heard) {
    constexpr std::array categories{Category::none, Category::none, Category::squeal, Category::squeak,
                                    Category::creak};
    return categories[static_cast<std::size_t>(heard)];
}

/// A figure of a passage by which the ear judges, as it enters the sum. docs/methods/ear.md has the formulas.
struct EarFigure {
    std::string_view name;  // "onset_rate"
    std::string_view unit;  // of the value that enters: "octave", "dB", "1"
    double (*value)(const sound::Passage&);
};

inline constexpr std::size_t ear_figure_count = 16;

/// Returns all figures, in the order of the weights.
std::span<const EarFigure, ear_figure_count> ear_figures();

using EarValues = std::array<double, ear_figure_count>;

/// The ear's verdict on a passage.
struct EarVerdict {
    std::array<double, heard_names.size()> probabilities{};  // [1] by `EarOutcome`, of sum 1
    EarValues values{};                                      // in the order of `ear_figures`
    EarOutcome heard = EarOutcome::other;                    // the most probable
    EarOutcome rival = EarOutcome::squeak;                   // the most probable one of another category
    EarValues reasons{};  // [1] share of each figure in the logarithm of the odds of the one against the other
};

/// Returns the ear's verdict by multinomial logistic regression (Bishop 2006, section 4.3.4): the probability of h is
///
///     p_h = exp(s_h) / Σ exp(s),   s_h = b_h + Σ w_hk clip((x_k - mean_k) / scale_k, -2.5, 2.5)
///
/// Weights: ear_weights.hpp, fitted by bench/ear/train.py. Gain does not matter.
EarVerdict hear(const sound::Passage& passage);

}  // namespace stridor::classification
