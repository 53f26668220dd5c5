// Writes a small chart in the way of one that does not fit into memory: large_chart FILE.nc

#include "stridor/io/chart/chart_netcdf.hpp"
#include "unit/io/io_support.hpp"

#include <iostream>

int main(int argc, char** argv) {
    using namespace stridor;
    if (argc != 2) return 2;
    try {
        io::write_chart_netcdf(argv[1], io::small_chart(), {.largest_in_memory = 0});
        return 0;
    } catch (const Error& error) {
        std::cerr << "error: " << error.what() << '\n';
        return base::exit_code(error.kind());
    }
}
