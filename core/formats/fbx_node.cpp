// SPDX-License-Identifier: Apache-2.0
#include "core/formats/fbx_node.h"

#include <bit>
#include <cstring>
#include <limits>
#include <string_view>

namespace noctule {
namespace {

static_assert(std::endian::native == std::endian::little, "FBX is little-endian");

constexpr uint32_t kFbxVersion = 7400;
constexpr size_t kNullRecord = 13;  ///< closes a list of records; every record begins with as many bytes
constexpr size_t kMostFoot = 176;   ///< what stands behind the last record

/// Readers of the format's owner look for these constants.
constexpr std::string_view kMagic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr std::string_view kFileId("\x28\xb3\x2a\xeb\xb6\x24\xcc\xc2\xbf\xc8\xb0\x2a\xa9\x2b\xfc\xf1", 16);
constexpr std::string_view kFootId("\xfa\xbc\xab\x09\xd0\xc8\xd4\x66\xb1\x76\xfb\x83\x1c\xf7\x26\x7e", 16);
constexpr std::string_view kFootMagic("\xf8\x5a\x8c\x6a\xde\xf5\xd9\x7e\xec\xe9\x0c\xe3\x75\x8f\x29\x0b", 16);
/// What the file's id was made from; the two belong together.
constexpr const char* kCreationTime = "1970-01-01 10:00:00:000";

template <class T>
void appendRaw(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
void appendArray(std::string& bytes, char type, const std::vector<T>& values) {
    const size_t length = values.size() * sizeof(T);
    bytes += type;
    appendRaw(bytes, static_cast<uint32_t>(values.size()));
    appendRaw(bytes, uint32_t{0});  // not compressed
    appendRaw(bytes, static_cast<uint32_t>(length));
    bytes.append(reinterpret_cast<const char*>(values.data()), length);
}

void appendRawText(std::string& bytes, char type, std::string_view text) {
    bytes += type;
    appendRaw(bytes, static_cast<uint32_t>(text.size()));
    bytes += text;
}

void appendFoot(std::string& file) {
    file += kFootId;
    file.append(4, '\0');
    file.append(16 - file.size() % 16, '\0');
    appendRaw(file, kFbxVersion);
    file.append(120, '\0');
    file += kFootMagic;
}

}  // namespace

FbxNode& FbxNode::add(FbxNode child) {
    children_.push_back(std::move(child));
    return *this;
}

void FbxNode::put(bool value) {
    ++property_count_;
    properties_ += 'C';
    properties_ += value ? '\1' : '\0';
}

void FbxNode::put(int32_t value) {
    ++property_count_;
    properties_ += 'I';
    appendRaw(properties_, value);
}

void FbxNode::put(int64_t value) {
    ++property_count_;
    properties_ += 'L';
    appendRaw(properties_, value);
}

void FbxNode::put(double value) {
    ++property_count_;
    properties_ += 'D';
    appendRaw(properties_, value);
}

void FbxNode::put(const std::string& text) {
    ++property_count_;
    appendRawText(properties_, 'S', text);
}

void FbxNode::put(const FbxBytes& bytes) {
    ++property_count_;
    appendRawText(properties_, 'R', bytes.bytes);
}

void FbxNode::put(const std::vector<int32_t>& values) {
    ++property_count_;
    appendArray(properties_, 'i', values);
}

void FbxNode::put(const std::vector<int64_t>& values) {
    ++property_count_;
    appendArray(properties_, 'l', values);
}

void FbxNode::put(const std::vector<float>& values) {
    ++property_count_;
    appendArray(properties_, 'f', values);
}

void FbxNode::put(const std::vector<double>& values) {
    ++property_count_;
    appendArray(properties_, 'd', values);
}

size_t FbxNode::size() const {
    size_t size = kNullRecord + name_.size() + properties_.size() + (isList() ? kNullRecord : 0);
    for (const FbxNode& child : children_)
        size += child.size();
    return size;
}

void FbxNode::moveTo(std::string& file) && {
    appendRaw(file, static_cast<uint32_t>(file.size() + size()));  // where the record ends
    appendRaw(file, property_count_);
    appendRaw(file, static_cast<uint32_t>(properties_.size()));
    file += static_cast<char>(name_.size());
    file += name_;
    file += properties_;
    const bool is_list = isList();
    properties_ = {};
    for (FbxNode& child : children_) {
        std::move(child).moveTo(file);
        child.children_ = {};
    }
    if (is_list)
        file.append(kNullRecord, '\0');
}

Result<std::string> fbxFile(std::vector<FbxNode> top, const std::string& where) {
    size_t size = kMagic.size() + sizeof kFbxVersion + kNullRecord + kMostFoot;
    for (const FbxNode& node : top)
        size += node.size();
    if (size > std::numeric_limits<uint32_t>::max())
        return Error{ErrorKind::kUnusable, where + ": the motion is too long for one FBX file",
                     "Export it in parts, or at fewer frames per second"};
    std::string file;
    file.reserve(size);
    file += kMagic;
    appendRaw(file, kFbxVersion);
    for (FbxNode& node : top)
        std::move(node).moveTo(file);
    file.append(kNullRecord, '\0');
    appendFoot(file);
    return file;
}

std::string fbxObjectName(const std::string& name, const std::string& of_class) {
    return name + std::string("\0\1", 2) + of_class;
}

std::vector<FbxNode> fbxFileIdentity() {
    return {FbxNode("FileId", FbxBytes{std::string(kFileId)}), FbxNode("CreationTime", kCreationTime)};
}

}  // namespace noctule
