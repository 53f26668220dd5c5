#include "stridor/io/mat.hpp"

#include "fuzz/targets/reading.hpp"
#include "stridor/io/mat_choice.hpp"

#include <algorithm>
#include <cstring>

namespace stridor::fuzz {

namespace {

/// A process that has been taken over: it answers whatever it likes.
class Impostor final : public io::mat::Answers {
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

}  // namespace

void mat(std::string_view bytes) {
    if (io::is_mat(bytes))
        return read_signal(
            bytes, [](const io::SignalInput& input) { return io::open_mat(input, {}); }, most_per_byte);
    // the channel that is wished for, up to a zero; then the answers
    const std::size_t end = std::min(bytes.find('\0'), std::size_t{8});
    const std::string channel(bytes.substr(0, end));
    bytes.remove_prefix(std::min(bytes.size(), end + 1));
    read_signal(
        bytes,
        [&](const io::SignalInput& input) {
            return io::open_mat_answers(std::make_shared<Impostor>(bytes), bytes.size(), {{}, channel}, input.name);
        },
        most_per_byte);
}

}  // namespace stridor::fuzz
