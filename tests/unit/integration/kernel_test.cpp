#include "stridor/integration/exact/flow.hpp"
#include "stridor/integration/kernels/exact_kernel.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <memory>
#include <vector>

namespace stridor::integration {
namespace {

const Flows& table_1_flows() {
    static const auto flows = [] {
        const auto structure = model::rubbing_system(parameters::paper_case(parameters::PaperCase::squeal));
        return std::make_unique<Flows>(
            prepare_flows(contact_coordinates(model::SizedStructure<3>(structure, structure.contacts[0])),
                          structure.contacts[0].friction, 5.0, kernel(InstructionSet::baseline, 3)));
    }();
    return *flows;
}

Lanes any_state() {
    Lanes s{{1e-4, 1e-4, 0.1, 0.1, 20.0, 0.1, 0.1, 0.0}};
    for (double& number : s.at)
        number *= *support::signed_fraction();
    return s;
}

// between -0.0 and 0.0 nothing is told apart, all else by its bits
bool same(const double* a, const double* b, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
        if (a[k] != b[k]) return false;
    return true;
}

bool same(const Sums& a, const Sums& b) {
    return same(a.product[0].at, b.product[0].at, lanes * std::size(a.product)) &&
           same(a.on_slip.at, b.on_slip.at, lanes) && same(a.on_surface.at, b.on_surface.at, lanes) &&
           same(a.peak[0].at, b.peak[0].at, lanes * std::size(a.peak));
}

TEST(InstructionSets, BaselineIsEverywhere) {
    EXPECT_TRUE(is_available(InstructionSet::baseline));
    EXPECT_TRUE(is_available(widest_instruction_set()));
}

RC_GTEST_PROP(InstructionSets, MoveGlideAndAddUpBitForBitAlike, ()) {
    const Flow& flow = table_1_flows().flow[*support::whole_between(0, 3)];
    const Lanes s = any_state();
    const double tau = 0.5 + 0.5 * *support::signed_fraction();
    const Kernel& reference = kernel(InstructionSet::baseline, 3);
    Lanes moved;
    reference.move(flow, s, tau, moved);
    Lanes glided = s, leapt = s;
    Sums sums{}, part{};
    const long taken = reference.glide(flow, glided, 20, sums);
    reference.leap(flow, leapt, sums);
    reference.add_part(flow, s, 0.1, tau, part);
    for (const InstructionSet set : available_instruction_sets()) {
        const Kernel& k = kernel(set, 3);
        Lanes here;
        k.move(flow, s, tau, here);
        RC_ASSERT(same(here.at, moved.at, lanes));
        Lanes glided_here = s, leapt_here = s;
        Sums sums_here{}, part_here{};
        RC_ASSERT(k.glide(flow, glided_here, 20, sums_here) == taken);
        k.leap(flow, leapt_here, sums_here);
        k.add_part(flow, s, 0.1, tau, part_here);
        RC_ASSERT(same(glided_here.at, glided.at, lanes));
        RC_ASSERT(same(leapt_here.at, leapt.at, lanes));
        RC_ASSERT(same(sums_here, sums));
        RC_ASSERT(same(part_here, part));
    }
}

// a glide is so many leaps, and it ends where an event may lie ahead
RC_GTEST_PROP(Kernel, GlidesAsItLeaps, ()) {
    const Flow& flow = table_1_flows().flow[*support::whole_between(0, 3)];
    const Kernel& k = kernel(widest_instruction_set(), 3);
    const Lanes s = any_state();
    Lanes glided = s, leapt = s;
    Sums one{}, other{};
    const long taken = k.glide(flow, glided, 30, one);
    for (long step = 0; step < taken; ++step)
        k.leap(flow, leapt, other);
    RC_ASSERT(same(glided.at, leapt.at, lanes));
    RC_ASSERT(same(one, other));
}

RC_GTEST_PROP(Kernel, LeapsAWholeStepAsItMoves, ()) {
    const Flow& flow = table_1_flows().flow[*support::whole_between(0, 3)];
    const Kernel& k = kernel(widest_instruction_set(), 3);
    const Lanes s = any_state();
    Lanes moved, leapt = s;
    Sums sums{};
    k.move(flow, s, 1.0, moved);
    k.leap(flow, leapt, sums);
    const double unit[lanes]{1e-4, 1e-4, 1.0, 1.0, 20.0, 0.1, 0.1, 0.1};  // sizes of displacements, velocities, ...
    for (int i = 0; i < lanes; ++i)
        RC_ASSERT(std::abs(moved.at[i] - leapt.at[i]) <= 1e-14 * unit[i]);
}

}  // namespace
}  // namespace stridor::integration
