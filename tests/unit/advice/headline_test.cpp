#include "stridor/advice/headline.hpp"

#include "stridor/advice/advice.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/seal_lip.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace stridor::advice {
namespace {

using classification::Category;
using classification::Quiet;
using parameters::Case;
using parameters::Initial;

const sweep::StartVerdict silent{sweep::Status::done, Category::none, Quiet::slides};
const sweep::StartVerdict stuck{sweep::Status::done, Category::none, Quiet::sticks};
const sweep::StartVerdict locked{sweep::Status::done, Category::none, Quiet::locks};
const sweep::StartVerdict heard{sweep::Status::done, Category::squeal};
const sweep::StartVerdict failed{sweep::Status::failed, Category::undecided};

DesignVerdict verdict(std::vector<sweep::StartVerdict> phases, Initial start = Initial::rest) {
    DesignVerdict made{std::move(phases)};
    made.starts.resize(made.phases.size(), start);
    return made;
}

// a lip under a constant drive
const DesignSpace& lip() {
    static const DesignSpace space = design_space(support::seal_lip());
    return space;
}

TEST(Headline, SaysWhatItDoesEachWay) {
    EXPECT_EQ(headline(lip(), verdict({silent, heard}), std::nullopt), "squeals while coming, is quiet while going");
    EXPECT_EQ(headline(lip(), verdict({heard, heard}), std::nullopt), "squeals both ways");
    EXPECT_EQ(headline(lip(), verdict({failed, silent}), std::nullopt),
              "has no result while going, is quiet while coming");
    EXPECT_EQ(headline(lip(), verdict({silent, heard}, Initial::sliding), std::nullopt),
              "squeals (run.initial = sliding) while coming, is quiet while going");
}

TEST(Headline, CallsNothingQuietAroundWhichNobodyLooked) {
    const DesignVerdict quiet = verdict({silent, silent});
    EXPECT_EQ(standing(quiet, std::nullopt), Standing::quiet_here);
    EXPECT_EQ(headline(lip(), quiet, std::nullopt), "quiet here; changes within 5 % were not tried yet");
    EXPECT_EQ(standing(quiet, Neighbourhood{}), Standing::quiet);
    EXPECT_EQ(headline(lip(), quiet, Neighbourhood{}),
              "quiet, and at 9 steps from 0.1 to 5 % more and less of each quantity too");
}

TEST(Headline, NamesTheChangeThatEndsASilence) {
    const Neighbourhood near{{{"contact.preload", 0.0023, 6.014, verdict({silent, heard})},
                              {"plate.mass", -0.031, 0.388, verdict({failed, silent})}}};
    const DesignVerdict quiet = verdict({silent, silent});
    EXPECT_EQ(standing(quiet, near), Standing::barely_quiet);
    EXPECT_EQ(headline(lip(), quiet, near), "quiet, but only just: 0.23 % more preload squeals while coming");
    const std::vector<std::string> words = turn_words(lip(), near);
    EXPECT_EQ(words.at(0), "0.23 % more preload (6.014 N) squeals while coming");
    EXPECT_EQ(words.at(1), "3.1 % less plate mass (0.388 kg) has no result while going");
}

TEST(Headline, TellsAStickingContactFromASlidingOne) {
    EXPECT_EQ(headline(lip(), verdict({silent, stuck}), Neighbourhood{}),
              "quiet (it sticks while coming), and at 9 steps from 0.1 to 5 % more and less of each quantity too");
    EXPECT_EQ(headline(lip(), verdict({stuck, stuck}), Neighbourhood{}),
              "quiet because it sticks, and at 9 steps from 0.1 to 5 % more and less of each quantity too");
}

TEST(Headline, NamesTheWorstPhaseOfASilence) {
    EXPECT_EQ(overall(verdict({silent, locked})), locked);
    EXPECT_EQ(overall(verdict({stuck, silent})), stuck);
    EXPECT_EQ(headline(lip(), verdict({silent, locked}), std::nullopt), "locks while coming, is quiet while going");
    const Neighbourhood near{{{"contact.preload", 0.01, 6.06, verdict({stuck, locked})}}};
    EXPECT_EQ(turn_words(lip(), near).at(0), "1 % more preload (6.06 N) locks while coming");
}

// a margin of a scan is known no closer than the scan went
TEST(ScanWords, SayHowCloselyRangesWereLookedAt) {
    EXPECT_TRUE(scan_words().starts_with("Each range was looked at in 64 steps,")) << scan_words();
}

TEST(QuantityWords, SayWhoseItIsWhereThatMatters) {
    EXPECT_EQ(quantity_words("contact.kinetic_friction"), "kinetic friction");
    EXPECT_EQ(quantity_words("plate.mass"), "plate mass");
    EXPECT_EQ(quantity_words("joint.lip2.contact.preload"), "preload of lip2");
}

// a lip that sticks where it goes squeals where it comes
TEST(Standing, IsThatOfBothDirections) {
    Case c = support::seal_lip();
    for (const double velocity : {0.05, -0.05}) {
        c.drive.velocity = velocity;
        const DesignStanding design = standing_of(c, Look::here);
        ASSERT_EQ(design.space.phases, (std::vector{record::Phase::going, record::Phase::coming}));
        EXPECT_EQ(design.present.phases[1], heard);
        EXPECT_FALSE(is_quiet(design.present));
    }
    AdviceOptions going;
    going.runs.directions = {parameters::Direction::going};
    EXPECT_EQ(standing_of(c, Look::here, going).present.phases.size(), 1U);
}

// from its quiet side to the boundary of friction: what is closer than 5 % is told, at its own value
TEST(Neighbourhood, FindsTheChangeThatEndsASilence) {
    Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.run.duration = c.run.window = 0.4;
    const auto quiet_at = [&](double friction) {
        Case changed = c;
        changed.contact().kinetic_friction = friction;
        return is_quiet(standing_of(changed, Look::here).present);
    };
    double quiet = 0.2, noisy = 0.6;
    ASSERT_TRUE(quiet_at(quiet) && !quiet_at(noisy));
    while (noisy - quiet > 1e-4) {
        const double middle = 0.5 * (quiet + noisy);
        (quiet_at(middle) ? quiet : noisy) = middle;
    }
    c.contact().kinetic_friction = quiet / 1.008;
    ASSERT_TRUE(quiet_at(c.contact().kinetic_friction));
    const DesignStanding design = standing_of(c, Look::around);
    ASSERT_EQ(standing(design.present, design.near), Standing::barely_quiet);
    const auto& turns = design.near->turns;
    const auto found = std::find_if(turns.begin(), turns.end(), [](const NearChange& turn) {
        return turn.key == "contact.kinetic_friction" && turn.relative > 0.0;
    });
    ASSERT_NE(found, turns.end());
    EXPECT_LE(found->relative, 0.0095);
    EXPECT_FALSE(quiet_at(found->value));
    EXPECT_DOUBLE_EQ(found->value, c.contact().kinetic_friction * (1.0 + found->relative));
    EXPECT_TRUE(std::is_sorted(turns.begin(), turns.end(), [](const auto& a, const auto& b) {
        return std::abs(a.relative) < std::abs(b.relative);
    }));
    EXPECT_NE(headline(design).find("but only just: "), std::string::npos);
}

TEST(DefaultTolerances, AreOfPartsAndContradictNothing) {
    const Case c = parameters::paper_case(parameters::PaperCase::squeal);
    for (const Tolerance& each : default_tolerances(c)) {
        EXPECT_FALSE(each.key.starts_with("drive.")) << each.key;
        EXPECT_GT(each.tolerance, 0.0) << each.key;
        if (each.key == "contact.preload") {
            EXPECT_DOUBLE_EQ(each.tolerance, 0.2 * c.contact().preload);
        }
        if (each.key == "contact.kinetic_friction") {
            EXPECT_DOUBLE_EQ(each.tolerance, 0.06);
        }
    }
    Case close = c;
    close.contact().kinetic_friction = 0.78;
    for (const Tolerance& each : default_tolerances(close))
        if (each.key.ends_with("friction")) {
            EXPECT_LE(each.tolerance, 0.01 + 1e-12) << each.key;
        }
}

}  // namespace
}  // namespace stridor::advice
