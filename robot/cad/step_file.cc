#include "robot/cad/step_file.h"

#include <dlfcn.h>

#include <filesystem>

#include "algebra/error.h"
#include "robot/cad/step/step_module.h"

namespace tact::cad {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = "ISO-10303-21;", kEnd = "END-ISO-10303-21;";
constexpr std::string_view kBlanks = " \t\r\n";

void CheckText(std::string_view contents, const std::string& name) {
  const size_t first = contents.find_first_not_of(kBlanks);
  if (first == std::string_view::npos || contents.substr(first, kBegin.size()) != kBegin) {
    throw InputError(name + ":1: expected a STEP file, which begins with \"" + std::string(kBegin) +
                     "\", got something else");
  }
  const size_t last = contents.find_last_not_of(kBlanks) + 1;
  if (last < kEnd.size() || contents.substr(last - kEnd.size(), kEnd.size()) != kEnd) {
    throw InputError(name + ": expected \"" + std::string(kEnd) +
                     "\" at the end, got none: the file was cut short");
  }
}

// Beside an installed program, else where it was built.
fs::path ModulePath() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / TACT_STEP_INSTALLED;
  return !error && fs::exists(installed, error) ? installed : fs::path(TACT_STEP_BUILT);
}

// Loaded once, and kept.
TactReadStep Reader() {
  static const TactReadStep reader = [] {
    const fs::path path = ModulePath();
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* function = module == nullptr ? nullptr : dlsym(module, kTactReadStep);
    if (function == nullptr)
      throw InputError(
          std::string("STEP files are read by a module that is not there, install tact anew or use OFF: ") +
          dlerror());
    return reinterpret_cast<TactReadStep>(function);
  }();
  return reader;
}

struct Told {
  std::vector<LoopedFace> faces;
  std::string refusal;
};

Told& ToldOf(void* self) { return *static_cast<Told*>(self); }
Eigen::Vector3d ToVector(const double* v) { return {v[0], v[1], v[2]}; }

}  // namespace

std::vector<LoopedFace> ReadStepFaces(std::string_view contents, const std::string& name) {
  CheckText(contents, name);
  Told told;
  const TactStepSink sink = {&told,
                             [](void* self, const char* face, const double* normal) {
                               ToldOf(self).faces.push_back({{}, ToVector(normal), face});
                             },
                             [](void* self) { ToldOf(self).faces.back().loops.emplace_back(); },
                             [](void* self, const double* point) {
                               ToldOf(self).faces.back().loops.back().push_back(ToVector(point));
                             },
                             [](void* self, const char* message) { ToldOf(self).refusal = message; }};
  Reader()(contents.data(), contents.size(), name.c_str(), &sink);
  if (!told.refusal.empty()) throw InputError(told.refusal);
  return std::move(told.faces);
}

}  // namespace tact::cad
