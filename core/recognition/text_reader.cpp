#include "core/recognition/text_reader.h"
