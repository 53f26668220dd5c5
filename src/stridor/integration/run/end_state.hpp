#pragma once

#include "stridor/base/error.hpp"
#include "stridor/integration/kernels/lanes.hpp"
#include "stridor/integration/rules/contact_mode.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace stridor::integration {

/// All numbers that an engine needs to go on with a run bit for bit, in an order of its own.
using EngineMemory = std::vector<double>;

/// Where a run stands at its end.
struct EndState {
    double time = 0.0;                            // [s] since the first start
    std::vector<double> displacement{};           // [m] from the preloaded rest, shape [dof]
    std::vector<double> velocity{};               // [m/s] shape [dof]
    std::vector<model::ContactState> contacts{};  // shape [contact]
    std::vector<double> rested{};  // [s] for which each has stuck, shape [contact]; empty: rest changes nothing
    std::vector<double> friction_states{};  // [1] shape [contact]; empty: no law has one
    // of an engine with steps one for each step that it compares, and for each formulation
    std::vector<EngineMemory> memory{};
};

/// Returns the case with that state as its given start, at that phase of the drive: another run that begins there. Its
/// own quantities may be others than those of the run before. Contacts that are closed are closed to the last bit.
parameters::Case begun_at(parameters::Case c, const EndState& state);

/// From which runs an engine takes over, and what it hands over, run by run in the order in which it makes them.
struct Handover {
    const EndState* from = nullptr;  // null: it begins
    EndState to{};
    std::size_t taken = 0;  // memories of `from`
};

/// Passes numbers of an engine into its memory, or out of it into another engine: one list serves both ways.
class Memory {
public:
    enum class Way { keep, restore };

    Memory(EngineMemory& numbers, Way way) : numbers_(&numbers), way_(way) {}

    bool restores() const { return way_ == Way::restore; }
    /// Says whether all was there that was asked for, and nothing else.
    bool is_complete() const { return is_good_ && (!restores() || at_ == numbers_->size()); }

    void operator()(double& number) {
        if (!restores()) return numbers_->push_back(number);
        is_good_ = is_good_ && at_ < numbers_->size();
        if (is_good_) number = (*numbers_)[at_++];
    }
    template <typename Number>
    requires(std::is_integral_v<Number>) void operator()(Number& number) {
        auto as_double = static_cast<double>(number);
        (*this)(as_double);
        if (!restores()) return;
        // a file may say anything
        is_good_ = is_good_ && std::abs(as_double) <= 0x1p53;
        if (is_good_) number = static_cast<Number>(static_cast<long>(as_double));
    }
    /// Passes an enumeration or a place in a list, which have so many values.
    template <typename Choice>
    void below(Choice& choice, std::size_t count) {
        auto number = static_cast<double>(choice);
        (*this)(number);
        if (!restores()) return;
        is_good_ = is_good_ && number >= 0.0 && number < static_cast<double>(count);
        if (is_good_) choice = static_cast<Choice>(static_cast<std::size_t>(number));
    }
    void operator()(Lanes& each) {
        for (double& number : each.at)
            (*this)(number);
    }
    /// Passes the items of a list that has its size.
    template <typename Each>
    void operator()(std::vector<Each>& list) {
        for (Each& each : list)
            (*this)(each);
    }
    void operator()(std::vector<bool>& facts) {
        for (std::size_t k = 0; k < facts.size(); ++k) {
            char fact = facts[k] ? 1 : 0;
            (*this)(fact);
            facts[k] = fact != 0;
        }
    }
    template <typename Each, std::size_t size>
    void operator()(std::array<Each, size>& list) {
        for (Each& each : list)
            (*this)(each);
    }
    void operator()(std::vector<ContactMode>& set) {
        for (ContactMode& mode : set)
            below(mode, contact_modes);
    }
    void operator()(record::ContactInterval& interval) {
        below(interval.state, model::contact_states);
        (*this)(interval.from), (*this)(interval.to), (*this)(interval.slip_velocity), (*this)(interval.gap_velocity);
    }
    void operator()(EnergyBalance& balance) {
        for (double* term :
             {&balance.stored, &balance.preload_work, &balance.drive_work, &balance.dashpot_loss,
              &balance.friction_loss, &balance.impact_loss, &balance.residual, &balance.held, &balance.carried})
            (*this)(*term);
    }
    template <typename Derived>
    void operator()(Eigen::PlainObjectBase<Derived>& numbers) {
        for (Eigen::Index k = 0; k < numbers.size(); ++k)
            (*this)(numbers.data()[k]);
    }

private:
    EngineMemory* numbers_;
    Way way_;
    std::size_t at_ = 0;
    bool is_good_ = true;
};

/// Returns the numbers of a vector as a list.
template <typename Vector>
std::vector<double> list_of(const Vector& vector) {
    return {vector.data(), vector.data() + vector.size()};
}

/// Passes what `pass` names of a run that goes on into its place; throws `Error` (input) for a memory of another one.
template <typename Pass>
void restore(Handover* handover, Pass pass) {
    if (handover == nullptr || handover->from == nullptr) return;
    const std::vector<EngineMemory>& memories = handover->from->memory;
    EngineMemory numbers = handover->taken < memories.size() ? memories[handover->taken] : EngineMemory();
    ++handover->taken;
    Memory memory(numbers, Memory::Way::restore);
    pass(memory);
    if (!memory.is_complete())
        base::refuse("the end state is none of this case and engine", "its numbers do not fit",
                     "Make it anew with --end-state.");
}

/// Keeps what `pass` names of a run that others go on with.
template <typename Pass>
void keep(Handover* handover, Pass pass) {
    if (handover == nullptr) return;
    EngineMemory numbers;
    Memory memory(numbers, Memory::Way::keep);
    pass(memory);
    handover->to.memory.push_back(std::move(numbers));
}

}  // namespace stridor::integration
