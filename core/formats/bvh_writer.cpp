// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/formats/bvh.h"
#include "core/formats/bvh_words.h"
#include "core/formats/number_text.h"
#include "core/job/atomic_file.h"

namespace noctule {
namespace {

/// Beside gimbal lock the errors of two angles add up; seven decimals keep the rotation within 1e-6 degrees.
constexpr int kLengthDecimals = 8, kAngleDecimals = 7;

int decimalsOf(BvhChannel channel) {
    return isRotation(channel) ? kAngleDecimals : kLengthDecimals;
}

void appendOffset(std::string& text, const std::string& indent, const Vector3d& v) {
    text += indent + "OFFSET";
    for (int axis = 0; axis < 3; ++axis) {
        text += ' ';
        appendFixed(text, v[axis], kLengthDecimals);
    }
    text += '\n';
}

void appendJoint(std::string& text, const BvhJoint& joint, const std::string& indent) {
    text += indent + (joint.parent < 0 ? "ROOT " : "JOINT ") + joint.name + "\n" + indent + "{\n";
    const std::string inner = indent + "\t";
    appendOffset(text, inner, joint.offset);
    text += inner + "CHANNELS " + std::to_string(joint.channels.size());
    for (const BvhChannel channel : joint.channels)
        text += " " + toText(channel);
    text += "\n";
    if (joint.end_site) {
        text += inner + "End Site\n" + inner + "{\n";
        appendOffset(text, inner + "\t", *joint.end_site);
        text += inner + "}\n";
    }
}

/// Every joint first closes the braces of those that are not among its ancestors.
void appendHierarchy(std::string& text, const std::vector<BvhJoint>& joints) {
    std::vector<int> open;
    const auto closeDownTo = [&](int parent) {
        while (!open.empty() && open.back() != parent) {
            open.pop_back();
            text += std::string(open.size(), '\t') + "}\n";
        }
    };
    text += "HIERARCHY\n";
    for (size_t j = 0; j < joints.size(); ++j) {
        closeDownTo(joints[j].parent);
        appendJoint(text, joints[j], std::string(open.size(), '\t'));
        open.push_back(static_cast<int>(j));
    }
    closeDownTo(-1);
}

void appendMotion(std::string& text, const BvhDocument& document) {
    std::vector<int> decimals;
    for (const BvhJoint& joint : document.joints)
        for (const BvhChannel channel : joint.channels)
            decimals.push_back(decimalsOf(channel));
    text += "MOTION\nFrames: " + std::to_string(document.frameCount()) + "\nFrame Time: ";
    appendExact(text, document.frame_time_s);
    text += "\n";
    for (size_t v = 0; v < document.values.size(); ++v) {
        const size_t channel = v % document.channel_count;
        appendFixed(text, document.values[v], decimals[channel]);
        text += channel + 1 == document.channel_count ? '\n' : ' ';
    }
}

bool sameNumber(double a, double b, int decimals) {
    return std::abs(a - b) <= 0.5001 * std::pow(10, -decimals) + 1e-15 * std::abs(a);
}

bool sameVector(const Vector3d& a, const Vector3d& b) {
    return sameNumber(a.x(), b.x(), kLengthDecimals) && sameNumber(a.y(), b.y(), kLengthDecimals) &&
           sameNumber(a.z(), b.z(), kLengthDecimals);
}

bool sameJoint(const BvhJoint& a, const BvhJoint& b) {
    return a.name == b.name && a.parent == b.parent && a.channels == b.channels &&
           a.first_channel == b.first_channel && sameVector(a.offset, b.offset) &&
           a.end_site.has_value() == b.end_site.has_value() &&
           (!a.end_site || sameVector(*a.end_site, *b.end_site));
}

bool sameDocument(const BvhDocument& a, const BvhDocument& b) {
    if (a.frame_time_s != b.frame_time_s || a.values.size() != b.values.size() ||
        !std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(), sameJoint))
        return false;
    for (const BvhJoint& joint : a.joints)
        for (size_t n = 0; n < joint.channels.size(); ++n)
            for (size_t v = joint.first_channel + n; v < a.values.size(); v += a.channel_count)
                if (!sameNumber(a.values[v], b.values[v], decimalsOf(joint.channels[n])))
                    return false;
    return true;
}

}  // namespace

std::string formatBvh(const BvhDocument& document) {
    std::string text;
    text.reserve(document.values.size() * 12 + document.joints.size() * 200);
    appendHierarchy(text, document.joints);
    appendMotion(text, document);
    return text;
}

Status writeBvh(const std::string& path, const BvhDocument& document, bool overwrite) {
    return writeFileAtomically(path, formatBvh(document), overwrite,
                               [&](const std::string& aside_path) -> Status {
                                   const Result<BvhDocument> read_back = readBvh(aside_path);
                                   if (read_back && sameDocument(document, *read_back))
                                       return Done{};
                                   return Error{ErrorKind::kDisk,
                                                path + ": what was written does not read back the same" +
                                                    (read_back ? "" : " (" + read_back.error().message + ")"),
                                                "Check the disk and try again"};
                               });
}

Status writeBvh(const std::string& path, const MotionClip& clip, const BvhOptions& options, bool overwrite) {
    if (Status free = checkOutputPath(path, overwrite); !free)
        return free;
    const Result<BvhDocument> document = toDocument(clip, options);
    return document ? writeBvh(path, *document, overwrite) : Status(document.error());
}

}  // namespace noctule
