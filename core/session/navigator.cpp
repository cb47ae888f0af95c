#include "core/session/navigator.h"
