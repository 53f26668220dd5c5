# Toolchain of explorer/core: clang 19 for WebAssembly with the C library of WASI, as Debian 12 packages them.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# nothing is tried: a module has no main(), and these packages no archiver
set(CMAKE_CXX_COMPILER_WORKS ON)
set(CMAKE_CXX_ABI_COMPILED ON)
set(CMAKE_SIZEOF_VOID_P 4)

set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fwasm-exceptions")
