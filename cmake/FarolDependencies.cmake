# Every outside library, found in one place. Debian 12 has them all; see the package list in ./dev.
find_package(Threads REQUIRED)
# Named components only: Debian's highgui pulls in Qt 5.
find_package(OpenCV REQUIRED COMPONENTS core imgproc features2d flann calib3d imgcodecs videoio video dnn)
find_package(GDAL CONFIG REQUIRED)
find_package(EXPAT REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
# libtesseract-dev ships no CMake configuration.
pkg_check_modules(TESSERACT REQUIRED IMPORTED_TARGET tesseract lept)

# One interface target for OpenCV: its headers warn under C++20, so they enter as system headers.
add_library(farol_opencv INTERFACE)
target_include_directories(farol_opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
target_link_libraries(farol_opencv INTERFACE ${OpenCV_LIBS})

# Rays of the simulated camera.
find_package(embree 3 REQUIRED)
# Letters of signs in the simulated world, and of those that farol-cli evaluate and the tests draw.
find_library(OPENCV_FREETYPE opencv_freetype REQUIRED)
pkg_check_modules(FONTCONFIG REQUIRED IMPORTED_TARGET fontconfig)

if(FAROL_BUILD_UI)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets TextToSpeech Multimedia LinguistTools Svg)
  find_package(CLI11 REQUIRED)
  pkg_check_modules(ESPEAK_NG REQUIRED IMPORTED_TARGET espeak-ng)
endif()
if(FAROL_BUILD_TESTS)
  find_package(GTest REQUIRED)
  if(FAROL_BUILD_UI)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Test)
  endif()
endif()
if(FAROL_BUILD_BENCH)
  find_package(benchmark REQUIRED)
endif()
