#include "bindings.hpp"
#include "stridor/base/version.hpp"

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
