#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace stridor::base {

/// Allocates at the beginning of a cache line: a register of any width is then loaded out of one line, not of two.
template <typename Value>
struct LineAllocator {
    using value_type = Value;
    static constexpr std::align_val_t line{64};

    LineAllocator() = default;
    template <typename Other>
    LineAllocator(const LineAllocator<Other>& /*other*/) {}

    Value* allocate(std::size_t count) { return static_cast<Value*>(::operator new(count * sizeof(Value), line)); }
    void deallocate(Value* values, std::size_t /*count*/) { ::operator delete(values, line); }
    bool operator==(const LineAllocator& /*other*/) const { return true; }
};

/// Values that begin at a cache line.
template <typename Value>
using AlignedVector = std::vector<Value, LineAllocator<Value>>;

}  // namespace stridor::base
