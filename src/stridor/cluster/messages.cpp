#include "stridor/cluster/messages.hpp"

#include "stridor/base/hash.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/base/version.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

namespace stridor::cluster {

namespace {

// by the place in Message
enum class Kind : std::uint8_t {};

using base::Packing;
using base::Unpacking;

template <typename Numbered>
void add_all(Packing& packing, const std::vector<Numbered>& all) {
    packing.add(static_cast<std::uint64_t>(all.size()));
    for (const Numbered& each : all) {
        packing.add(static_cast<std::uint64_t>(each.number));
        packing.add(each.bytes);
    }
}

template <typename Numbered>
std::vector<Numbered> all_in(Unpacking& bytes) {
    std::vector<Numbered> all;
    for (std::uint64_t left = bytes.count(); left > 0 && bytes.is_good(); --left) {
        Numbered& each = all.emplace_back();
        each.number = bytes.count();
        each.bytes = bytes.words();
    }
    return all;
}

// what follows the kind of a message

void add(Packing& packing, const Begin& begin) {
    packing.add(begin.build);
    packing.add(begin.work);
    packing.add(begin.host);
}

void add(Packing& packing, const Hello& hello) {
    packing.add(hello.host);
    packing.add(std::uint64_t{hello.threads});
}

void add(Packing& packing, const Batch& batch) {
    add_all(packing, batch.tasks);
}

void add(Packing& packing, const Delivery& results) {
    packing.add(results.seconds_per_task);
    add_all(packing, results.results);
}

void add(Packing& packing, const Failure& failure) {
    packing.add(failure.kind);
    packing.add(failure.problem.what);
    packing.add(failure.problem.why);
    packing.add(failure.problem.suggestion);
}

void add(Packing& packing, const End& end) {
    packing.add(static_cast<std::uint64_t>(end.exit_code));
}

void add(Packing&, const Alive&) {}
void add(Packing&, const Stop&) {}
void add(Packing&, const Stopped&) {}
void add(Packing&, const Bye&) {}

Message begin_in(Unpacking& bytes) {
    Begin begin;
    begin.build = bytes.words();
    begin.work = bytes.words();
    begin.host = bytes.words();
    return begin;
}

Message hello_in(Unpacking& bytes) {
    Hello hello;
    hello.host = bytes.words();
    hello.threads = static_cast<std::uint32_t>(bytes.count());
    return hello;
}

Message batch_in(Unpacking& bytes) {
    return Batch{all_in<crew::Task>(bytes)};
}

Message delivery_in(Unpacking& bytes) {
    Delivery results;
    results.seconds_per_task = bytes.number();
    results.results = all_in<crew::Result>(bytes);
    return results;
}

Message failure_in(Unpacking& bytes) {
    Failure failure;
    failure.kind = bytes.kind<ErrorKind>(4);
    failure.problem.what = bytes.words();
    failure.problem.why = bytes.words();
    failure.problem.suggestion = bytes.words();
    return failure;
}

Message end_in(Unpacking& bytes) {
    return End{static_cast<int>(bytes.count())};
}

template <typename Nothing>
Message nothing_in(Unpacking&) {
    return Nothing{};
}

// in the order of Message
constexpr std::array readers{
    &begin_in,   &hello_in, &batch_in,       &delivery_in, &nothing_in<Alive>, &nothing_in<Stop>, &nothing_in<Stopped>,
    &failure_in, &end_in,   &nothing_in<Bye>};
static_assert(readers.size() == std::variant_size_v<Message>);

std::string build() {
    return fmt::format("stridor {} ({})", base::version(), base::commit());
}

}  // namespace

std::string pack(const Message& message) {
    Packing packing;
    packing.add(static_cast<Kind>(message.index()));
    std::visit([&](const auto& content) { add(packing, content); }, message);
    return packing.take();
}

Message unpack(std::string_view bytes) {
    Unpacking unpacking(bytes);
    const auto kind = static_cast<std::size_t>(unpacking.kind<Kind>(readers.size()));
    Message message = readers.at(kind)(unpacking);
    if (!unpacking.is_complete())
        throw Error(ErrorKind::io, {"a message between two ranks is damaged", "its bytes are none of this program's",
                                    "Is the same program started everywhere?"});
    return message;
}

std::string host_name() {
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) != 0) return "a machine without a name";
    return name.data();
}

Begin begin_of(const crew::Work& work) {
    return {build(), base::sha256_text(work.text), host_name()};
}

Failure mismatch(const Begin& begun, int rank) {
    const std::string where = fmt::format("rank {} on {}", rank, host_name());
    if (begun.build != build())
        return {ErrorKind::input,
                {where + " runs another program than rank 0 on " + begun.host,
                 build() + " there, " + begun.build + " here", "Start the same program everywhere."}};
    return {ErrorKind::input,
            {where + " reads another case or chart than rank 0 on " + begun.host,
             "the file, or one that it names, is not the same there",
             "Give it by a path that leads to one file from everywhere."}};
}

}  // namespace stridor::cluster
