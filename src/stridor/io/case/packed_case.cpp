#include "stridor/io/case/packed_case.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/io/case/case_changes.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/contact_field.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// Text, then the times and velocities of samples, then the structure if matrices gave it. Numbers are their bytes: a
// hundred million of them are no text.

namespace stridor::io {

namespace {

using parameters::Case;
using parameters::OutlinePoint;
using parameters::OwnContact;
using parameters::OwnOutput;
using parameters::OwnStructure;

constexpr std::string_view packed_mark = "stridor.case/1";
constexpr std::uint64_t longest_list = 65536;  // [1] of rows, contacts, outputs: more are broken bytes

/// Puts members into bytes.
class Packer {
public:
    void operator()(const std::string& words) { packing_.add(std::string_view(words)); }
    void operator()(double number) { put(&number, 1); }
    void operator()(const std::vector<double>& numbers) { put(numbers.data(), numbers.size()); }
    void operator()(const std::optional<double>& number) { put(number ? &*number : nullptr, number ? 1 : 0); }
    void operator()(const std::optional<std::array<double, 3>>& place) {
        put(place ? place->data() : nullptr, place ? place->size() : 0);
    }
    template <typename Each>
    std::size_t count(const std::vector<Each>& list) {
        packing_.add(std::uint64_t{list.size()});
        return list.size();
    }
    std::string take() { return packing_.take(); }

private:
    void put(const double* numbers, std::size_t count) {
        packing_.add(std::string_view(reinterpret_cast<const char*>(numbers), count * sizeof(double)));
    }

    base::Packing packing_;
};

/// Takes them out again.
class Unpacker {
public:
    explicit Unpacker(std::string_view bytes) : unpacking_(bytes) {}

    void operator()(std::string& words) { words = unpacking_.words(); }
    void operator()(double& number) { number = exactly(1).front(); }
    void operator()(std::vector<double>& numbers) {
        const std::string bytes = unpacking_.words();
        is_good_ = is_good_ && bytes.size() % sizeof(double) == 0;
        numbers.resize(bytes.size() / sizeof(double));
        if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
    }
    void operator()(std::optional<double>& number) {
        std::vector<double> numbers;
        (*this)(numbers);
        number = numbers.size() == 1 ? std::optional(numbers.front()) : std::nullopt;
    }
    void operator()(std::optional<std::array<double, 3>>& place) {
        std::vector<double> numbers;
        (*this)(numbers);
        if (numbers.size() == 3) place = {numbers[0], numbers[1], numbers[2]};
    }
    template <typename Each>
    std::size_t count(std::vector<Each>& list) {
        const std::uint64_t count = unpacking_.count();
        is_good_ = is_good_ && unpacking_.is_good() && count <= longest_list;
        list.resize(is_good_ ? count : 0);
        return list.size();
    }

    bool is_good() const { return is_good_ && unpacking_.is_good(); }
    bool is_complete() const { return is_good_ && unpacking_.is_complete(); }

private:
    std::vector<double> exactly(std::size_t count) {
        std::vector<double> numbers;
        (*this)(numbers);
        is_good_ = is_good_ && numbers.size() == count;
        numbers.resize(count);
        return numbers;
    }

    base::Unpacking unpacking_;
    bool is_good_ = true;
};

// in the order in which these bytes have them
constexpr std::array<std::string_view, parameters::first_contact_fields> packed_keys{"name",
                                                                                     "normal",
                                                                                     "tangent",
                                                                                     "second_tangent",
                                                                                     "initial_gap",
                                                                                     "interface",
                                                                                     "static_friction",
                                                                                     "kinetic_friction",
                                                                                     "preload_share",
                                                                                     "drive_share",
                                                                                     "second_drive_share",
                                                                                     "position"};

// every member in one order, for both
template <typename Archive, typename Contact>
void pass_contact(Archive& pass, Contact& contact) {
    for (const std::string_view key : packed_keys)
        std::visit([&](auto member) { pass(contact.*member); }, parameters::contact_field(key).member);
}

template <typename Archive, typename Structure>
void pass_structure(Archive& pass, Structure& own) {
    pass(own.origin), pass(own.mass), pass(own.stiffness), pass(own.damping);
    for (std::size_t k = 0, count = pass.count(own.row); k < count; ++k)
        pass(own.row[k]);
    pass(own.following.ratio), pass(own.following.loss_factor);
    pass(own.following.rayleigh_mass), pass(own.following.rayleigh_stiffness), pass(own.left_out_above);
    pass(own.load), pass(own.force), pass(own.initial_displacement), pass(own.initial_velocity);
    for (std::size_t k = 0, count = pass.count(own.contacts); k < count; ++k)
        pass_contact(pass, own.contacts[k]);
    for (std::size_t k = 0, count = pass.count(own.outputs); k < count; ++k)
        pass(own.outputs[k].name), pass(own.outputs[k].weights);
    for (std::size_t k = 0, count = pass.count(own.outline); k < count; ++k) {
        std::optional<std::array<double, 3>> position = own.outline[k].position;
        pass(position), pass(own.outline[k].along), pass(own.outline[k].across);
        if constexpr (!std::is_const_v<Structure>) own.outline[k].position = position.value_or(std::array<double, 3>{});
    }
}

// do all numbers have their rows?
bool has_its_shape(const OwnStructure& own) {
    const std::size_t rows = own.row.size();
    const auto fits = [&](const std::vector<double>& numbers) { return numbers.size() == rows; };
    const auto fits_or_is_none = [&](const std::vector<double>& numbers) { return numbers.empty() || fits(numbers); };
    bool is_good = own.mass.size() == rows * rows && own.stiffness.size() == rows * rows;
    is_good = is_good && (own.damping.empty() || own.damping.size() == rows * rows);
    for (const auto& numbers : {own.load, own.force, own.initial_displacement, own.initial_velocity})
        is_good = is_good && fits_or_is_none(numbers);
    for (const OwnContact& contact : own.contacts)
        is_good = is_good && fits(contact.normal) && fits(contact.tangent) && fits_or_is_none(contact.second_tangent);
    for (const OwnOutput& output : own.outputs)
        is_good = is_good && fits(output.weights);
    for (const OutlinePoint& point : own.outline)
        is_good = is_good && fits(point.along) && fits(point.across);
    return is_good && !own.contacts.empty();
}

[[noreturn]] void refuse_bytes() {
    base::refuse("these bytes are no case", "they end early, or are another version's", "Make them anew.");
}

}  // namespace

std::string packed_case(const Case& c) {
    const bool is_given = has_given_structure(c);
    Packer packer;
    packer(std::string(packed_mark));
    packer(case_toml(is_given ? without_matrices(c) : c, {.comments = Comments::none, .heading = ""}));
    packer(c.drive.times), packer(c.drive.velocities);
    packer(is_given ? 1.0 : 0.0);
    if (is_given) pass_structure(packer, *c.own_structure);
    return packer.take();
}

Case unpacked_case(std::string_view bytes) {
    Unpacker unpacker(bytes);
    std::string mark, text;
    std::vector<double> times, velocities;
    double is_given = 0.0;
    unpacker(mark), unpacker(text), unpacker(times), unpacker(velocities), unpacker(is_given);
    if (!unpacker.is_good() || mark != packed_mark || times.size() != velocities.size()) refuse_bytes();
    const auto own = std::make_shared<OwnStructure>();
    if (is_given != 0.0) pass_structure(unpacker, *own);
    if (!unpacker.is_complete() || (is_given != 0.0 && !has_its_shape(*own))) refuse_bytes();
    CaseReaders readers;
    if (!times.empty())
        readers.samples = [&](const std::string&) { return recordings::SampledMotion{times, velocities}; };
    if (is_given != 0.0) readers.structure = [&](const TomlDocument&) { return own; };
    return read_case(parse_toml({text, "<packed>", {}}), readers);
}

}  // namespace stridor::io
