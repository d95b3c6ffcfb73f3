#pragma once
/// The carrier of levels lives with the haptics, whose USB drivers hand readings over with it too.
#include "haptics/carriers/triple_buffer.h"

namespace halsted::app {
using halsted::TripleBuffer;
}  // namespace halsted::app
