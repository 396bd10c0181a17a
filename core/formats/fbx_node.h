// SPDX-License-Identifier: Apache-2.0
// The container of binary FBX 7.4: a tree of named records, each with a list of typed properties and further
// records. Little-endian, offsets of 32 bits, arrays not compressed. What the records mean: fbx_writer.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/job/result.h"

namespace noctule {

/// Bytes without a meaning of their own.
struct FbxBytes {
    std::string bytes;
};

class FbxNode {
public:
    /// A record and its properties, in order: bool C, int32_t I, int64_t L, double D, std::string S, FbxBytes
    /// R, vectors i, l, f, d.
    template <class... Properties>
    explicit FbxNode(std::string name, const Properties&... properties) : name_(std::move(name)) {
        (put(properties), ...);
    }

    /// Appends a record within this one; returns this one.
    FbxNode& add(FbxNode child);
    const std::vector<FbxNode>& children() const { return children_; }

    /// Bytes that it takes in a file.
    size_t size() const;
    /// To the end of a file whose beginning stands in `file` (offsets count from there). What has been
    /// written is given back at once, so that no two copies of a large file stand in memory.
    void moveTo(std::string& file) &&;

private:
    bool isList() const { return !children_.empty() || property_count_ == 0; }
    void put(bool value);
    void put(int32_t value);
    void put(int64_t value);
    void put(double value);
    void put(const std::string& text);
    void put(const char* text) { put(std::string(text)); }
    void put(const FbxBytes& bytes);
    void put(const std::vector<int32_t>& values);
    void put(const std::vector<int64_t>& values);
    void put(const std::vector<float>& values);
    void put(const std::vector<double>& values);

    std::string name_;
    uint32_t property_count_ = 0;
    std::string properties_;  ///< as they stand in the file
    std::vector<FbxNode> children_;
};

/// FileId and CreationTime, which every file has at its top.
std::vector<FbxNode> fbxFileIdentity();

/// A whole file. kUnusable when it would grow beyond the 4 GiB that the format can address; `where` names it.
Result<std::string> fbxFile(std::vector<FbxNode> top, const std::string& where);

/// "Hips" of class "Model" as binary files spell it.
std::string fbxObjectName(const std::string& name, const std::string& of_class);

}  // namespace noctule
