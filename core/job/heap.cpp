// SPDX-License-Identifier: Apache-2.0
#include "core/job/heap.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace noctule {

void shareHeaps() {
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 2);
#endif
}

}  // namespace noctule
