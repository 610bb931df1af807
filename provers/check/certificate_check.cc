// The frame that every certificate has, and its kind.
#include <array>
#include <string>
#include <utility>

#include "provers/check/check.h"
#include "provers/check/kinds.h"

namespace tact::check {
namespace {

constexpr std::array<std::pair<std::string_view, void (*)(const Value&)>, 16> kKinds = {{
    {"motion-dofs", CheckMotionDofs},
    {"transitions", CheckTransitions},
    {"basis", CheckBasis},
    {"ill-reduced-singular", CheckIllReducedSingular},
    {"dof-classes", CheckDofClasses},
    {"motion-path", CheckMotionPath},
    {"knot-move", CheckKnotMove},
    {"knot-rule", CheckKnotRule},
    {"knot-tying", CheckKnotTying},
    {"knot-drawing", CheckKnotDrawing},
    {"knot-embedding", CheckKnotEmbedding},
    {"knot-face-search", CheckKnotFaceSearch},
    {"knot-parts", CheckKnotParts},
    {"knot-subdivision", CheckKnotSubdivision},
    {"identity", CheckIdentity},
    {"no-identity", CheckNoIdentity},
}};
constexpr std::array<std::string_view, 6> kCommonKeys = {"format", "version",   "claim",
                                                         "kind",   "statement", "note"};

void CheckFrame(const Value& certificate, std::string& claim) {
  const Value& format = At(certificate, "format");
  if (AsString(format) != "tact-certificate") throw Refused(&format, "expected \"tact-certificate\"");
  claim = AsString(At(certificate, "claim"));
  if (claim.empty()) throw Refused(&At(certificate, "claim"), "names no claim");
  const Value& version = At(certificate, "version");
  if (AsInteger(version) != 1) throw Refused(&version, "this checker knows version 1 only");
  for (std::string_view key : {"statement", "note"}) {
    if (const Value* text = Find(certificate, key)) AsString(*text);
  }
}

void CheckKind(const Value& certificate, std::string& not_recounted) {
  const Value& kind = At(certificate, "kind");
  if (AsString(kind) == "census") {
    not_recounted = CheckCensus(certificate);
    return;
  }
  for (const auto& [name, check] : kKinds) {
    if (AsString(kind) == name) return check(certificate);
  }
  throw Refused(&kind, "this checker knows no kind " + Quote(AsString(kind)));
}

}  // namespace

void ExpectCertificateKeys(const Value& certificate, std::initializer_list<std::string_view> required,
                           std::initializer_list<std::string_view> optional) {
  const auto in = [](const auto& list, std::string_view key) {
    for (std::string_view other : list) {
      if (other == key) return true;
    }
    return false;
  };
  for (const auto& [key, value] : AsObject(certificate)) {
    if (!in(kCommonKeys, key) && !in(required, key) && !in(optional, key)) {
      throw Refused(&certificate, "unknown key " + Quote(key));
    }
  }
  for (std::string_view key : required) At(certificate, key);
}

Answer CheckCertificate(std::string_view text) {
  Answer answer;
  Value root{nullptr};
  try {
    root = ParseJson(text);
    CheckFrame(root, answer.claim);
    CheckKind(root, answer.not_recounted);
    answer.accepted = true;
  } catch (const Refused& refused) {
    const std::string path = PathOf(root, refused.where());
    answer.why = (path.empty() ? "" : path + ": ") + refused.what();
  }
  return answer;
}

}  // namespace tact::check
