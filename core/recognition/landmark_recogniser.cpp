#include "core/recognition/landmark_recogniser.h"
