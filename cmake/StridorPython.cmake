# The Python package: is there what it needs, and with which interpreter?

set(STRIDOR_PYTHON AUTO CACHE STRING "Build the Python package: AUTO where what it needs is found, ON or OFF")
set_property(CACHE STRIDOR_PYTHON PROPERTY STRINGS AUTO ON OFF)

# Does an interpreter have the headers it is extended with, and NumPy?
function(stridor_fits_python file result)
    execute_process(
        COMMAND "${file}" -c "import numpy, sysconfig, os; \
assert os.path.exists(os.path.join(sysconfig.get_path('include'), 'Python.h'))"
        RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
    if(code EQUAL 0)
        set(${result} TRUE PARENT_SCOPE)
    else()
        set(${result} FALSE PARENT_SCOPE)
    endif()
endfunction()

# Sets Python_EXECUTABLE, unless it is given, to the first interpreter that fits: the first python3 in the PATH often
# has no NumPy, and is not the one that Debian's packages are for.
function(stridor_find_python)
    if(Python_EXECUTABLE)
        return()
    endif()
    find_program(first NAMES python3 NO_CACHE)
    foreach(file IN ITEMS "${first}" /usr/bin/python3 /usr/local/bin/python3)
        if(file AND EXISTS "${file}")
            stridor_fits_python("${file}" fits)
            if(fits)
                set(Python_EXECUTABLE "${file}" CACHE FILEPATH "The interpreter of the Python package; it has NumPy")
                return()
            endif()
        endif()
    endforeach()
endfunction()

# Sets RESULT to what is missing, as a sentence; empty where nothing is.
function(stridor_missing_for_python result)
    stridor_find_python()
    set(missing "")
    if(NOT Python_EXECUTABLE)
        set(missing "no Python interpreter has NumPy and headers (Debian: python3-numpy python3-dev)")
    else()
        stridor_fits_python("${Python_EXECUTABLE}" fits)
        if(NOT fits)
            set(missing "${Python_EXECUTABLE} lacks NumPy or headers (Debian: python3-numpy python3-dev)")
        endif()
    endif()
    if(NOT missing)
        # pybind11 would look for an interpreter of its own
        find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
        set(PYBIND11_FINDPYTHON ON)
        find_package(pybind11 2.10 QUIET CONFIG)
        if(NOT Python_FOUND)
            set(missing "${Python_EXECUTABLE} is older than 3.9, or has no headers (Debian: python3-dev)")
        elseif(NOT pybind11_FOUND)
            set(missing "pybind11 is not found (Debian: pybind11-dev)")
        endif()
    endif()
    set(${result} "${missing}" PARENT_SCOPE)
endfunction()

# Decides, once for a configuration: STRIDOR_HAS_PYTHON.
set(STRIDOR_HAS_PYTHON FALSE)
if(NOT STRIDOR_PYTHON STREQUAL "OFF" AND PROJECT_IS_TOP_LEVEL AND NOT STRIDOR_SANITIZED)
    stridor_missing_for_python(missing)
    if(NOT missing)
        set(STRIDOR_HAS_PYTHON TRUE)
    elseif(STRIDOR_PYTHON STREQUAL "ON")
        message(FATAL_ERROR "The Python package cannot be built: ${missing}. Install it, or use -DSTRIDOR_PYTHON=OFF?")
    else()
        message(STATUS "No Python package: ${missing}")
    endif()
endif()
