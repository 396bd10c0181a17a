// SPDX-License-Identifier: Apache-2.0
// BVH (Biovision hierarchy): a tree of joints with offsets and channels, then one row of numbers per frame.
// Lengths are in a unit that the file does not state, angles in degrees, Y is up. Position channels replace
// the joint's OFFSET, on the root too; rotation channels compose in file order, the first one outermost. A
// BvhDocument holds all that a file says, so that reading and writing lose nothing; a MotionClip is what the
// product works on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/job/job.h"
#include "core/math/euler.h"
#include "core/motion/clip.h"

namespace noctule {

enum class BvhChannel : std::uint8_t {
    kXposition,
    kYposition,
    kZposition,
    kXrotation,
    kYrotation,
    kZrotation,
};

struct BvhJoint {
    std::string name;  ///< unique within the document
    int parent = -1;   ///< parents come first; joint 0 is the root
    Vector3d offset = Vector3d::Zero();
    std::vector<BvhChannel> channels;  ///< in file order, each at most once
    size_t first_channel = 0;          ///< where they begin in a row
    std::optional<Vector3d> end_site;  ///< offset of the tip
};

/// Something odd in a file that could be read nevertheless.
struct BvhWarning {
    size_t line = 0;  ///< from 1; 0: of the whole file
    std::string text;
};
/// "line 12: ..." where it has a line.
std::string toText(const BvhWarning& warning);

struct BvhDocument {
    std::string name;  ///< of the file, without folder and extension
    std::vector<BvhJoint> joints;
    size_t channel_count = 0;    ///< numbers per row
    double frame_time_s = 0;     ///< 1 us to 10 s as written; above, to 100: taken as ms, with a warning
    size_t declared_frames = 0;  ///< what `Frames:` says; frameCount() is what is there
    std::vector<double> values;  ///< row after row, file's unit and degrees, within +-1e9
    std::vector<BvhWarning> warnings;

    size_t frameCount() const { return channel_count ? values.size() / channel_count : 0; }
};

/// Reads a file. A damaged one is kUnreadable with line and remedy, except that a wrong frame count and a
/// last row cut short leave the complete rows and a warning. Memory is bounded by the file's size, whatever
/// it declares. UTF-8 or UTF-16; `cancel` ends the wait for a pipe.
Result<BvhDocument> readBvh(const std::string& path, const CancelFlag* cancel = nullptr);
/// The same from memory; `where` names the text in errors.
Result<BvhDocument> parseBvh(std::string_view text, const std::string& where);

enum class BvhUnit { kMetre, kCentimetre, kMillimetre, kInch, kCmu, kDecimetre, kAuto };

/// "m", "cm", "mm", "inch", "cmu" (5.644 cm, the CMU motion capture database), "dm" (MakeHuman) or "auto";
/// otherwise kUsage.
Result<BvhUnit> bvhUnitFromText(const std::string& text);
std::string toText(BvhUnit unit);
/// Not of kAuto.
double metresPer(BvhUnit unit);

/// What kAuto takes: the unit that makes the figure 1.2 to 2.3 m tall (in inches to 2.05 m: a child of 80 to
/// 90 cm is no giant), and that is one alone (from 21.3 to 23 units cmu rather than dm). A figure that fits
/// none gets the nearest, centimetres and metres preferred, and is not plausible: tell the user.
struct BvhUnitChoice {
    BvhUnit unit = BvhUnit::kCentimetre;
    double height_m =
        0;  ///< largest extent of the zero pose, or of the first frame where the zero pose is crumpled
    bool plausible = false;
};
BvhUnitChoice chooseUnit(const BvhDocument& document);
/// The same for a figure whose height in the file's unit is known better than from its extent.
BvhUnitChoice unitForHeight(double height);

/// Root free, all other joints ball with freedoms rotation_x, _y and _z. kUnusable without frames.
Result<MotionClip> toClip(const BvhDocument& document, BvhUnit unit = BvhUnit::kAuto);

struct BvhOptions {
    double metres_per_unit = 0.01;  ///< 0.01 MotionBuilder and Maya, 1 Blender
    EulerOrder rotation_order = kEulerZXY;
};

/// Positions before rotations, offsets from the zero pose, an end site on every leaf (end_m, or 5 cm further
/// on); joints that clip.p_parent_joint_m moves have position channels too. Angles run on without jumps of a
/// turn. kUnusable when the clip has no frames or holds anything that is not finite.
Result<BvhDocument> toDocument(const MotionClip& clip, const BvhOptions& options = {});

/// The file's text: lengths to 1e-8 units, angles to 1e-7 degrees, the frame time exactly.
std::string formatBvh(const BvhDocument& document);

/// Writes aside, reads back, compares and only then gives the file its name (kDisk when it does not compare).
Status writeBvh(const std::string& path, const BvhDocument& document, bool overwrite);
Status writeBvh(const std::string& path, const MotionClip& clip, const BvhOptions& options, bool overwrite);

}  // namespace noctule
