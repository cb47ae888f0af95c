#include "core/building/info.h"
