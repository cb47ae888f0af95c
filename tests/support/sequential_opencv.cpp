// Linked into the tests of the tsan preset only. Debian's OpenCV and TBB are not instrumented, so
// ThreadSanitizer takes their own hand-overs between their own worker threads for races. Without those
// workers only our threads are left.

#include <opencv2/core.hpp>

namespace {

[[maybe_unused]] const bool kSequential = [] {
    cv::setNumThreads(1);
    return true;
}();

} // namespace
