#include "core/building/checks.h"
