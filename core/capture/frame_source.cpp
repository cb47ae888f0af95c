#include "core/capture/frame_source.h"
