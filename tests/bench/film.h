#pragma once
// `farol-bench --film`: a film of 30 frames a second from pictures that were taken far apart.

#include <string>

namespace farol::bench {

struct FilmOptions {
    std::string frames, file; ///< a folder of pictures or a video; the film (.avi)
    double secondsEach = 1.0;
    int count = 0; ///< pictures; 0: all
};

/// Each picture is walked towards for a while, with the sway and the turn of a camera on somebody's chest;
/// then comes the next. Answers the exit code.
int makeFilm(const FilmOptions& options);

} // namespace farol::bench
