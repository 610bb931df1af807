/// @file
/// What the STEP module offers: OpenCASCADE's forty libraries are loaded when a STEP file is read, and not before.
/// Model   C alone crosses the border: the module and the program may have C++ libraries of their own. The sink is told of
///         each face, then of each of its loops, the outer one first, then of each loop's corners.
/// Units   millimetre.
#pragma once

#include <cstddef>

extern "C" {

struct TactStepSink {
  void* self;
  void (*face)(void* self, const char* name, const double normal[3]);
  void (*loop)(void* self);
  void (*corner)(void* self, const double point[3]);
  void (*refuse)(void* self, const char* message);  // once, and nothing of the file counts
};

/// `name` stands for the file in messages.
using TactReadStep = void (*)(const char* contents, size_t size, const char* name, const TactStepSink* sink);
}

/// The function's name in the module.
inline constexpr const char* kTactReadStep = "tact_read_step";
