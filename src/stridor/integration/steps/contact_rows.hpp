#pragma once

#include "stridor/integration/kernels/row_kernel.hpp"
#include "stridor/integration/modal/modal_structure.hpp"

#include <cstddef>
#include <vector>

namespace stridor::integration {

/// The normals and tangents of all contacts over the modes (`ContactRowPlan`), as a step multiplies by them: in blocks
/// of eight modes that hold all rows, so that many rows share one pass.
class ContactRows {
public:
    explicit ContactRows(const ModalStructure& structure, InstructionSet set = widest_instruction_set());

    /// Products of the rows `which` with x, shape [mode]; the others of `products`, shape [row], stay as they are.
    void multiply(const std::vector<std::size_t>& which, const std::vector<double>& x, std::vector<double>& products);

    /// Adds the sum of the rows `which` times their share, shape [row], into `sum`, shape [mode].
    void combine(const std::vector<std::size_t>& which, const std::vector<double>& share, std::vector<double>& sum);

    const ContactRowPlan& plan() const { return plan_; }

    /// Returns how many numbers x and sums must hold: the modes, filled up to whole blocks.
    std::size_t padded_modes() const { return blocks_ * row_lanes; }

private:
    RowBlocks blocks_of(const std::vector<std::size_t>& which) const {
        return {numbers_.data(), rows_, blocks_, which};
    }

    const RowKernel* kernel_;
    ContactRowPlan plan_;
    std::size_t rows_;
    std::size_t blocks_;
    std::vector<double> numbers_;  // [1/√kg] shape [block][row][lane]
    std::vector<double> partial_;  // shape [row][lane]
};

}  // namespace stridor::integration
