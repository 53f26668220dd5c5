#include "stridor/model/built/chain_on_belt.hpp"

namespace stridor::model {

Structure chain_on_belt(const std::vector<ChainBlock>& blocks, double coupling_stiffness) {
    const auto count = static_cast<int>(blocks.size());
    Structure structure = structure_of_size(2 * count, count);
    for (int k = 0; k < count; ++k) {
        const ChainBlock& block = blocks[static_cast<std::size_t>(k)];
        ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        const int along = 2 * k;
        const int across = along + 1;
        structure.mass(along, along) = structure.mass(across, across) = block.mass;
        structure.stiffness(along, along) += block.stiffness;
        structure.stiffness(across, across) = block.stiffness;
        structure.damping(along, along) = structure.damping(across, across) = block.damping;
        structure.load(across) = -block.preload;
        contact.tangent(along) = 1.0;
        contact.normal(across) = 1.0;
        contact.friction = block.friction;
        if (k == 0) continue;
        const int before = along - 2;
        structure.stiffness(before, before) += coupling_stiffness;
        structure.stiffness(along, along) += coupling_stiffness;
        structure.stiffness(before, along) = structure.stiffness(along, before) = -coupling_stiffness;
    }
    return structure;
}

}  // namespace stridor::model
