#include "stridor/io/netcdf_library.hpp"

namespace stridor::io {

const Netcdf& netcdf() {
    static const Netcdf opened;
    opened.library.expect_whole("netCDF files cannot be made");
    return opened;
}

}  // namespace stridor::io
