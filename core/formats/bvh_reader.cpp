// SPDX-License-Identifier: Apache-2.0
#include "core/formats/bvh_reader.h"

#include <filesystem>

#include "core/formats/number_text.h"
#include "core/formats/text_file.h"

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
    if (const std::optional<std::string> decoded = fromUtf16(text))
        return BvhReader(*decoded, where).read();
    return BvhReader(withoutByteOrderMark(text), where).read();
}

std::string toText(const BvhWarning& warning) {
    return (warning.line ? "line " + std::to_string(warning.line) + ": " : "") + warning.text;
}

Result<BvhDocument> readBvh(const std::string& path, const CancelFlag* cancel) {
    const Result<std::string> text = readTextFile(path, cancel);
    if (!text)
        return text.error();
    Result<BvhDocument> document = parseBvh(*text, path);
    if (document)
        document->name = std::filesystem::path(path).stem().string();
    return document;
}

}  // namespace noctule
