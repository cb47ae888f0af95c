#include "core/recognition/training.h"
