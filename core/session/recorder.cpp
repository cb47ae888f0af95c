#include "core/session/recorder.h"
