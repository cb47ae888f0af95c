#pragma once
// The trained classifiers that the build compiles in (resources/models). Only this folder includes it.

#include <string_view>

namespace farol::recognition {

std::string_view doorTrees();
/// An ONNX file.
std::string_view signNetwork();

} // namespace farol::recognition
