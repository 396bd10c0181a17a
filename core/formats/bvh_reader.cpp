// SPDX-License-Identifier: Apache-2.0
#include "core/formats/bvh_reader.h"

#include <filesystem>

#include "core/formats/number_text.h"
#include "core/job/atomic_file.h"

namespace noctule {

Result<BvhDocument> BvhReader::read() {
    for (const auto step : {&BvhReader::readHierarchy, &BvhReader::readMotionHeader, &BvhReader::readRows})
        if (Status done = (this->*step)(); !done)
            return done.error();
    return std::move(document_);
}

Error BvhReader::errorAt(size_t line, const std::string& what, const std::string& remedy) const {
    return {ErrorKind::kUnreadable, where_ + ", line " + std::to_string(line) + ": " + what, remedy};
}

Status BvhReader::expect(std::string_view expected) {
    const std::string_view found = scan_.word();
    if (sameWord(found, expected))
        return Done{};
    if (found.empty())
        return error("the file ends where " + std::string(expected) + " should follow", kExportAgain);
    return error(inQuotes(found) + " where " + std::string(expected) + " should stand",
                 "Check that this is a BVH file and that no space is missing here");
}

Result<BvhDocument> parseBvh(std::string_view text, const std::string& where) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return Error{ErrorKind::kUnreadable, where + ", line 1: the text is UTF-16", "Save it as UTF-8"};
    return BvhReader(text, where).read();
}

Result<BvhDocument> readBvh(const std::string& path) {
    const Result<std::string> text = readWholeFile(path);
    if (!text)
        return text.error();
    Result<BvhDocument> document = parseBvh(*text, path);
    if (document)
        document->name = std::filesystem::path(path).stem().string();
    return document;
}

}  // namespace noctule
