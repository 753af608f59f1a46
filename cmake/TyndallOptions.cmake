# Language, warnings, sanitizers, output places, compiler cache.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

option(TYNDALL_BUILD_EDITOR "Build tyndall-editor (needs GLFW and Dear ImGui)" ON)
option(TYNDALL_BUILD_TESTS "Build the test programs" ON)
option(TYNDALL_SANITIZE "AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(TYNDALL_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "" FORCE)
endif()
# RelWithDebInfo keeps asserts out but optimises fully; line tables make crash reports readable.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -DNDEBUG")
set(CMAKE_C_FLAGS_RELWITHDEBINFO "-O2 -g1 -DNDEBUG")

# Programs, plugins, shaders and sample levels land in one tree that can be moved as a whole.
set(TYNDALL_BIN_DIR ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${TYNDALL_BIN_DIR})

find_program(TYNDALL_CCACHE ccache)
if(TYNDALL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_C_COMPILER_LAUNCHER ${TYNDALL_CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${TYNDALL_CCACHE})
endif()

# Target that carries the project's own warning flags; third-party sources do not link it.
add_library(tyndall_flags INTERFACE)
target_compile_options(tyndall_flags INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
  -Wno-missing-field-initializers $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>)
if(TYNDALL_WARNINGS_AS_ERRORS)
  target_compile_options(tyndall_flags INTERFACE -Werror)
endif()
if(TYNDALL_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=address,undefined)
endif()
