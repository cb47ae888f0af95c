#include "core/recognition/door_detector.h"
