#include "core/routing/route.h"
