#include "core/guidance/cue_scheduler.h"
