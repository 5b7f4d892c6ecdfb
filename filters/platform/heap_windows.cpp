// See heap.h. Large pages of Windows need a privilege that users do not have.
#include "filters/platform/heap.h"

namespace boxprobe {

void useLargePages() {}

}  // namespace boxprobe
