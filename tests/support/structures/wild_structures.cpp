#include "support/structures/wild_structures.hpp"

#include "stridor/integration/modal/modal_structure.hpp"
#include "support/counter_random.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::support {

namespace {

using parameters::DriveKind;

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, CounterRandom& random) {
    Eigen::MatrixXd matrix(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
        for (Eigen::Index j = 0; j < columns; ++j)
            matrix(i, j) = random.between(-1.0, 1.0);
    return matrix;
}

Eigen::MatrixXd random_mass(Eigen::Index n, CounterRandom& random) {
    const double least = random.decades(1e-3, 1.0);
    const double spread = random.one_in(2) ? 1.0 : random.decades(1.0, 1e3);
    Eigen::VectorXd root(n);
    for (Eigen::Index j = 0; j < n; ++j)
        root(j) = std::sqrt(random.decades(least, least * spread));
    Eigen::MatrixXd shape = Eigen::MatrixXd::Identity(n, n);
    // what couples contacts by their inertia
    if (random.one_in(3)) {
        const Eigen::MatrixXd mix = random_matrix(n, n, random);
        shape += random.decades(1e-3, 1.0) / static_cast<double>(n) * mix * mix.transpose();
    }
    return root.asDiagonal() * shape * root.asDiagonal();
}

// springs between random directions: as many as there are motions, more or fewer
Eigen::MatrixXd random_springs(Eigen::Index n, double stiffest, CounterRandom& random) {
    const auto size = static_cast<std::size_t>(n);
    const std::size_t count = random.one_in(4) ? 1 + random.below(size) : size + random.below(size);
    const double softest = stiffest * (random.one_in(2) ? 1e-2 : random.decades(1e-6, 1.0));
    const bool is_chain = random.one_in(2);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t k = 0; k < count; ++k) {
        Eigen::VectorXd ends = Eigen::VectorXd::Zero(n);
        if (is_chain) {
            ends(static_cast<Eigen::Index>(random.below(size))) += 1.0;
            const auto other = static_cast<Eigen::Index>(random.below(size));
            if (!random.one_in(3) && ends(other) == 0.0) ends(other) -= 1.0;
        } else {
            ends = random_matrix(n, 1, random) / std::sqrt(static_cast<double>(n));
        }
        matrix += random.decades(softest, stiffest) * ends * ends.transpose();
    }
    return matrix;
}

void choose_contacts(model::Structure& structure, CounterRandom& random) {
    const Eigen::Index n = model::dofs_of(structure);
    const std::size_t kind = random.below(3);
    const double force = random.decades(1e-2, 1e4);
    const double friction = random.between(0.0, 1.5);
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        model::ContactPoint& contact = structure.contacts[k];
        const auto at = static_cast<Eigen::Index>(2 * k);
        switch (kind) {
            case 0:  // nodes on a surface
                contact.normal = Eigen::VectorXd::Unit(n, at);
                contact.tangent = Eigen::VectorXd::Unit(n, at + 1);
                break;
            case 1: {  // nodes on a part of the structure, turned
                const double angle = random.between(-1.0, 1.0);
                contact.normal =
                    std::cos(angle) * Eigen::VectorXd::Unit(n, at) + std::sin(angle) * Eigen::VectorXd::Unit(n, at + 1);
                contact.tangent =
                    std::cos(angle) * Eigen::VectorXd::Unit(n, at + 1) - std::sin(angle) * Eigen::VectorXd::Unit(n, at);
                if (n > 2 * static_cast<Eigen::Index>(structure.contacts.size())) contact.normal(n - 1) -= 1.0;
                break;
            }
            default:  // whatever
                contact.normal = random_matrix(n, 1, random);
                contact.tangent = random_matrix(n, 1, random);
        }
        if (random.one_in(4)) contact.initial_gap = random.decades(1e-9, 1e-4);
        const double limit = random.one_in(8) ? 0.0 : random.one_in(2) ? friction : random.between(0.0, 2.0);
        contact.friction = model::Coulomb{limit, random.one_in(4) ? limit : limit * random.between(0.0, 1.0)};
        if (random.one_in(5)) contact.drive_share = random.one_in(3) ? 0.0 : random.between(-1.0, 2.0);
        const double own = random.one_in(2) ? force : force * random.decades(1e-3, 1.0);
        structure.load -= own * contact.normal;
    }
    if (random.one_in(3)) structure.load += 0.3 * force * random_matrix(n, 1, random);
}

void choose_drive(WildStructure& wild, CounterRandom& random) {
    parameters::Drive& drive = wild.drive;
    const double speed = random.decades(1e-5, 1e1) * (random.one_in(2) ? 1.0 : -1.0);
    drive.kind = std::array{DriveKind::constant, DriveKind::constant, DriveKind::sinusoidal, DriveKind::sampled,
                            DriveKind::trapezoidal}[random.below(5)];
    drive.velocity = speed;
    drive.frequency = random.decades(1.6, 30.0) / wild.duration;
    drive.amplitude = std::abs(speed) / (6.28 * drive.frequency);
    drive.ramp = random.between(0.05, 0.4) / drive.frequency;
    if (drive.kind == DriveKind::trapezoidal) drive.velocity = std::abs(speed);
    if (drive.kind != DriveKind::sampled) return;
    const std::size_t count = 2 + random.below(12);
    for (std::size_t k = 0; k < count; ++k) {
        const bool repeats = k > 0 && random.one_in(4);
        const double velocity = repeats            ? drive.velocities.back()
                                : random.one_in(5) ? 0.0
                                                   : speed * random.between(-1.0, 1.0);
        drive.times.push_back(k == 0 ? 0.0 : drive.times.back() + random.decades(1e-3, 1.0));
        drive.velocities.push_back(velocity);
    }
    const double stretch = wild.duration / drive.times.back();
    for (double& time : drive.times)
        time *= stretch;
    drive.times.back() = std::max(drive.times.back(), wild.duration);
}

}  // namespace

WildStructure wild_structure(std::uint64_t number) {
    CounterRandom random(number);
    const std::size_t contacts = 1 + random.below(8);
    const std::size_t least = std::max<std::size_t>(2, 2 * contacts);
    const std::size_t most = random.one_in(3) ? 60 : std::min<std::size_t>(60, least + 4);
    const auto n = static_cast<Eigen::Index>(least + random.below(most - least + 1));
    WildStructure wild;
    wild.structure = model::structure_of_size(static_cast<int>(n), static_cast<int>(contacts));
    model::Structure& structure = wild.structure;
    structure.mass = random_mass(n, random);
    const double stiffest = random.decades(1e2, 1e8);
    structure.stiffness = random_springs(n, stiffest, random);
    const double time = std::sqrt(structure.mass.maxCoeff() / structure.stiffness.maxCoeff());
    switch (random.below(4)) {
        case 0:
            break;
        case 1:
            structure.damping = random.decades(1e-5, 1e-1) * time * structure.stiffness;
            break;
        case 2:
            structure.damping = random.decades(1e-5, 1e-1) / time * structure.mass;
            break;
        default:
            structure.damping = random_springs(n, random.decades(1e-5, 1.0) * time * stiffest, random);
    }
    choose_contacts(structure, random);
    wild.initial = random.one_in(2) ? parameters::Initial::rest : parameters::Initial::stuck;
    wild.duration = random.decades(20.0, 600.0) * 2.0 / integration::modal_structure(structure).fastest;
    choose_drive(wild, random);
    return wild;
}

}  // namespace stridor::support
