// SPDX-License-Identifier: Apache-2.0
#include "core/job/unnamed_file.h"

#include <stdlib.h>
#include <unistd.h>

namespace noctule {

Result<UnnamedFile> UnnamedFile::make(const std::filesystem::path& folder, const std::string& what,
                                      const std::string& remedy) {
    std::string name = (folder / ".noctule-XXXXXX").string();
    const int descriptor = mkstemp(name.data());
    std::FILE* file = descriptor < 0 ? nullptr : fdopen(descriptor, "w+b");
    if (descriptor >= 0)
        unlink(name.c_str());
    if (!file) {
        if (descriptor >= 0)
            close(descriptor);
        return Error{ErrorKind::kDisk, folder.string() + ": " + what + " cannot be kept there", remedy};
    }
    return UnnamedFile(file);
}

void UnnamedFile::putBytes(const void* bytes, size_t size) {
    failed_ = failed_ || (size > 0 && std::fwrite(bytes, size, 1, file_.get()) != 1);
}

bool UnnamedFile::takeBytes(void* bytes, size_t size) {
    return size == 0 || std::fread(bytes, size, 1, file_.get()) == 1;
}

int64_t UnnamedFile::position() const {
    return ftello(file_.get());
}

void UnnamedFile::seek(int64_t position) {
    failed_ = failed_ || fseeko(file_.get(), position, SEEK_SET) != 0;
}

bool UnnamedFile::good() {
    return !failed_ && std::fflush(file_.get()) == 0 && !std::ferror(file_.get());
}

}  // namespace noctule
