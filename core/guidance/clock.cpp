#include "core/guidance/clock.h"
