# Packages for Debian, made by CPack (`./dev package`): stridor has all but what needs MPI, which is in stridor-mpi.

find_program(STRIDOR_DPKG_QUERY dpkg-query DOC "Names the Debian packages of the libraries that are opened")
if(NOT STRIDOR_DPKG_QUERY)
    return()
endif()

# Sets RESULT to the Debian packages that have the given libraries ("libnetcdf.so.19"), as in a control file.
function(stridor_packages_of result)
    set(packages "")
    list(TRANSFORM ARGN PREPEND "*/" OUTPUT_VARIABLE patterns)
    execute_process(COMMAND "${STRIDOR_DPKG_QUERY}" -S ${patterns} OUTPUT_VARIABLE lines ERROR_QUIET)
    string(REGEX MATCHALL "[^\n]+" lines "${lines}")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE ":.*" "" package "${line}")
        list(APPEND packages "${package}")
    endforeach()
    list(REMOVE_DUPLICATES packages)
    list(JOIN packages ", " packages)
    set(${result} "${packages}" PARENT_SCOPE)
endfunction()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME stridor)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "The Stridor authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/debian/arrange.cmake")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified python)
set(CPACK_COMPONENT_UNSPECIFIED_GROUP stridor)
set(CPACK_COMPONENT_PYTHON_GROUP stridor)
set(CPACK_COMPONENT_GROUP_STRIDOR_DESCRIPTION
    "Program, library with headers, Python module, manual page and documents.")

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_STRIDOR_PACKAGE_NAME stridor)

# what dpkg-shlibdeps cannot see: a font, and libraries that are opened where the machine has them
set(CPACK_DEBIAN_STRIDOR_PACKAGE_DEPENDS fonts-dejavu-core)
stridor_packages_of(recommended
    ${matio_NAME} ${mumps_NAME} ${ffmpeg_NAMES})
set(CPACK_DEBIAN_STRIDOR_PACKAGE_RECOMMENDS "${recommended}")
if(STRIDOR_HAS_PYTHON)
    find_package(Python REQUIRED COMPONENTS Interpreter)
    math(EXPR next "${Python_VERSION_MINOR} + 1")
    string(APPEND CPACK_DEBIAN_STRIDOR_PACKAGE_DEPENDS ", python3-numpy, \
python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next})")
    string(APPEND CPACK_DEBIAN_STRIDOR_PACKAGE_RECOMMENDS ", python3-matplotlib, python3-netcdf4, python3-xarray")
    set(CPACK_DEBIAN_STRIDOR_PACKAGE_CONTROL_EXTRA
        "${PROJECT_SOURCE_DIR}/cmake/debian/postinst;${PROJECT_SOURCE_DIR}/cmake/debian/prerm")
    set(CPACK_DEBIAN_STRIDOR_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endif()

if(TARGET stridor-mpi)
    list(APPEND CPACK_COMPONENTS_ALL mpi)
    set(CPACK_COMPONENT_MPI_GROUP mpi)
    set(CPACK_COMPONENT_GROUP_MPI_DESCRIPTION "The program for charts on a cluster, by MPI.")
    set(CPACK_DEBIAN_MPI_PACKAGE_NAME stridor-mpi)
    set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "stridor (= ${PROJECT_VERSION})")
    set(CPACK_DEBIAN_MPI_PACKAGE_RECOMMENDS openmpi-bin)
endif()

include(CPack)
