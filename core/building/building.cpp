#include "core/building/building.h"
