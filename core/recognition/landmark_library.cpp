#include "core/recognition/landmark_library.h"
