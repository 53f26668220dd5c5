#include "bindings.hpp"
#include "handles.hpp"
#include "stridor/analysis/evidence.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/case_changes.hpp"
#include "stridor/io/case/packed_case.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/sweep/cell.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace stridor::binding {

namespace {

using parameters::Case;
using parameters::Field;

CaseHandle handle(Case c) {
    return {std::make_shared<const Case>(std::move(c))};
}

std::vector<std::string> ready_names() {
    std::vector<std::string> names = io::ready_file_names();
    std::erase(names, "schema");
    return names;
}

CaseHandle ready_case(const std::string& name) {
    const std::vector<std::string> names = ready_names();
    if (std::find(names.begin(), names.end(), name) == names.end())
        base::refuse("there is no case \"" + name + "\"", "", base::did_you_mean(name, names));
    return handle(io::read_case({io::ready_file(name), name, {}}));
}

// its samples are then found from the current folder, as the file itself is
CaseHandle read(const std::string& path) {
    Case c = io::read_case(path);
    if (parameters::is_of_file(c.drive))
        c.drive.file = (std::filesystem::path(path).parent_path() / c.drive.file).string();
    return handle(std::move(c));
}

CaseHandle from_toml(const std::string& text, const std::string& name) {
    return handle(io::read_case({text, name, {}}));
}

std::string to_toml(const CaseHandle& c, bool comments) {
    return io::case_toml(*c.of, {.comments = comments ? io::Comments::full : io::Comments::none, .heading = ""});
}

// what a key of a document takes; None opens a table
io::TomlValue toml_value(const py::handle& value) {
    if (value.is_none()) return io::TomlTable{};
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
    if (py::isinstance<py::list>(value)) return value.cast<std::vector<std::string>>();
    if (!py::isinstance<py::array>(value)) return value.cast<double>();
    const auto numbers = value.cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    const std::vector<double> all(numbers.data(), numbers.data() + numbers.size());
    if (numbers.ndim() != 2) return all;
    io::TomlRows rows;
    for (py::ssize_t row = 0; row < numbers.shape(0); ++row)
        rows.emplace_back(numbers.data(row, 0), numbers.data(row, 0) + numbers.shape(1));
    return rows;
}

// the entries of a document that nobody has written
CaseHandle from_entries(const std::vector<std::pair<std::string, py::object>>& entries) {
    io::TomlDocument document{"the case", {}};
    for (const auto& [key, value] : entries)
        document.entries.push_back({key, toml_value(value), io::TomlOrigin::file, {}, {}});
    return handle(io::read_case(document));
}

// a warning for each key that the file has for nothing
std::vector<std::string> warnings(const std::string& path) {
    std::vector<std::string> texts;
    for (const base::Complaint& warning : io::case_warnings(io::parse_toml(io::load_toml(path))))
        texts.emplace_back(Error(ErrorKind::input, warning.problem, warning.place).what());
    return texts;
}

std::string expected_key(const Case& c, const std::string& name) {
    std::string key = parameters::key_called(name);
    parameters::expect_joint_of(c, key);
    if (!parameters::belongs(c, key)) {
        const std::string home = parameters::home_of(c, *parameters::field_of(key));
        base::refuse(key + " means nothing for this case", home.empty() ? "" : "it belongs to " + home, "");
    }
    if (!parameters::has_one_value(c, key))
        base::refuse(key + " has several values", "joints differ in it",
                     "Ask for one of " + base::listed(parameters::single_keys(c, key)) + ".");
    return key;
}

py::object value(const CaseHandle& handle, const std::string& name) {
    const std::string key = expected_key(*handle.of, name);
    if (std::holds_alternative<parameters::Quantity>(parameters::field_of(key)->kind))
        return py::float_(parameters::get_quantity(*handle.of, key));
    return python_text(parameters::value_text(*handle.of, key));
}

CaseHandle changed(const CaseHandle& handle_of,
                   const std::vector<std::pair<std::string, std::variant<double, std::string>>>& changes) {
    std::vector<io::CaseChange> list;
    for (const auto& [name, value] : changes)
        list.push_back({name, value});
    return handle(io::changed(*handle_of.of, list));
}

std::vector<std::string> joint_names(const CaseHandle& handle) {
    std::vector<std::string> names;
    for (std::size_t joint = 0; parameters::has_several_joints(*handle.of) && joint < handle.of->joints.size(); ++joint)
        names.push_back(parameters::joint_name(*handle.of, joint));
    return names;
}

bool are_equal(const CaseHandle& a, const CaseHandle& b) {
    return a.of->title == b.of->title && a.of->drive.file == b.of->drive.file &&
           parameters::canonical_text(*a.of) == parameters::canonical_text(*b.of);
}

py::dict python_field(const Field& field) {
    py::dict row;
    row["key"] = parameters::key_of(field);
    row["section"] = field.section;
    row["name"] = field.name;
    row["symbol"] = field.symbol;
    row["sentence"] = field.sentence;
    row["values"] = io::describe_values(field);
    row["is_of_builder"] = parameters::is_of_builder(field);
    row["unit"] = py::none();
    row["choices"] = py::none();
    if (const auto* quantity = std::get_if<parameters::Quantity>(&field.kind)) {
        row["unit"] = quantity->unit;
        row["low"] = quantity->range.low;
        row["high"] = quantity->range.high;
        row["low_is_open"] = quantity->range.low_end == parameters::Range::Low::open;
    }
    if (const auto* choice = std::get_if<parameters::Choice>(&field.kind))
        row["choices"] = std::vector<std::string_view>(choice->names.begin(), choice->names.end());
    return row;
}

py::list python_fields() {
    py::list rows;
    for (const Field& field : parameters::fields())
        rows.append(python_field(field));
    return rows;
}

// name, unit and sentence of each
template <typename Figures>
py::list figure_table(const Figures& figures) {
    py::list rows;
    for (const auto& figure : figures)
        rows.append(py::make_tuple(figure.name, figure.unit, figure.sentence));
    return rows;
}

}  // namespace

void bind_case(py::module_& module) {
    py::class_<CaseHandle>(module, "CaseHandle", "A case; it never changes.")
        .def("to_toml", &to_toml, py::arg("comments"))
        .def("value", &value, py::arg("name"))
        .def(
            "text",
            [](const CaseHandle& c, const std::string& name) {
                return python_text(parameters::value_text(*c.of, expected_key(*c.of, name)));
            },
            py::arg("name"))
        .def("changed", &changed, py::arg("changes"))
        .def("keys", [](const CaseHandle& c) { return parameters::keys_of(*c.of); })
        .def("joints", &joint_names)
        .def("packed", [](const CaseHandle& c) { return py::bytes(io::packed_case(*c.of)); })
        .def("json", [](const CaseHandle& c) { return python_text(io::case_json(*c.of)); })
        .def("equals", &are_equal, py::arg("other"));
    module.def("ready_case", &ready_case, py::arg("name"));
    module.def("ready_names", &ready_names);
    module.def("read", &read, py::arg("path"));
    module.def("warnings", &warnings, py::arg("path"));
    module.def("from_entries", &from_entries, py::arg("entries"));
    module.def("contact_units", [] {
        py::dict units;
        for (const parameters::ContactField& field : parameters::contact_fields())
            units[py::str(std::string(field.key))] = field.unit == "1" ? std::string_view() : field.unit;
        return units;
    });
    module.def("from_toml", &from_toml, py::arg("text"), py::arg("name"));
    module.def(
        "unpacked", [](const std::string& bytes) { return handle(io::unpacked_case(bytes)); }, py::arg("bytes"));
    module.def("fields", &python_fields);
    module.def(
        "key_called", [](const std::string& name) { return parameters::key_called(name); }, py::arg("name"));
    module.def(
        "unit_of", [](const std::string& name) { return parameters::unit_of(parameters::key_called(name)); },
        py::arg("name"));
    module.def("quantity", &base::parse_quantity, py::arg("text"), py::arg("unit"));
    module.def("phase_figures", [] { return figure_table(analysis::evidence_figures()); });
    module.def("cell_figures", [] { return figure_table(sweep::cell_figures()); });
}

}  // namespace stridor::binding
