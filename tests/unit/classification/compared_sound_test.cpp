#include "stridor/classification/compared_sound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stridor::classification {
namespace {

const ComparedFigure& figure(std::string_view name) {
    const auto all = compared_figures();
    const auto at = std::find_if(all.begin(), all.end(), [&](const ComparedFigure& f) { return f.name == name; });
    if (at == all.end()) throw std::invalid_argument(std::string(name));
    return *at;
}

std::string text(std::string_view name, const ComparedSound& sound) {
    return figure_text(figure(name), sound);
}

// 1 Pa rms, and a hammer every 4.2 ms
ComparedSound hammering() {
    ComparedSound sound;
    sound.analysis.unit = "Pa";
    sound.profile.features.mean_square = 1.0;
    sound.profile.features.frequency = 425.4;
    sound.profile.features.movement = 0.18;
    sound.profile.features.kurtosis = 12.0;
    sound.profile.impulse_interval = 4.2e-3;
    sound.profile.impulse_regularity = 0.25;
    return sound;
}

// a phase whose joint vibrates so much
Verdict phase(double rms, double slip) {
    Verdict verdict;
    verdict.evidence.levels.joint.rms = rms;
    verdict.evidence.rates.slip = slip;
    verdict.evidence.alternation.frequency = 250.0 * slip;
    verdict.evidence.alternation.regularity = slip;
    return verdict;
}

TEST(ComparedFigures, AreWrittenWithTheirUnits) {
    const ComparedSound sound = hammering();
    EXPECT_EQ(text("frequency", sound), "425 Hz");
    EXPECT_EQ(text("movement", sound), "18.0 %");
    EXPECT_EQ(text("impulse_interval", sound), "4.2 ms");
    EXPECT_EQ(text("impulse_regularity", sound), "0.25");
    EXPECT_EQ(text("level", sound), "94.0 dB");  // 1 Pa over 20 µPa
}

TEST(ComparedFigures, AreUnknownWhereTheSoundHasNoSuchThing) {
    ComparedSound sound = hammering();
    sound.profile.features.frequency = 0.0;
    EXPECT_EQ(text("frequency", sound), "-");
    sound.profile.features.repetition_frequency = 0.0;
    EXPECT_EQ(text("repetition_frequency", sound), "-");
    sound.profile.features.repetition_frequency = 100.0;
    EXPECT_EQ(text("repetition_frequency", sound), "100 Hz");
}

TEST(ComparedFigures, HaveImpulsesOnlyAboveNoise) {
    ComparedSound sound = hammering();
    sound.profile.features.kurtosis = 3.0;  // that of Gaussian noise
    EXPECT_EQ(text("impulse_interval", sound), "-");
    EXPECT_EQ(text("impulse_regularity", sound), "-");
    sound.profile.features.kurtosis = 3.1;
    EXPECT_EQ(text("impulse_interval", sound), "4.2 ms");
    sound.profile.impulse_interval = 0.0;
    EXPECT_EQ(text("impulse_regularity", sound), "-");
}

TEST(ComparedFigures, OfTheContactAreThoseOfTheLoudestPhase) {
    ComparedSound sound = hammering();
    EXPECT_EQ(loudest_phase(sound.contact), nullptr);
    for (const char* name : {"slip", "stick", "separation", "contact_regularity", "contact_frequency"})
        EXPECT_EQ(text(name, sound), "-") << name << " of a recording";

    sound.contact.verdicts = {phase(1e-3, 0.1), phase(3e-3, 0.6), phase(2e-3, 0.9)};
    EXPECT_EQ(loudest_phase(sound.contact), &sound.contact.verdicts[1]);
    EXPECT_EQ(text("slip", sound), "60.0 %");
    EXPECT_EQ(text("contact_regularity", sound), "0.600");
    EXPECT_EQ(text("contact_frequency", sound), "150 Hz");

    sound.contact.verdicts = {phase(1e-3, 0.0), phase(1e-3, 0.9)};
    EXPECT_EQ(loudest_phase(sound.contact), &sound.contact.verdicts[0]) << "going, of two that are as loud";
    EXPECT_EQ(text("contact_frequency", sound), "-") << "a contact that does not alternate";
}

}  // namespace
}  // namespace stridor::classification
