#pragma once

// netCDF, opened when the first file is made: linked to the program, it and the forty libraries it needs would be
// loaded at every start. Private to this folder.

#include "stridor/base/opened_library.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

namespace stridor::io {

/// The functions that Stridor uses, of the version it was built with.
struct Netcdf {
    base::OpenedLibrary library{STRIDOR_NETCDF_LIBRARY};
    decltype(&::nc_abort) nc_abort = library.function("nc_abort");
    decltype(&::nc_close) nc_close = library.function("nc_close");
    decltype(&::nc_close_memio) nc_close_memio = library.function("nc_close_memio");
    decltype(&::nc_create) nc_create = library.function("nc_create");
    decltype(&::nc_create_mem) nc_create_mem = library.function("nc_create_mem");
    decltype(&::nc_def_dim) nc_def_dim = library.function("nc_def_dim");
    decltype(&::nc_def_var) nc_def_var = library.function("nc_def_var");
    decltype(&::nc_def_var_chunking) nc_def_var_chunking = library.function("nc_def_var_chunking");
    decltype(&::nc_def_var_deflate) nc_def_var_deflate = library.function("nc_def_var_deflate");
    decltype(&::nc_def_var_fill) nc_def_var_fill = library.function("nc_def_var_fill");
    decltype(&::nc_free_string) nc_free_string = library.function("nc_free_string");
    decltype(&::nc_get_att_text) nc_get_att_text = library.function("nc_get_att_text");
    decltype(&::nc_get_var_double) nc_get_var_double = library.function("nc_get_var_double");
    decltype(&::nc_get_var_string) nc_get_var_string = library.function("nc_get_var_string");
    decltype(&::nc_inq_attlen) nc_inq_attlen = library.function("nc_inq_attlen");
    decltype(&::nc_inq_atttype) nc_inq_atttype = library.function("nc_inq_atttype");
    decltype(&::nc_inq_dimlen) nc_inq_dimlen = library.function("nc_inq_dimlen");
    decltype(&::nc_inq_vardimid) nc_inq_vardimid = library.function("nc_inq_vardimid");
    decltype(&::nc_inq_varid) nc_inq_varid = library.function("nc_inq_varid");
    decltype(&::nc_inq_varndims) nc_inq_varndims = library.function("nc_inq_varndims");
    decltype(&::nc_inq_vartype) nc_inq_vartype = library.function("nc_inq_vartype");
    decltype(&::nc_open) nc_open = library.function("nc_open");
    decltype(&::nc_open_mem) nc_open_mem = library.function("nc_open_mem");
    decltype(&::nc_put_att_schar) nc_put_att_schar = library.function("nc_put_att_schar");
    decltype(&::nc_put_att_text) nc_put_att_text = library.function("nc_put_att_text");
    decltype(&::nc_put_var_double) nc_put_var_double = library.function("nc_put_var_double");
    decltype(&::nc_put_var_schar) nc_put_var_schar = library.function("nc_put_var_schar");
    decltype(&::nc_put_var_text) nc_put_var_text = library.function("nc_put_var_text");
    decltype(&::nc_put_var_string) nc_put_var_string = library.function("nc_put_var_string");
    decltype(&::nc_put_vara_double) nc_put_vara_double = library.function("nc_put_vara_double");
    decltype(&::nc_put_vara_schar) nc_put_vara_schar = library.function("nc_put_vara_schar");
    decltype(&::nc_set_var_chunk_cache) nc_set_var_chunk_cache = library.function("nc_set_var_chunk_cache");
    decltype(&::nc_strerror) nc_strerror = library.function("nc_strerror");
};

/// The library, opened once for the process. Throws `Error` (io) where this machine lacks it.
const Netcdf& netcdf();

}  // namespace stridor::io
