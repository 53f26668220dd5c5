#include "stridor/io/case/packed_case.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/io/case/case_document.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/own_spring.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <algorithm>
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

// The entries of the case's document, then the times and velocities of samples, then the structure if matrices gave it,
// behind the keys of its contacts. Numbers are their bytes: a hundred million of them are no text. The first form had a
// TOML text in place of entries, and always the same keys; it is read, too.

namespace stridor::io {

namespace {

using parameters::Case;
using parameters::OutlinePoint;
using parameters::OwnContact;
using parameters::OwnOutput;
using parameters::OwnStructure;

constexpr std::string_view packed_mark = "stridor.case/2";
constexpr std::string_view first_mark = "stridor.case/1";
constexpr double without_springs = 1.0, with_springs = 2.0;  // what follows of a structure that matrices gave
constexpr std::uint64_t longest_list = 65536;                // [1] of rows, contacts, outputs: more are broken bytes

/// Puts members into bytes.
class Packer {
public:
    void operator()(std::string_view words) { packing_.add(words); }
    void operator()(const std::vector<std::string>& list) {
        count(list);
        for (const std::string& words : list)
            (*this)(words);
    }
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
    void kind(const TomlValue& value) { packing_.add(std::uint64_t{value.index()}); }
    std::string take() { return packing_.take(); }

private:
    void put(const double* numbers, std::size_t count) {
        packing_.add(std::string_view(reinterpret_cast<const char*>(numbers), count * sizeof(double)));
    }

    base::Packing packing_;
};

// an empty value of one kind; of no kind that there is: the last, which no key takes
template <std::size_t index = 0>
TomlValue alternative(std::uint64_t kind) {
    if constexpr (index + 1 < std::variant_size_v<TomlValue>)
        if (index != kind) return alternative<index + 1>(kind);
    return TomlValue(std::in_place_index<index>);
}

/// Takes them out again.
class Unpacker {
public:
    explicit Unpacker(std::string_view bytes) : unpacking_(bytes) {}

    void operator()(std::string& words) { words = unpacking_.words(); }
    void operator()(std::vector<std::string>& list) {
        count(list);
        for (std::string& words : list)
            (*this)(words);
    }
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

    void kind(TomlValue& value) { value = alternative(unpacking_.count()); }
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

using Keys = std::vector<std::string>;

const Keys& keys_of_first_form() {
    static const Keys keys{"name",
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
    return keys;
}

Keys keys_of_contacts() {
    Keys keys;
    for (const parameters::ContactField& field : parameters::contact_fields())
        keys.emplace_back(field.key);
    return keys;
}

// one of them twice, or none that there is: broken bytes
bool are_of_contacts(const Keys& keys) {
    const Keys known = keys_of_contacts();
    return std::all_of(keys.begin(), keys.end(), [&](const std::string& key) {
        return std::count(keys.begin(), keys.end(), key) == 1 && std::count(known.begin(), known.end(), key) == 1;
    });
}

template <typename Archive, typename Structure>
void pass_structure(Archive& pass, Structure& own, const Keys& keys) {
    pass(own.origin), pass(own.mass), pass(own.stiffness), pass(own.damping), pass(own.row);
    pass(own.following.ratio), pass(own.following.loss_factor);
    pass(own.following.rayleigh_mass), pass(own.following.rayleigh_stiffness), pass(own.left_out_above);
    pass(own.load), pass(own.force), pass(own.initial_displacement), pass(own.initial_velocity);
    for (std::size_t k = 0, count = pass.count(own.contacts); k < count; ++k)
        for (const std::string& key : keys)
            std::visit([&](auto member) { pass(own.contacts[k].*member); }, parameters::contact_field(key).member);
    for (std::size_t k = 0, count = pass.count(own.outputs); k < count; ++k)
        pass(own.outputs[k].name), pass(own.outputs[k].weights);
    for (std::size_t k = 0, count = pass.count(own.outline); k < count; ++k) {
        std::optional<std::array<double, 3>> position = own.outline[k].position;
        pass(position), pass(own.outline[k].along), pass(own.outline[k].across);
        if constexpr (!std::is_const_v<Structure>) own.outline[k].position = position.value_or(std::array<double, 3>{});
    }
}

// a form that came later, behind all else
template <typename Archive, typename Structure>
void pass_springs(Archive& pass, Structure& own) {
    for (std::size_t k = 0, count = pass.count(own.springs); k < count; ++k) {
        auto& spring = own.springs[k];
        pass(spring.name), pass(spring.direction), pass(spring.stiffness), pass(spring.cubic), pass(spring.force);
        pass(spring.deflection), pass(spring.exponent), pass(spring.gap), pass(spring.preload_share);
        pass(spring.table.deflections), pass(spring.table.forces);
        double interpolation = static_cast<double>(spring.interpolation);
        pass(interpolation);
        if constexpr (!std::is_const_v<Structure>)
            spring.interpolation =
                interpolation == 0.0 ? parameters::Interpolation::cubic : parameters::Interpolation::linear;
    }
}

template <typename Archive, typename Entries>
void pass_entries(Archive& pass, Entries& entries) {
    const auto pass_number = [&](auto& value) {
        if constexpr (requires { pass(value); }) pass(value);
    };
    for (std::size_t k = 0, count = pass.count(entries); k < count; ++k) {
        pass(entries[k].key), pass.kind(entries[k].value);
        std::visit(pass_number, entries[k].value);
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
    for (const parameters::OwnSpring& spring : own.springs)
        is_good = is_good && fits(spring.direction) && spring.table.forces.size() == spring.table.deflections.size() &&
                  !problem_of(spring);
    for (const OutlinePoint& point : own.outline)
        is_good = is_good && fits(point.along) && fits(point.across);
    return is_good && !own.contacts.empty();
}

[[noreturn]] void refuse_bytes() {
    base::refuse("these bytes are no case", "they end early, or are another version's", "Make them anew.");
}

}  // namespace

std::string packed_case(const Case& c) {
    const bool is_given = parameters::has_given_structure(c);
    const TomlDocument document = document_of(c);
    const Keys keys = keys_of_contacts();
    Packer packer;
    packer(packed_mark);
    pass_entries(packer, document.entries);
    packer(c.drive.times), packer(c.drive.velocities);
    const bool has_springs = is_given && !c.own_structure->springs.empty();
    packer(has_springs ? with_springs : is_given ? without_springs : 0.0);
    if (is_given) packer(keys), pass_structure(packer, *c.own_structure, keys);
    if (has_springs) pass_springs(packer, *c.own_structure);
    return packer.take();
}

Case unpacked_case(std::string_view bytes) {
    Unpacker unpacker(bytes);
    std::string mark, text;
    TomlDocument document{"<packed>", {}};
    std::vector<double> times, velocities;
    double is_given = 0.0;
    Keys keys = keys_of_first_form();
    unpacker(mark);
    const bool is_of_first_form = mark == first_mark;
    if (!is_of_first_form && mark != packed_mark) refuse_bytes();
    is_of_first_form ? unpacker(text) : pass_entries(unpacker, document.entries);
    unpacker(times), unpacker(velocities), unpacker(is_given);
    if (is_given != 0.0 && !is_of_first_form) unpacker(keys);
    if (!unpacker.is_good() || times.size() != velocities.size() || !are_of_contacts(keys)) refuse_bytes();
    const auto own = std::make_shared<OwnStructure>();
    if (is_given != 0.0) pass_structure(unpacker, *own, keys);
    if (is_given == with_springs) pass_springs(unpacker, *own);
    if (!unpacker.is_complete() || (is_given != 0.0 && !has_its_shape(*own))) refuse_bytes();
    if (is_of_first_form) document = parse_toml({text, document.name, {}});
    CaseReaders readers;
    if (!times.empty())
        readers.samples = [&](const std::string&) { return recordings::SampledMotion{times, velocities}; };
    if (is_given != 0.0) readers.structure = [&](const TomlDocument&) { return own; };
    return read_case(document, readers);
}

}  // namespace stridor::io
