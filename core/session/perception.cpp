#include "core/session/perception.h"
