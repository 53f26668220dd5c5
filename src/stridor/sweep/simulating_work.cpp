#include "stridor/sweep/simulating_work.hpp"

#include <memory>
#include <utility>

namespace stridor::sweep {

crew::Work simulating_work(std::string text, Simulating compute) {
    return {std::move(text), [compute = std::move(compute)] {
                return [compute, workspace = std::make_shared<integration::Workspace>()](const crew::Task& task,
                                                                                         const std::stop_token& stop) {
                    return compute(task, stop, *workspace);
                };
            }};
}

}  // namespace stridor::sweep
