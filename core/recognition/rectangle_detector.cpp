#include "core/recognition/rectangle_detector.h"
