#include "core/recognition/feature_extractor.h"
