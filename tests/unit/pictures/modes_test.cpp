#include "stridor/pictures/modes.hpp"

#include "pictures_support.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace stridor::pictures {
namespace {

analysis::StabilityScan scan_of(const parameters::Case& c) {
    return analysis::with_modes(analysis::scan_stability(c, std::nullopt));
}

TEST(ModeShapes, StandForTheDirectionThatGrows) {
    const drawing::Scene scene = mode_shapes(scan_of(parameters::paper_case(parameters::PaperCase::squeal)));
    ASSERT_EQ(scene.panels.size(), 3U) << "one mode grows";
    EXPECT_NE(drawing::plain_text(scene.caption.front()).find("going"), std::string::npos);
    EXPECT_NE(drawing::plain_text(scene.panels.front().title).find("592.0 Hz, +736.7 1/s"), std::string::npos)
        << drawing::plain_text(scene.panels.front().title);
}

TEST(ModeShapes, HaveABarForEachContactThatFeeds) {
    parameters::Case c = parameters::two_lips();
    c.contact().kinetic_friction = 0.7;
    c.joints[1].contact.kinetic_friction = 0.7;
    const analysis::StabilityScan scan = scan_of(c);
    const drawing::Scene scene = mode_shapes(scan);
    ASSERT_EQ(scene.panels.size() % 3, 0U);
    const auto growth = [](const analysis::DirectionScan& direction) {
        return direction.modes->modes.empty() ? -1e9 : direction.modes->modes.front().eigenvalue.real();
    };
    const analysis::DirectionScan& shown =
        growth(scan.directions[0]) >= growth(scan.directions[1]) ? scan.directions[0] : scan.directions[1];
    for (const drawing::Panel& panel : scene.panels) {
        if (panel.row != 1) continue;
        const std::vector<double>& each = shown.modes->modes[panel.column].contact_growth;
        // a contact that sliding lifts off feeds nothing
        const auto feeding = std::count_if(each.begin(), each.end(), [](double value) { return value != 0.0; });
        EXPECT_GE(feeding, 1);
        std::size_t bars = 0;
        for (const drawing::Layer& layer : panel.layers)
            if (const auto* boxes = std::get_if<drawing::Boxes>(&layer)) bars += boxes->boxes.size();
        EXPECT_EQ(bars, static_cast<std::size_t>(feeding));
        EXPECT_EQ(panel.x.ticks.size(), 2U);
    }
    // shares of energy lie on their axis
    for (const drawing::Panel& panel : scene.panels)
        for (const drawing::Layer& layer : panel.layers)
            if (const auto* boxes = std::get_if<drawing::Boxes>(&layer))
                for (const drawing::Box& box : boxes->boxes) {
                    EXPECT_GE(box.y.from, panel.y.range.from);
                    EXPECT_LE(box.y.to, panel.y.range.to);
                }
}

constexpr double turn = 6.283185307179586476925;

std::vector<double> wave(double amplitude, double frequency) {
    std::vector<double> values;
    for (int k = 0; k < 8192; ++k)
        values.push_back(amplitude * std::sin(turn * frequency * k / 8192.0));
    return values;
}

std::vector<std::string> numbers_of(const drawing::Panel& panel) {
    std::vector<std::string> numbers;
    for (const drawing::Layer& layer : panel.layers)
        if (const auto* note = std::get_if<drawing::Note>(&layer)) numbers.push_back(drawing::plain_text(note->text));
    return numbers;
}

TEST(ModalSpectrumPicture, SaysWhichModeHasWhichLine) {
    // at 300 Hz two modes of which the second works against the first: 3/2 and -1/2
    std::vector<double> first = wave(0.3, 300.0);
    const std::vector<double> tone = wave(0.2, 100.0);
    for (std::size_t k = 0; k < first.size(); ++k)
        first[k] += tone[k];
    const std::vector<std::vector<double>> parts{first, wave(-0.1, 300.0), std::vector<double>(8192, 0.0)};
    const analysis::ModalSpectrum spectrum = analysis::modal_spectrum(parts, 8192.0, 8192);
    const analysis::OpenModes modes{{90.0, 310.0, 2000.0}, Eigen::Matrix3d::Identity()};
    const drawing::Scene scene = modal_spectrum("two", "tip velocity", modes, spectrum);
    ASSERT_EQ(scene.panels.size(), 2U);
    const drawing::Panel& shares = scene.panels[1];
    ASSERT_EQ(shares.x.ticks.size(), 2U);
    EXPECT_EQ(drawing::plain_text(shares.x.ticks[0].label), "100 Hz");
    EXPECT_EQ(drawing::plain_text(shares.x.ticks[1].label), "300 Hz");
    ASSERT_EQ(shares.y.ticks.size(), 2U) << "the third mode has nothing, and there are no others";
    EXPECT_EQ(drawing::plain_text(shares.y.ticks[0].label), "1: 90 Hz");
    EXPECT_EQ(numbers_of(shares), (std::vector<std::string>{"100", "150", "-50"}));
}

TEST(ModalSpectrumPicture, OfSilenceIsRefused) {
    const std::vector<std::vector<double>> silence{std::vector<double>(256, 0.0)};
    const analysis::ModalSpectrum spectrum = analysis::modal_spectrum(silence, 1000.0, 256);
    const auto thrown = support::thrown_by([&] {
        modal_spectrum("", "tip velocity", {{10.0}, Eigen::MatrixXd(1, 1)}, spectrum);
    });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("no line")) << thrown.message;
}

}  // namespace
}  // namespace stridor::pictures
