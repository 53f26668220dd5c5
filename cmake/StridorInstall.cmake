# Libraries, headers, program and data under an install prefix; find_package(stridor) works from there.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/stridor")

get_property(modules GLOBAL PROPERTY STRIDOR_MODULE_TARGETS)
foreach(target IN LISTS modules)
    install(TARGETS ${target} EXPORT stridorTargets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
        FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        FILE_SET alone DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
endforeach()
install(TARGETS stridor_all EXPORT stridorTargets)
install(EXPORT stridorTargets NAMESPACE stridor:: DESTINATION "${package_dir}")

configure_package_config_file(
    "${PROJECT_SOURCE_DIR}/cmake/stridorConfig.cmake.in" "${PROJECT_BINARY_DIR}/generated/stridorConfig.cmake"
    INSTALL_DESTINATION "${package_dir}"
    NO_SET_AND_CHECK_MACRO)
# before 1.0 a minor version may break its users
write_basic_package_version_file(
    "${PROJECT_BINARY_DIR}/generated/stridorConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
    "${PROJECT_BINARY_DIR}/generated/stridorConfig.cmake"
    "${PROJECT_BINARY_DIR}/generated/stridorConfigVersion.cmake"
    DESTINATION "${package_dir}")

get_property(programs GLOBAL PROPERTY STRIDOR_PROGRAM_TARGETS)
foreach(program IN LISTS programs)
    if(program STREQUAL "stridor-mpi")
        # its package needs MPI, that of the others does not
        install(TARGETS ${program} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT mpi)
    else()
        install(TARGETS ${program} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
    endif()
endforeach()

# all that is installed, and nothing that is not
add_custom_target(installed DEPENDS ${modules} ${programs})
if(STRIDOR_HAS_PYTHON)
    add_dependencies(installed stridor_python)
endif()

# Data that a fresh tree may not have yet.
function(stridor_install_file path folder name)
    if(EXISTS "${PROJECT_SOURCE_DIR}/${path}")
        install(FILES "${PROJECT_SOURCE_DIR}/${path}" DESTINATION "${folder}" RENAME "${name}")
    endif()
endfunction()

stridor_install_file(LICENSE "${CMAKE_INSTALL_DOCDIR}" LICENSE)
stridor_install_file(README.md "${CMAKE_INSTALL_DOCDIR}" README.md)
stridor_install_file(CHANGELOG.md "${CMAKE_INSTALL_DOCDIR}" CHANGELOG.md)
stridor_install_file(KNOWN_ISSUES.md "${CMAKE_INSTALL_DOCDIR}" KNOWN_ISSUES.md)
if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/docs")
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
endif()
if(TARGET stridor-mpi)
    install(FILES "${PROJECT_SOURCE_DIR}/man/stridor-mpi.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT mpi)
endif()
# The program writes its page (apps/stridor).
function(stridor_install_page page folder name)
    install(FILES "${page}" DESTINATION "${folder}" RENAME "${name}")
endfunction()

set(completions "${PROJECT_SOURCE_DIR}/completions")
stridor_install_page("${PROJECT_BINARY_DIR}/generated/stridor.1" "${CMAKE_INSTALL_MANDIR}/man1" stridor.1)
stridor_install_page("${completions}/stridor.bash" "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" stridor)
stridor_install_page("${completions}/stridor.zsh" "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" _stridor)
stridor_install_page("${completions}/stridor.fish" "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" stridor.fish)
if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/cases")
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/cases/" DESTINATION "${CMAKE_INSTALL_DATADIR}/stridor/cases")
endif()
# the page in one file, where ./dev page has built it
install(FILES "${PROJECT_BINARY_DIR}/page/page.html" DESTINATION "${CMAKE_INSTALL_DATADIR}/stridor" OPTIONAL)
