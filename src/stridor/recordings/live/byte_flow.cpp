#include "stridor/recordings/live/byte_flow.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/process.hpp"
#include "stridor/recordings/live/recorder_words.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <thread>
#include <utility>

namespace stridor::recordings {

namespace {

[[noreturn]] void fail_to_read(const std::string& name, int reason) {
    throw Error(ErrorKind::io, {"cannot read " + name, std::strerror(reason), ""});
}

/// How reading from a descriptor went: a number of bytes, 0 at its end, `std::nullopt` if none are there.
std::optional<std::size_t> read_some(int descriptor, std::span<char> into, const std::string& name) {
    for (;;) {
        const ssize_t count = ::read(descriptor, into.data(), into.size());
        if (count >= 0) return static_cast<std::size_t>(count);
        if (errno == EAGAIN || errno == EWOULDBLOCK) return std::nullopt;
        if (errno != EINTR) fail_to_read(name, errno);
    }
}

Arrival bytes_arrived(std::size_t count) {
    return {Arrival::Kind::bytes, count, {}, {}};
}

Arrival over(std::string words) {
    return {Arrival::Kind::end, 0, {}, std::move(words)};
}

// a pipe holds a second of many channels, so that work on a noise does not stop who fills it
void widen(int pipe) {
    constexpr int wide = 1 << 20;  // [bytes] what Linux grants everybody
    static_cast<void>(::fcntl(pipe, F_SETPIPE_SZ, wide));
}

class DescriptorFlow final : public ByteFlow {
public:
    explicit DescriptorFlow(int descriptor) : descriptor_(descriptor) { widen(descriptor); }

    Arrival next(std::span<char> into, std::chrono::milliseconds longest) override {
        pollfd waiting{descriptor_, POLLIN, 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(longest.count()));
        if (ready == 0 || (ready < 0 && errno == EINTR)) return {};
        const std::optional<std::size_t> count = read_some(descriptor_, into, "standard input");
        if (!count) return {};
        return *count > 0 ? bytes_arrived(*count) : over("the input ended");
    }

private:
    int descriptor_;
};

class GrowingFile final : public ByteFlow {
public:
    explicit GrowingFile(const std::string& path)
        : path_(path),
          descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (descriptor_ < 0) fail_to_read("\"" + path + "\"", errno);
        struct stat status {};
        if (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) return;
        ::close(descriptor_);
        throw Error(ErrorKind::input,
                    {"\"" + path + "\" is not a file that grows", "it is a folder, a pipe or a device",
                     "A pipe goes to standard input: stridor listen-in < PIPE"});
    }
    ~GrowingFile() override { ::close(descriptor_); }
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    Arrival next(std::span<char> into, std::chrono::milliseconds longest) override {
        constexpr std::chrono::milliseconds pause{20};
        for (std::chrono::milliseconds waited{0};; waited += pause) {
            if (const std::size_t count = read_some(descriptor_, into, "\"" + path_ + "\"").value_or(0)) {
                read_ += count;
                return bytes_arrived(count);
            }
            if (std::string why = why_over(); !why.empty()) return over(std::move(why));
            if (waited >= longest) return {};
            std::this_thread::sleep_for(std::min(pause, longest));
        }
    }

private:
    std::string why_over() const {
        struct stat mine {};
        struct stat named {};
        if (::fstat(descriptor_, &mine) != 0) return "the file cannot be asked for its length";
        if (static_cast<std::uint64_t>(mine.st_size) < read_)
            return "the file was cut: it is shorter than what was read";
        if (::stat(path_.c_str(), &named) != 0) return "the file was removed";
        const bool is_same = mine.st_ino == named.st_ino && mine.st_dev == named.st_dev;
        return is_same ? "" : "another file took its name";
    }

    std::string path_;
    int descriptor_;
    std::uint64_t read_ = 0;  // [bytes]
};

class ProgramFlow final : public ByteFlow {
public:
    explicit ProgramFlow(const std::vector<std::string>& command) : name_(command.front()), program_(command) {
        widen(program_.output());
    }

    Arrival next(std::span<char> into, std::chrono::milliseconds longest) override {
        if (loss_ && before_loss_ == 0) return *std::exchange(loss_, std::nullopt);
        std::array<pollfd, 2> waiting{pollfd{program_.output(), POLLIN, 0}, pollfd{messages_, POLLIN, 0}};
        const int ready = ::poll(waiting.data(), waiting.size(), static_cast<int>(longest.count()));
        if (ready == 0 || (ready < 0 && errno == EINTR)) return {};
        if (waiting[1].revents != 0) hear_messages();
        if (waiting[0].revents == 0) return {};
        const std::size_t wanted = loss_ ? std::min(into.size(), before_loss_) : into.size();
        if (wanted == 0) return *std::exchange(loss_, std::nullopt);
        const std::size_t count = read_some(program_.output(), into.first(wanted), "the sound of " + name_).value_or(0);
        if (loss_) before_loss_ -= count;
        return count > 0 ? bytes_arrived(count) : ending();
    }

private:
    // what lies in the pipe when a loss is told came before it
    void hear_messages() {
        std::array<char, 4096> buffer{};
        const std::size_t count = read_some(messages_, buffer, "the messages of " + name_).value_or(0);
        if (count == 0) messages_ = -1;  // closed: nothing more to hear
        const std::optional<LostSound> lost = words_.hear({buffer.data(), count});
        if (!lost || loss_) return;
        int lying = 0;
        if (::ioctl(program_.output(), FIONREAD, &lying) != 0) lying = 0;
        before_loss_ = static_cast<std::size_t>(lying);
        loss_ = Arrival{Arrival::Kind::lost, 0, lost->seconds, lost->words};
    }

    Arrival ending() {
        while (messages_ >= 0)
            hear_messages();
        if (loss_) {
            before_loss_ = 0;
            return *std::exchange(loss_, std::nullopt);
        }
        if (!status_) status_ = program_.wait();
        const int status = *status_;
        if (status == 0) return over(name_ + " ended");
        throw Error(ErrorKind::io,
                    {name_ + " ended with exit code " + std::to_string(status), words_.last(),
                     "Are the device's name, rate and number of channels right? `arecord -L`, `pactl list "
                     "short sources` list devices."});
    }

    std::string name_;
    base::PipedProcess program_;
    int messages_ = program_.messages();
    RecorderWords words_;
    std::optional<int> status_{};    // once it is over
    std::optional<Arrival> loss_{};  // told after the bytes before it
    std::size_t before_loss_ = 0;    // [bytes]
};

}  // namespace

std::unique_ptr<ByteFlow> flow_of_descriptor(int descriptor) {
    return std::make_unique<DescriptorFlow>(descriptor);
}

std::unique_ptr<ByteFlow> flow_of_growing_file(const std::string& path) {
    return std::make_unique<GrowingFile>(path);
}

std::unique_ptr<ByteFlow> flow_of_program(const std::vector<std::string>& command) {
    return std::make_unique<ProgramFlow>(command);
}

}  // namespace stridor::recordings
