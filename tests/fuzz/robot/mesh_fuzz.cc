/// @file
/// Whatever ReadMesh accepts is a solid of positive volume; the rest is an InputError. The first byte chooses
/// the format, the others are the file.
#include <cstdint>
#include <cstdlib>

#include "algebra/error.h"
#include "robot/cad/mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace tact::cad;
  if (size == 0) return 0;
  constexpr MeshFormat kFormats[] = {MeshFormat::kOff, MeshFormat::kObj, MeshFormat::kStl, MeshFormat::kPly};
  const std::string_view contents(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const Mesh mesh =
        ReadMesh(contents, kFormats[data[0] % 4], "input", LengthUnit::kInch, LengthUnit::kMetre);
    if (SixfoldVolume(mesh.solid).sign() <= 0) std::abort();
  } catch (const tact::InputError&) {
    // Most inputs are no mesh.
  }
  return 0;
}
