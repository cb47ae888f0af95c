#include "core/recognition/sharpness.h"
