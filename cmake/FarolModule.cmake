# farol_add_module(NAME <folder> [LAYER core|ui] SOURCES ... [DEPENDS modules...] [LINK libraries...] [PCH headers...])
#
# One static library per folder. DEPENDS are the arrows of the design (CONTRIBUTING.md, "Layers"); the test
# house/layers reads the #include lines and fails the build where a file reaches over them.
include_guard()

add_library(farol_options INTERFACE)
target_include_directories(farol_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(farol_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports maybe-uninitialized and the like inside its own optimised std::optional and std::variant.
  target_compile_options(farol_options INTERFACE -Wno-maybe-uninitialized -Wno-restrict)
endif()
if(FAROL_SANITIZE)
  target_compile_options(farol_options INTERFACE -fsanitize=${FAROL_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=all)
  target_link_options(farol_options INTERFACE -fsanitize=${FAROL_SANITIZE})
endif()

function(farol_add_module)
  cmake_parse_arguments(ARG "" "NAME;LAYER" "SOURCES;DEPENDS;LINK;PCH" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "farol_add_module(${ARG_NAME}): unknown words ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  set(target farol_${ARG_NAME})
  add_library(${target} STATIC ${ARG_SOURCES})
  target_link_libraries(${target} PUBLIC farol_options)
  foreach(module IN LISTS ARG_DEPENDS)
    target_link_libraries(${target} PUBLIC farol_${module})
  endforeach()
  target_link_libraries(${target} PUBLIC ${ARG_LINK})
  if(ARG_PCH)
    target_precompile_headers(${target} PRIVATE ${ARG_PCH})
  endif()
  if(ARG_LAYER STREQUAL "ui")
    set_target_properties(${target} PROPERTIES AUTOMOC ON AUTORCC ON)
    target_compile_definitions(${target} PRIVATE QT_NO_CAST_FROM_ASCII QT_NO_KEYWORDS QT_NO_FOREACH)
  endif()
endfunction()
