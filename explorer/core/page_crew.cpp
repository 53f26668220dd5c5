#include "page_crew.hpp"

#include "stridor/base/hash.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/crew/crew.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <iterator>
#include <map>
#include <utility>

namespace stridor::crew {

namespace {

enum class Role { alone, owner, helper };

/// What a module knows of the work that it shares.
struct SharedWork {
    Role role = Role::alone;
    std::string hash{};                                                    // of the work that lacks results
    std::vector<Task> tasks{};                                             // lacking, or to be computed
    std::map<std::pair<std::string, std::uint64_t>, std::string> known{};  // by hash and number
    base::Packing results{};                                               // of a helper
};

SharedWork& shared_work() {
    static SharedWork only;
    return only;
}

std::string packed(const std::string& hash, const std::vector<Task>& tasks) {
    base::Packing packing;
    packing.add(hash);
    for (const Task& task : tasks) {
        packing.add(std::uint64_t{task.number});
        packing.add(task.bytes);
    }
    return packing.take();
}

/// Computes in its owner's thread, or lets others compute.
class PageCrew final : public Crew {
public:
    PageCrew(const Work& work, std::stop_token stop)
        : stop_(std::move(stop)),
          worker_(work.worker()),
          hash_(base::hash_text(work.text)) {
        if (shared_work().role == Role::helper && shared_work().hash == hash_) help();
    }

    std::size_t appetite(std::size_t left) override {
        constexpr std::size_t mouthful = 8;  // [1] tasks: the rest can still be given in a better order
        if (has_stopped()) return 0;
        if (shared_work().role == Role::owner) return left;
        return queue_.empty() ? std::min(left, mouthful) : 0;
    }

    void give(std::vector<Task> tasks) override {
        queue_.insert(queue_.end(), std::make_move_iterator(tasks.begin()), std::make_move_iterator(tasks.end()));
    }

    std::vector<Result> take(std::size_t enough, Clock::time_point deadline) override {
        if (shared_work().role == Role::owner) return take_known();
        std::vector<Result> results;
        while (results.size() < enough && !queue_.empty() && !has_stopped()) {
            const Task task = std::move(queue_.front());
            queue_.pop_front();
            const Clock::time_point begin = Clock::now();
            if (std::optional<std::string> bytes = worker_(task, stop_))
                results.push_back({task.number, std::move(*bytes)});
            const Clock::time_point end = Clock::now();
            seconds_ += std::chrono::duration<double>(end - begin).count();
            ++finished_;
            if (end >= deadline) break;
        }
        return results;
    }

    bool is_idle() override { return queue_.empty() || has_stopped(); }
    bool has_stopped() override { return stop_.stop_requested(); }
    void rethrow() override {}  // an error of a task leaves `take`
    double seconds_per_task() override { return finished_ == 0 ? 0.0 : seconds_ / static_cast<double>(finished_); }

private:
    std::vector<Result> take_known() {
        SharedWork& shared = shared_work();
        std::vector<Result> results;
        std::vector<Task> lacking;
        for (Task& task : std::exchange(queue_, {})) {
            const auto found = shared.known.find({hash_, task.number});
            if (found != shared.known.end())
                results.push_back({task.number, found->second});
            else
                lacking.push_back(std::move(task));
        }
        if (lacking.empty()) return results;
        shared.hash = hash_;
        shared.tasks = std::move(lacking);
        throw Lacking();
    }

    void help() {
        SharedWork& shared = shared_work();
        for (const Task& task : shared.tasks)
            if (const std::optional<std::string> bytes = worker_(task, stop_)) {
                shared.results.add(hash_);
                shared.results.add(std::uint64_t{task.number});
                shared.results.add(*bytes);
            }
        throw Lacking();
    }

    std::stop_token stop_;
    Worker worker_;
    std::string hash_;  // of the work
    std::deque<Task> queue_;
    std::size_t finished_ = 0;
    double seconds_ = 0.0;
};

}  // namespace

void compute_alone() {
    shared_work() = {};
}

void take_results(const std::string& bytes) {
    shared_work() = {Role::owner};
    base::Unpacking unpacking(bytes);
    while (!unpacking.is_complete()) {
        std::string hash = unpacking.words();
        const std::uint64_t number = unpacking.count();
        std::string result = unpacking.words();
        if (!unpacking.is_good()) throw damaged_result();
        shared_work().known.insert_or_assign({std::move(hash), number}, std::move(result));
    }
}

std::vector<std::string> lacking_tasks(std::size_t helpers) {
    const SharedWork& shared = shared_work();
    // neighbours take equally long: each helper gets some of everywhere
    std::vector<std::vector<Task>> dealt(
        std::clamp<std::size_t>(shared.tasks.size(), 1, std::max<std::size_t>(helpers, 1)));
    for (std::size_t k = 0; k < shared.tasks.size(); ++k)
        dealt[k % dealt.size()].push_back(shared.tasks[k]);
    std::vector<std::string> all;
    for (const std::vector<Task>& tasks : dealt)
        all.push_back(packed(shared.hash, tasks));
    return all;
}

void help_with(const std::string& tasks) {
    shared_work() = {Role::helper};
    base::Unpacking unpacking(tasks);
    shared_work().hash = unpacking.words();
    while (!unpacking.is_complete()) {
        Task task;
        task.number = unpacking.count();
        task.bytes = unpacking.words();
        if (!unpacking.is_good()) throw damaged_result();
        shared_work().tasks.push_back(std::move(task));
    }
}

std::string helpers_results() {
    return shared_work().results.take();
}

CrewMaker thread_crews(int) {
    return [](const Work& work, const std::stop_token& stop) { return std::make_unique<PageCrew>(work, stop); };
}

}  // namespace stridor::crew
