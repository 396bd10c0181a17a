// SPDX-License-Identifier: Apache-2.0
#include "core/job/own_folder.h"

#include <filesystem>

namespace noctule {

std::string besideThisProgram(const std::string& name) {
    std::error_code ignored;
    return (std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / name).string();
}

}  // namespace noctule
