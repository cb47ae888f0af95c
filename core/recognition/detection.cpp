#include "core/recognition/detection.h"
