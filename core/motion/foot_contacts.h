// SPDX-License-Identifier: Apache-2.0
// When each foot stood on the ground: while its ankle or the tip of its toes was low and slow, so that both
// the strike of the heel and the push of the toes belong to a step. The limits have hysteresis, so that a
// foot at the edge does not flicker. Low is meant above the lowest that either foot's ankle (or tip) was
// within 0.6 s: ankles never touch the floor, and a root that nothing holds drifts, up and down too, by some
// centimetres a second. Level ground is assumed. Where the root itself wanders as fast as a foot moves (no
// external root, minutes long) few contacts or none are found.
#pragma once

#include <string>
#include <vector>

#include "core/motion/timed_poses.h"

namespace noctule {

struct ContactSettings {
    double touch_height_m = 0.03, leave_height_m = 0.05;            ///< above the point's level
    double touch_speed_m_per_s = 0.30, leave_speed_m_per_s = 0.55;  ///< over 40 ms; larger: longer contacts
    /// Flights shorter than this are taken for part of a contact, then shorter contacts are dropped.
    double least_flight_s = 0.05, least_contact_s = 0.08;
};

struct FootContact {
    double from_s = 0, to_s = 0;  ///< of the take's clock
    /// How far the point that stood longest wandered along the ground from its mean, at most, within the
    /// middle three fifths of the contact.
    double slide_m = 0;
    bool by_hand = false;  ///< an operator has set or changed it; else it was found
};

struct FootContacts {
    std::string foot;  ///< "LeftFoot"
    std::vector<FootContact> contacts;
};

/// Of LeftFoot and RightFoot, as far as the skeleton has them (by name or alias). A frame without a pose ends
/// a contact.
std::vector<FootContacts> findFootContacts(const TimedMotion& motion, const ContactSettings& settings = {});

/// Of contacts that were found otherwise: sets slide_m from the motion.
void measureSlides(const TimedMotion& motion, std::vector<FootContacts>& feet);

/// Mean over all contacts; 0 without any.
double meanSlide_m(const std::vector<FootContacts>& feet);

}  // namespace noctule
