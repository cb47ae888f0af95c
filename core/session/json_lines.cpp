#include "core/session/json_lines.h"
