# Does check_layers.cmake see what it should?  cmake -D SCRATCH=<folder to use> -P check_layers_test.cmake
# Builds small trees, each with one fault, and expects the fault to be named; and one without any, which must pass.
cmake_minimum_required(VERSION 3.25)

function(clean_tree)
  file(REMOVE_RECURSE "${SCRATCH}")
  file(WRITE "${SCRATCH}/geometry/CMakeLists.txt" "rinceau_library(geometry SOURCES point.h box.h kd_tree.cpp)\n")
  file(WRITE "${SCRATCH}/geometry/point.h" "#include <cmath>\n")
  file(WRITE "${SCRATCH}/geometry/box.h" "#include \"geometry/point.h\"\nstruct Box {\n")
  file(WRITE "${SCRATCH}/geometry/kd_tree.cpp" "#include <nanoflann.hpp>\n")
  file(WRITE "${SCRATCH}/scene/CMakeLists.txt" "# late.h is listed below\nrinceau_library(scene SOURCES early.h svg_read.cpp late.h)\n")
  file(WRITE "${SCRATCH}/scene/early.h" "#include \"geometry/box.h\"\n")
  file(WRITE "${SCRATCH}/scene/svg_read.cpp" "#include <tinyxml2.h>\n#include \"scene/early.h\"\n")
  file(WRITE "${SCRATCH}/scene/late.h" "")
  file(WRITE "${SCRATCH}/tests/scene/read_test.cpp" "#include <catch2/catch.hpp>\n")
endfunction()

macro(run_check)
  execute_process(COMMAND "${CMAKE_COMMAND}" -D "ROOT=${SCRATCH}" -P "${CMAKE_CURRENT_LIST_DIR}/check_layers.cmake"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
endmacro()

function(expect_fault file text message)
  clean_tree()
  file(APPEND "${SCRATCH}/${file}" "${text}")
  run_check()
  # CMake breaks long messages into lines.
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  string(FIND "${output}" "${file}: ${message}" found)
  if(result EQUAL 0 OR found LESS 0)
    message(SEND_ERROR "'${text}' in ${file}: expected '${message}', got ${result}: ${output}")
  endif()
endfunction()

clean_tree()
run_check()
if(NOT result EQUAL 0)
  message(SEND_ERROR "A good tree was refused: ${output}")
endif()

expect_fault(geometry/box.h "#include \"scene/early.h\"\n" "includes scene/early.h, but geometry does not use scene")
expect_fault(scene/early.h "  #  include <tinyxml2.h>\n" "includes tinyxml2.h, which belongs elsewhere")
expect_fault(geometry/point.h "#include <nanoflann.hpp>\n" "includes nanoflann.hpp, which belongs elsewhere")
expect_fault(scene/late.h "#include <librsvg/rsvg.h>\n" "includes librsvg/rsvg.h, which belongs elsewhere")
expect_fault(scene/late.h "#include <CLI/CLI.hpp>\n" "includes CLI/CLI.hpp, which belongs elsewhere")
expect_fault(scene/late.h "#include <catch2/catch.hpp>\n" "includes catch2/catch.hpp, which belongs elsewhere")
expect_fault(tests/scene/read_test.cpp "#include <GLFW/glfw3.h>\n" "includes GLFW/glfw3.h, which belongs elsewhere")
expect_fault(scene/early.h "#include \"scene/late.h\"\n" "includes scene/late.h, which scene/CMakeLists.txt lists later")
expect_fault(scene/early.h "struct Box {\n" "defines Box, which geometry/box.h defines, too")
expect_fault(scene/forgotten.cpp "\n" "is not listed in scene/CMakeLists.txt")
string(REPEAT "\n" 501 long)
expect_fault(scene/late.h "${long}" "has 501 lines, more than 500")

file(REMOVE_RECURSE "${SCRATCH}")
