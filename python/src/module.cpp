#include "bindings.hpp"
#include "handles.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"

#include <exception>
#include <filesystem>

namespace stridor::binding {

namespace {

// by ErrorKind
constexpr const char* exception_names[] = {"InputError", "NumericalError", "Interrupted", "FileError"};

py::object python_place(const std::optional<base::Place>& place) {
    if (!place) return py::none();
    return py::module_::import("stridor.errors")
        .attr("Place")(python_text(place->file), place->line, place->column, python_text(place->source_line));
}

py::tuple python_complaint(const base::Complaint& complaint) {
    return py::make_tuple(python_text(complaint.problem.what), python_text(complaint.problem.why),
                          python_text(complaint.problem.suggestion), python_place(complaint.place));
}

void set_error(const Error& error) {
    py::list complaints;
    for (const base::Complaint& complaint : error.complaints())
        complaints.append(python_complaint(complaint));
    const py::object type =
        py::module_::import("stridor.errors").attr(exception_names[static_cast<std::size_t>(error.kind())]);
    PyErr_SetObject(type.ptr(), type.attr("_of")(python_text(error.what()), py::tuple(complaints)).ptr());
}

void bind_errors() {
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const Error& error) {
            set_error(error);
        } catch (const std::filesystem::filesystem_error& error) {
            set_error(Error(ErrorKind::io, {error.what(), "", ""}));
        }
    });
}

}  // namespace

}  // namespace stridor::binding

PYBIND11_MODULE(_stridor, module) {
    using namespace stridor;
    module.doc() = "What of Stridor is compiled. Use the package `stridor`, which is documented.";
    module.attr("version") = std::string(base::version());
    module.attr("commit") = std::string(base::commit());
    binding::bind_errors();
    binding::bind_case(module);
    binding::bind_simulation(module);
    binding::bind_charts(module);
    binding::bind_answers(module);
}
