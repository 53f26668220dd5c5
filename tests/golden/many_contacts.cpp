#include "golden/many_contacts.hpp"

#include "golden/motion_values.hpp"
#include "golden/values.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/reduction/craig_bampton.hpp"
#include "support/massless_feet.hpp"
#include "support/random_structures.hpp"
#include "support/structures/lattice_part.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace stridor::golden {

namespace {

using parameters::Case;
using parameters::Engine;
using parameters::Formulation;

Case lasting(Case c, double duration) {
    c.run.duration = duration;
    c.run.window = 0.5 * duration;
    return c;
}

Case by_steps(Case c, double step, Formulation formulation = Formulation::standard) {
    c.run.engine = Engine::moreau;
    c.run.formulation = formulation;
    c.run.step = step;
    return c;
}

Case ready(const std::string& name, double duration) {
    return lasting(io::read_case(io::TomlSource{io::ready_file(name), name, {}}), duration);
}

// a structure of springs whose contacts lift and meet again; no number of it comes from the mathematical library
Case lifting(std::uint64_t number) {
    Case c = support::random_structure(number);
    auto own = std::make_shared<parameters::OwnStructure>(*c.own_structure);
    own->following.ratio = 0.002;
    c.own_structure = std::move(own);
    c.contact().preload = 5.0;
    c.drive.velocity = 0.1;
    c.run.initial = parameters::Initial::rest;
    return lasting(c, 0.1);
}

// a block of 12 nodes, its top held, reduced to the four nodes of its foot, which all rub
Case reduced_block() {
    reduction::ElasticPart part = support::lattice_part({2, 2, 3}, support::LatticeSupport::top_held);
    part.mass *= 300.0;
    reduction::ReductionRequest request{.modes = 4};
    const auto boundary = static_cast<Eigen::Index>(3 * part.sets.front().nodes.size());
    for (Eigen::Index row = 0; row < boundary; ++row)
        request.boundary.push_back(row);
    const reduction::ElasticPart reduced = reduction::craig_bampton(part, request).part;
    parameters::OwnStructure own;
    own.mass = support::numbers_of(reduced.mass);
    own.stiffness = support::numbers_of(reduced.stiffness);
    own.following.ratio = 0.01;
    for (const reduction::RowLabel& label : reduced.labels)
        own.row.push_back(reduction::describe(label));
    for (Eigen::Index row = 0; row < boundary; row += 3) {
        const auto at = static_cast<std::size_t>(row);
        own.contacts.push_back(support::contact_at(part.labels[at].node, own.row.size(), at + 2, at, 0.25));
    }
    Case c;
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(own));
    c.contact().preload = 20.0;
    c.contact().static_friction = 0.9;
    c.contact().kinetic_friction = 0.4;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    return lasting(c, 0.05);
}

// two nodes that slip in a plane, shaken by a force
Case squeak_rig() {
    return io::read_case(STRIDOR_SOURCE_DIR "/cases/published/squeak-rig.toml");
}

Case two_joints() {
    Case c = parameters::two_lips();
    c.joints[1].joint.incidence_angle = 110.0;
    return lasting(c, 0.2);
}

Result run(std::string name, const Case& c, bool is_watched = true) {
    record::Request request;
    if (is_watched) request = {record::KeepHistory::yes, {0.0, c.run.duration, c.run.duration / 100.0}};
    const integration::Motion motion = integration::simulate(c, request);
    Values values;
    add(values, motion);
    for (const record::ContactHistory& history : motion.record.histories)
        add(values, history);
    add_motion(values, motion.record.trace);
    for (const record::ContactTrace& contact : motion.record.trace.contacts)
        add(values, contact);
    std::string extract(integration::reason_names[static_cast<std::size_t>(motion.outcome.reason)]);
    for (const record::Tally& tally : motion.record.phases) {
        for (const record::ContactTally& contact : tally.contacts) {
            add(values, contact);
            add_ending(values, contact);
            values.add("normal_impulse", contact.load.normal_impulse);
            values.add("friction_loss", contact.load.friction_loss);
            values.add("largest_force", contact.load.largest_force);
            if (contact.coarser) values.add("coarser_time", contact.coarser->time);
        }
        add_vibration(values, tally);
    }
    for (const classification::Verdict& verdict : classification::classify_phases(motion.record.phases, c.verdict)) {
        add(values, verdict);
        const analysis::Rates& rates = verdict.evidence.rates;
        extract += fmt::format("; {} slip {:.6f} stick {:.6f}", classification::name(verdict.category), rates.slip,
                               rates.stick);
    }
    return {std::move(name), values.text(), std::move(extract)};
}

}  // namespace

std::vector<Result> results_of_many_contacts() {
    const Case squeak = lasting(parameters::paper_case(parameters::PaperCase::squeak), 0.4);
    return {
        run("taylor.chain", ready("chain", 200.0)),
        run("taylor.chain.early", ready("chain", 200.0), false),
        run("taylor.string", ready("string", 0.1)),
        run("taylor.lifting", lifting(3)),
        run("taylor.reduced", reduced_block()),
        run("moreau.squeak", by_steps(squeak, 2e-6)),
        run("moreau.joints", by_steps(two_joints(), 2e-6)),
        run("moreau.lifting", by_steps(lifting(3), 2e-6)),
        run("moreau.reduced", by_steps(reduced_block(), 2e-6)),
        run("massless.rig", squeak_rig()),
        run("massless.feet", by_steps(support::on_massless_feet(lifting(3)), 2e-6, Formulation::massless)),
    };
}

}  // namespace stridor::golden
