#include "stridor/cluster/messages.hpp"

#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

namespace stridor::cluster {

namespace {

[[noreturn]] void refuse() {
    throw Error(ErrorKind::io, {"a message between two ranks is damaged", "its bytes are none of this program's",
                                "Is the same program started everywhere?"});
}

class Packer {
public:
    template <typename Number>
    requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
    void add(Number value) {
        std::array<char, sizeof value> bytes;
        std::memcpy(bytes.data(), &value, sizeof value);
        bytes_.append(bytes.data(), bytes.size());
    }
    void add(const std::string& text) {
        add(static_cast<std::uint32_t>(text.size()));
        bytes_ += text;
    }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

class Unpacker {
public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

    template <typename Number>
    Number number() {
        Number value{};
        std::memcpy(&value, next(sizeof value).data(), sizeof value);
        return value;
    }
    // an enumeration that ends before `count`
    template <typename Enumeration>
    Enumeration word(std::size_t count) {
        const auto value = number<Enumeration>();
        if (static_cast<std::size_t>(value) >= count) refuse();
        return value;
    }
    std::string text() { return std::string(next(number<std::uint32_t>())); }
    // a number of things of so many bytes at least, which must all be there
    std::size_t count(std::size_t bytes_each) {
        const auto count = number<std::uint32_t>();
        if (count > bytes_.size() / bytes_each) refuse();
        return count;
    }
    void expect_end() const {
        if (!bytes_.empty()) refuse();
    }

private:
    std::string_view next(std::size_t size) {
        if (size > bytes_.size()) refuse();
        const std::string_view taken = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return taken;
    }

    std::string_view bytes_;
};

void add_start(Packer& packer, const sweep::StartVerdict& start) {
    packer.add(start.status);
    packer.add(start.category);
}

sweep::StartVerdict start_in(Unpacker& bytes) {
    const auto status = bytes.word<sweep::Status>(sweep::status_names.size());
    return {status, bytes.word<classification::Category>(classification::category_names.size())};
}

void add_cell(Packer& packer, const sweep::IndexedCell& indexed) {
    const sweep::Cell& cell = indexed.cell;
    packer.add(indexed.index);
    packer.add(cell.status);
    packer.add(cell.category);
    packer.add(cell.quiet);
    packer.add(cell.agreement);
    packer.add(cell.message);
    packer.add(static_cast<std::uint32_t>(cell.starts.size()));
    for (const sweep::StartVerdict& start : cell.starts)
        add_start(packer, start);
    packer.add(static_cast<std::uint32_t>(cell.figures.size()));
    for (const double figure : cell.figures)
        packer.add(figure);
}

sweep::IndexedCell cell_in(Unpacker& bytes) {
    sweep::IndexedCell indexed;
    sweep::Cell& cell = indexed.cell;
    indexed.index = bytes.number<std::size_t>();
    cell.status = bytes.word<sweep::Status>(sweep::status_names.size());
    cell.category = bytes.word<classification::Category>(classification::category_names.size());
    cell.quiet = bytes.word<classification::Quiet>(classification::quiet_names.size());
    cell.agreement = bytes.word<sweep::Agreement>(sweep::agreement_names.size());
    cell.message = bytes.text();
    for (std::size_t left = bytes.count(2); left > 0; --left)
        cell.starts.push_back(start_in(bytes));
    for (std::size_t left = bytes.count(sizeof(double)); left > 0; --left)
        cell.figures.push_back(bytes.number<double>());
    return indexed;
}

// what follows the kind of a message

void add(Packer& packer, const Hello& hello) {
    packer.add(hello.build);
    packer.add(hello.study);
    packer.add(hello.host);
    packer.add(hello.threads);
}

void add(Packer& packer, const Batch& batch) {
    packer.add(static_cast<std::uint32_t>(batch.runs.size()));
    for (const std::size_t run : batch.runs)
        packer.add(run);
}

void add(Packer& packer, const Cells& cells) {
    packer.add(cells.seconds_per_run);
    packer.add(static_cast<std::uint32_t>(cells.cells.size()));
    for (const sweep::IndexedCell& indexed : cells.cells)
        add_cell(packer, indexed);
}

void add(Packer& packer, const Failure& failure) {
    packer.add(failure.kind);
    packer.add(failure.problem.what);
    packer.add(failure.problem.why);
    packer.add(failure.problem.suggestion);
}

void add(Packer& packer, const End& end) {
    packer.add(end.exit_code);
}

void add(Packer&, const Alive&) {}
void add(Packer&, const Stop&) {}
void add(Packer&, const Stopped&) {}
void add(Packer&, const Bye&) {}

Message hello_in(Unpacker& bytes) {
    Hello hello;
    hello.build = bytes.text();
    hello.study = bytes.text();
    hello.host = bytes.text();
    hello.threads = bytes.number<std::uint32_t>();
    return hello;
}

Message batch_in(Unpacker& bytes) {
    Batch batch;
    for (std::size_t left = bytes.count(sizeof(std::size_t)); left > 0; --left)
        batch.runs.push_back(bytes.number<std::size_t>());
    return batch;
}

Message cells_in(Unpacker& bytes) {
    Cells cells;
    cells.seconds_per_run = bytes.number<double>();
    for (std::size_t left = bytes.count(sizeof(std::size_t)); left > 0; --left)
        cells.cells.push_back(cell_in(bytes));
    return cells;
}

Message failure_in(Unpacker& bytes) {
    Failure failure;
    failure.kind = bytes.word<ErrorKind>(4);
    failure.problem.what = bytes.text();
    failure.problem.why = bytes.text();
    failure.problem.suggestion = bytes.text();
    return failure;
}

Message end_in(Unpacker& bytes) {
    return End{bytes.number<int>()};
}

template <typename Kind>
Message nothing_in(Unpacker&) {
    return Kind{};
}

// in the order of Message
constexpr std::array readers{&hello_in,          &batch_in,         &cells_in,
                             &nothing_in<Alive>, &nothing_in<Stop>, &nothing_in<Stopped>,
                             &failure_in,        &end_in,           &nothing_in<Bye>};
static_assert(readers.size() == std::variant_size_v<Message>);

}  // namespace

std::string pack(const Message& message) {
    Packer packer;
    packer.add(static_cast<std::uint8_t>(message.index()));
    std::visit([&](const auto& content) { add(packer, content); }, message);
    return packer.take();
}

Message unpack(std::string_view bytes) {
    Unpacker unpacker(bytes);
    const auto kind = unpacker.number<std::uint8_t>();
    if (kind >= readers.size()) refuse();
    Message message = readers[kind](unpacker);
    unpacker.expect_end();
    return message;
}

}  // namespace stridor::cluster
