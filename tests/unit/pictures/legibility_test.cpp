#include "pictures_support.hpp"
#include "stridor/analysis/modal_spectrum.hpp"
#include "stridor/base/error.hpp"
#include "stridor/drawing/labels.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/pictures/contact_states.hpp"
#include "stridor/pictures/diagram.hpp"
#include "stridor/pictures/friction_law.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/modes.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/parts/chart_cells.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/sensitivity.hpp"
#include "stridor/pictures/side_by_side.hpp"
#include "stridor/pictures/sound.hpp"
#include "stridor/pictures/stability.hpp"
#include "stridor/pictures/strokes.hpp"
#include "stridor/pictures/time_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stridor::pictures {
namespace {

using NamedScene = std::pair<std::string, drawing::Scene>;

const std::string long_name =
    "Door seal, rear left, part 4711-0815-A of lot 12 after 240 h at 80 degC and 95 % humidity, "
    "as/it/was/found/on/the/vehicle/in/the/climate/chamber/without/any/blank/in/this/part/of/its/name.toml";

parameters::Case extreme() {
    parameters::Case c;
    c.title = long_name;
    c.contact().preload = 123456.0;
    c.contact().static_friction = 0.00011;
    c.contact().kinetic_friction = 0.0001;
    c.drive.velocity = 1.23456e-7;
    c.joint().incidence_angle = -123.456;
    return c;
}

const record::ContactHistory each_state_once{{model::ContactState::slip, 0.0, 0.2, 0.0, 0.0},
                                             {model::ContactState::separation, 0.2, 0.3, 0.0, 0.0},
                                             {model::ContactState::stick, 0.3, 1.0, 0.0, 0.0}};

drawing::Scene motion(double size) {
    record::Record record;
    record.trace = record::empty_trace(3);
    for (int i = 0; i < 1000; ++i) {
        record.trace.time.push_back(i * 1e-3);
        record.trace.surface_velocity.push_back(size);
        for (auto* values : {&record.trace.displacement, &record.trace.velocity, &record.trace.acceleration})
            for (std::vector<double>& dof : *values)
                dof.push_back(size * std::sin(0.1 * i));
    }
    record.histories = {each_state_once};
    TimeHistoryOptions options;
    options.zoom = drawing::Extent{0.123456, 0.234567};
    return time_history(extreme(), record, options);
}

drawing::Scene contacts(std::size_t count) {
    parameters::Case c = extreme();
    c.drive.kind = parameters::DriveKind::constant;
    c.run.duration = 1.0;
    parameters::OwnStructure structure;
    record::Record record;
    record::Tally tally;
    tally.contacts.clear();
    for (std::size_t k = 0; k < count; ++k) {
        parameters::OwnContact contact;
        contact.name = "node_" + std::to_string(1000000 + k) + " of the lip's edge beside the corner";
        contact.preload_share = 1.0;
        structure.contacts.push_back(contact);
        tally.contacts.emplace_back().judged_time = {0.1, 0.4, 0.0};
        record.histories.push_back(each_state_once);
    }
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(structure));
    record.phases = {tally};
    return many_contacts(c, record, {{0.1, 0.11}});
}

drawing::Scene modes() {
    parameters::Case c = parameters::two_lips();
    c.title = long_name;
    c.joints[0].name = "upper_lip_of_the_rear_left_door_seal";
    c.contact().kinetic_friction = c.joints[1].contact.kinetic_friction = 0.7;
    return mode_shapes(analysis::with_modes(analysis::scan_stability(c, std::nullopt)));
}

drawing::Scene spectrum() {
    std::vector<std::vector<double>> parts(3, std::vector<double>(8192, 0.0));
    for (std::size_t line = 1; line < 9; ++line)
        for (std::size_t k = 0; k < 8192; ++k)
            parts[line % 3][k] += std::sin(6.283185307179586 * 300.0 * static_cast<double>(line * k) / 8192.0);
    return modal_spectrum(long_name, "velocity of " + long_name, {{90.0, 310.0, 2000.0}, Eigen::Matrix3d::Identity()},
                          analysis::modal_spectrum(parts, 8192.0, 8192));
}

// onsets nearer to each other than their names are wide
analysis::StabilityScan close_onsets(const char* key, const char* unit, double at) {
    analysis::StabilityScan scan;
    scan.base = extreme();
    scan.key = key;
    scan.unit = unit;
    for (const parameters::Direction direction : {parameters::Direction::going, parameters::Direction::coming}) {
        analysis::DirectionScan one;
        one.direction = direction;
        for (int i = 0; i <= 20; ++i) {
            analysis::SlidingStability stability;
            stability.modes = {{i - 10.0, 600.0 + i}, {-1.0, 987654.3}};
            one.path.points.push_back({0.1 * at * i, stability});
        }
        for (const double share : {0.02, 0.99, 1.0, 1.01, 1.02, 1.97, 1.99})
            one.path.boundaries.push_back(
                {share * at, analysis::StabilityKind::stable, analysis::StabilityKind::flutter, 600.0});
        scan.directions.push_back(one);
    }
    return scan;
}

sweep::SweepResult chart(bool has_failures) {
    sweep::SweepResult result = quiet_sweep();
    result.study.base = extreme();
    result.study.x = {"contact.preload", 1e-6, 1e6, 4, sweep::Scale::logarithmic};
    result.study.y = {"contact.kinetic_friction", 0.0001, 0.0002, 3, sweep::Scale::linear};
    for (std::size_t k = 0; has_failures && k < result.cells.size(); ++k)
        result.cells[k].status = static_cast<sweep::Status>(k % sweep::status_names.size());
    return result;
}

drawing::Scene marked(drawing::Scene scene, const sweep::Study& study) {
    mark_design(scene, study);
    return scene;
}

drawing::Scene over_one_axis() {
    sweep::SweepResult result = chart(false);
    result.study.y = {};
    result.study.y.points = 1;
    result.cells.resize(sweep::cell_count(result.study));
    std::vector<sweep::DiagramCell> cells(result.cells.size());
    for (sweep::DiagramCell& cell : cells)
        cell.extremes = {-1.23456e-7, 9.87654e-7};
    return diagram(result, cells);
}

drawing::Scene records() {
    std::vector<noise_library::Entry> entries(4);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        entries[k].id = static_cast<std::int64_t>(k) + 1;
        entries[k].preload = 1e-4 * std::pow(100.0, static_cast<double>(k));
        entries[k].category = k == 0 ? "a word of the engineer's own for what was heard" : "squeal";
        entries[k].figures = {{"level", "dB", 50.0 + static_cast<double>(k)}};
    }
    return sensitivity(noise_library::sensitivity(entries, {}));
}

classification::ComparedSound compared() {
    classification::ComparedSound sound;
    sound.label = long_name;
    sound.origin = "recording";
    sound.what = long_name;
    sound.analysis.duration = 2.0;
    sound.analysis.rate = 48000.0;
    sound.analysis.spectrum = {100.0, 150.0, "FS", std::vector<double>(241, 1e-6), 1};
    sound.analysis.spectrogram = {0.5, 6000.0, 4, "FS", std::vector<double>(16, 1e-6)};
    sound.analysis.waveform = {1.0, {{-0.5, 0.25}, {-0.1, 0.1}}};
    sound.profile.features.mean_square = 1.0;
    sound.detail = {0.5, {48000.0, "FS", std::vector<double>(480, 0.1)}};
    sound.contact.histories = {each_state_once};
    return sound;
}

drawing::Scene heard() {
    sound::SoundAnalysis analysis = compared().analysis;
    analysis.name = long_name;
    analysis.unit = "m/s^2";
    analysis.spectrogram.unit = "m/s^2";
    analysis.waveform = {1.0, {{-123456.0, 0.25}, {-0.1, 654321.0}}};
    return sound(analysis, {});
}

// strokes between which next to nothing changes, both ways
drawing::Scene hardly_worn() {
    sweep::StrokeHistory history{
        extreme(), {1'000'000'000, 1.0, 0.0, sweep::Heating{1.0, 1.0}, sweep::Wear{}}, {}, {}, ""};
    history.directions = {parameters::Direction::going, parameters::Direction::coming};
    for (const std::int64_t number : {1, 1'000'000'000}) {
        sweep::Cell cell;
        cell.status = sweep::Status::done;
        cell.category = number == 1 ? classification::Category::none : classification::Category::squeal;
        const double worn = number == 1 ? 0.0 : 1e-9;
        history.strokes.push_back({number, 23.0 + worn, worn, 1.0 - worn, 1e-9, {cell, cell}});
    }
    return strokes(history);
}

// every picture, with names that are too long and numbers that are very large or small
std::vector<NamedScene> hard_pictures() {
    const parameters::Case c = extreme();
    parameters::Contact tight;
    tight.friction = parameters::FrictionKind::directional;
    tight.static_friction = 0.6001;
    tight.kinetic_friction = 0.6;
    tight.static_friction_coming = 0.6002;
    tight.kinetic_friction_coming = 0.5999;
    parameters::Contact resting;
    resting.rest = parameters::RestKind::kato;
    resting.rest_growth = 1e-4;
    return {
        {"contact states", contact_states(std::vector<StatesOfCase>{{long_name, c, {each_state_once}}}, {0.0, 1.0})},
        {"contact states of four",
         contact_states(std::vector<StatesOfCase>(4, {long_name, c, {each_state_once}}), {0, 1})},
        {"motion", motion(1.23456e-9)},
        {"large motion", motion(1.23456e9)},
        {"40 contacts", contacts(40)},
        {"2 contacts", contacts(2)},
        {"friction law", friction_law(c.contact())},
        {"tight friction law", friction_law(tight)},
        {"friction law that hardly grows with rest", friction_law(resting)},
        {"mode shapes", modes()},
        {"modal spectrum", spectrum()},
        {"noise chart", marked(noise_chart(chart(false)), chart(false).study)},
        {"failed noise chart", marked(noise_chart(chart(true)), chart(true).study)},
        {"figure chart", figure_chart(chart(false), "joint_level")},
        {"rate map", rate_map(std::vector{chart(false), chart(true)})},
        {"diagram", over_one_axis()},
        {"sensitivity", records()},
        {"side by side", side_by_side(std::vector(3, compared()))},
        {"sound", heard()},
        {"stability", stability(close_onsets("contact.kinetic_friction", "1", 0.5))},
        {"strokes", hardly_worn()},
        {"stability over a preload", stability(close_onsets("contact.preload", "N", 123456.0))}};
}

// the texts that touch, or leave the sheet; empty: none
std::string overprinted(const drawing::Scene& scene) {
    const drawing::Layout layout = drawing::arrange(scene);
    std::vector<std::string> words;
    for (const drawing::PlacedText& text : layout.texts)
        words.push_back(drawing::plain_text(text.text));
    for (const drawing::PlacedPanel& panel : layout.panels)
        for (const drawing::PlacedNote& note : panel.notes)
            words.push_back(drawing::plain_text(note.text.text));
    const std::vector<drawing::Rectangle> areas = drawing::text_areas(layout);
    std::string found;
    for (std::size_t a = 0; a < areas.size(); ++a) {
        const drawing::Rectangle& one = areas[a];
        if (one.left < 0.0 || one.right > scene.width || one.bottom < 0.0 || one.top > layout.height)
            found += "\"" + words[a] + "\" leaves the sheet\n";
        for (std::size_t b = 0; b < a; ++b)
            if (touch(one, areas[b])) found += "\"" + words[a] + "\" touches \"" + words[b] + "\"\n";
    }
    EXPECT_EQ(found.empty(), drawing::is_legible(layout, scene.width));
    return found;
}

TEST(AllPictures, KeepEveryTextOnTheSheetAndApart) {
    for (const auto& [name, scene] : hard_pictures())
        EXPECT_EQ(overprinted(scene), "") << name;
}

TEST(AllPictures, LeaveTheirPanelsRoomBelowLongWords) {
    for (const auto& [name, scene] : hard_pictures())
        for (const drawing::PlacedPanel& panel : drawing::arrange(scene).panels)
            EXPECT_GT(drawing::height_of(panel.area), 2.0) << name;
}

TEST(AllPictures, FitAColumnOfAJournalOrSayWhatTheyNeed) {
    for (const auto& [name, scene] : hard_pictures()) {
        SCOPED_TRACE(name);
        try {
            const drawing::Scene narrow = on_sheet(scene, {{}, 85.0});
            EXPECT_EQ(narrow.width, 85.0);
            EXPECT_EQ(narrow.font_size, scene.font_size);
            EXPECT_EQ(overprinted(narrow), "");
        } catch (const Error& error) {
            EXPECT_NE(error.problem().what.find("has no room on 85 mm"), std::string::npos) << error.what();
            EXPECT_NE(error.problem().suggestion.find("Give it "), std::string::npos) << error.what();
        }
    }
    const StatesOfCase creak{"creak", {}, {each_state_once}};
    EXPECT_NO_THROW(on_sheet(contact_states(std::span(&creak, 1), {0.0, 1.0}), {"", 85.0}));
    EXPECT_NO_THROW(on_sheet(noise_chart(quiet_sweep()), {"", 85.0}));
    EXPECT_NO_THROW(on_sheet(stability(close_onsets("contact.kinetic_friction", "1", 0.5)), {"", 85.0}));
}

TEST(Sheet, TakesAnotherTitleOrNone) {
    const drawing::Scene scene = noise_chart(quiet_sweep());
    EXPECT_EQ(drawing::plain_text(on_sheet(scene, {"Mine", {}}).title), "Mine");
    const drawing::Scene bare = on_sheet(scene, {"", {}});
    EXPECT_EQ(bare.title, scene.title) << "a reader of the file still calls it so";
    EXPECT_EQ(drawing::arrange(bare).texts.size() + 1, drawing::arrange(scene).texts.size());
}

}  // namespace
}  // namespace stridor::pictures
