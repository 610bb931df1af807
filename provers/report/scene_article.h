/// @file
/// A scene with a motion in a page: its two ends drawn, and which DOF-transitions it shows, forwards and backwards.
#pragma once

#include <string>

#include "provers/claims/shown_transitions.h"

namespace tact::provers {

/// The article's id: "scene-M-SD".
std::string SceneId(const ShownScene& scene);
std::string SceneArticle(const ShownScene& scene);

}  // namespace tact::provers
