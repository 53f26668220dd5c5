#include "stridor/recordings/mat/mat.hpp"

#include "fuzz/targets/reading.hpp"
#include "stridor/recordings/mat/mat_choice.hpp"
#include "stridor/recordings/mat/mat_header.hpp"

#include <algorithm>
#include <cstring>
#include <functional>

namespace stridor::fuzz {

namespace {

/// A process that has been taken over: it answers whatever it likes.
class Impostor final : public recordings::mat::Answers {
public:
    explicit Impostor(std::string_view bytes) : bytes_(bytes) {}
    void send(std::span<const std::byte>) override {}
    bool receive(std::span<std::byte> into) override {
        if (into.size() > bytes_.size()) return false;
        std::copy_n(bytes_.data(), into.size(), reinterpret_cast<char*>(into.data()));
        bytes_.remove_prefix(into.size());
        return true;
    }
    std::string ending() override { return "it ended too early"; }

private:
    std::string_view bytes_;
};

// what deflate can pack into a byte
constexpr std::uint64_t most_per_byte = 1032;
// a process for each file would take all the time, and what it runs is the library, which no counter sees
constexpr std::size_t files_per_process = 256;

// what this process itself reads of a file
void follow_lengths(std::string_view bytes) {
    const recordings::SignalInput input{recordings::bytes_of(std::string(bytes)), "input", {}};
    try {
        recordings::mat::check_length(input, *recordings::mat::version_of(bytes));
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input && !error.problem().what.empty());
    }
}

}  // namespace

void mat(std::string_view bytes) {
    if (recordings::is_mat(bytes) && std::hash<std::string_view>()(bytes) % files_per_process != 0)
        return follow_lengths(bytes);
    if (recordings::is_mat(bytes))
        return read_signal(
            bytes, [](const recordings::SignalInput& input) { return recordings::open_mat(input, {}); }, most_per_byte);
    // the channel that is wished for, up to a zero; then the answers
    const std::size_t end = std::min(bytes.find('\0'), std::size_t{8});
    const std::string channel(bytes.substr(0, end));
    bytes.remove_prefix(std::min(bytes.size(), end + 1));
    read_signal(
        bytes,
        [&](const recordings::SignalInput& input) {
            return recordings::open_mat_answers(std::make_shared<Impostor>(bytes), bytes.size(), {{}, channel},
                                                input.name);
        },
        most_per_byte);
}

}  // namespace stridor::fuzz
