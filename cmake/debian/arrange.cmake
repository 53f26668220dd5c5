# What CMake installed, moved to where Debian wants it; CPack runs this before it packs.
set(usr "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/stridor/usr")

# Debian's interpreter looks there and not into site-packages
file(GLOB folder "${usr}/lib/python3*/site-packages")
if(folder)
    file(MAKE_DIRECTORY "${usr}/lib/python3")
    file(RENAME "${folder}" "${usr}/lib/python3/dist-packages")
    cmake_path(GET folder PARENT_PATH folder)
    file(REMOVE_RECURSE "${folder}")
endif()

file(RENAME "${usr}/share/doc/stridor/LICENSE" "${usr}/share/doc/stridor/copyright")

file(RENAME "${usr}/share/zsh/site-functions" "${usr}/share/zsh/vendor-completions")

foreach(file IN ITEMS share/man/man1/stridor.1 share/doc/stridor/CHANGELOG.md)
    execute_process(COMMAND gzip -9n "${usr}/${file}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# the package of what needs MPI
file(GLOB mpi "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/mpi/usr")
if(mpi)
    file(MAKE_DIRECTORY "${mpi}/share/doc/stridor-mpi")
    file(COPY "${usr}/share/doc/stridor/copyright" DESTINATION "${mpi}/share/doc/stridor-mpi")
endif()
