// SPDX-License-Identifier: Apache-2.0
// What is said, on the start page and above other pages, about what a program that died left behind.
#pragma once

#include <QString>

namespace noctule::ui {

/// `problem` names what cannot be read and which takes are safe; a sentence without its stop.
QString rebuildOffer(const QString& problem);
/// Of one take, after what is safe was said.
QString recoverOffer();

}  // namespace noctule::ui
