#pragma once
// Large libraries: how long one takes to open, and to follow when a template is added or taken out.

#include <vector>

namespace farol::bench {

/// Prints a table with one row for each number of templates, all of them made up: one view with 300 features
/// each, a photograph of next to nothing.
int benchLibraries(const std::vector<int>& templates);

} // namespace farol::bench
