// Any bytes are P-data and a move, or are refused as bad input with a place. What is read as P-data is P-data; its codes
// and parts give it back; on a sphere its closures are closed; a move that it admits is undone by its inverse.
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

#include "algebra/error.h"
#include "algebra/knot/dt_code.h"
#include "algebra/knot/move.h"
#include "algebra/knot/pd_code.h"
#include "algebra/knot/reducible.h"
#include "robot/input/knot_move_text.h"
#include "robot/input/knot_text.h"

namespace {

using namespace tact;  // NOLINT: a program of one file

void Require(bool holds) {
  if (!holds) std::abort();
}

template <typename Read>
auto AcceptOrRefuse(Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const InputError& error) {
    Require(std::string(error.what()).starts_with("fuzz:"));
    return std::nullopt;
  }
}

void CheckRope(const knot::PData& p) {
  Require(!knot::PData::FindFault(p.SigmaRow(), p.AttrRow()));
  Require(knot::PDataOf(knot::GaussCodeOf(p)) == p);
  Require(knot::PDataOf(knot::PdCodeOf(p)) == p);
  Require(knot::Join(knot::Split(p)) == p);
  for (const std::string& text : {p.ToJson(), ToText(knot::GaussCodeOf(p)),
                                  ToExtendedText(knot::GaussCodeOf(p)), ToText(knot::PdCodeOf(p))}) {
    Require(input::ParsePData(text, "fuzz") == p);
  }
  if (!knot::IsPlanar(p)) return;
  for (const knot::Pass pass : {knot::Pass::kOver, knot::Pass::kUnder}) {
    const knot::PData closed = CloseBy(p, pass);
    Require(knot::IsPlanar(closed) && knot::EndsOnOneFace(closed));
    Require(knot::DtCodeOf({closed}).size() == static_cast<size_t>(closed.crossings()));
  }
}

void CheckMove(const knot::PData& p, const knot::Explanation& explanation) {
  Require(input::ParseMove(input::MoveToJson(explanation), "fuzz") == explanation);
  if (!knot::IsPlanar(p) || FindMoveFault(p, explanation.move)) return;
  Require(Apply(Apply(p, explanation.move), Inverse(explanation.move)) == p);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  // P-data, and after a zero byte a move.
  const std::string text(reinterpret_cast<const char*>(data), size);
  const size_t end = text.find('\0');
  const auto p = AcceptOrRefuse([&] { return input::ParsePData(text.substr(0, end), "fuzz"); });
  const auto move = AcceptOrRefuse(
      [&] { return input::ParseMove(end == std::string::npos ? text : text.substr(end + 1), "fuzz"); });
  if (p) CheckRope(*p);
  if (move) CheckMove(p.value_or(knot::PData()), *move);
  return 0;
}
