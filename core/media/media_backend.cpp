// SPDX-License-Identifier: Apache-2.0
#include "core/media/media_backend.h"

#include <dlfcn.h>

#include "core/job/own_folder.h"

namespace noctule {

Result<const MediaBackend*> mediaBackend() {
    static void* const module = dlopen(helperPath(kMediaModule).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module)
        return Error{
            ErrorKind::kInternal,
            helperPath(kMediaModule) + ", which reads and writes pictures and films, cannot be loaded",
            "Install the program again; this file belongs beside it"};
    const auto backend = reinterpret_cast<const MediaBackend* (*)()>(dlsym(module, kMediaBackend));
    require(backend, "the module of pictures and films has a backend");
    return backend();
}

}  // namespace noctule
