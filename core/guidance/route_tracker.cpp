#include "core/guidance/route_tracker.h"
