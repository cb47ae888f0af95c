#include "core/guidance/cue.h"
