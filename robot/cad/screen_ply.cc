// PLY: a header that declares elements and their properties, then the elements as text lines or as bytes.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "algebra/error.h"
#include "robot/cad/mesh_screen.h"
#include "robot/cad/text_lines.h"

namespace tact::cad {
namespace {

struct Type {
  size_t bytes;
  bool is_float;
  bool is_signed;

  long long Low() const { return is_signed ? -(1LL << (8 * bytes - 1)) : 0; }
  long long High() const { return (1LL << (8 * bytes - (is_signed ? 1 : 0))) - 1; }
};

const std::map<std::string_view, Type> kTypes = {
    {"char", {1, false, true}},    {"int8", {1, false, true}},    {"uchar", {1, false, false}},
    {"uint8", {1, false, false}},  {"short", {2, false, true}},   {"int16", {2, false, true}},
    {"ushort", {2, false, false}}, {"uint16", {2, false, false}}, {"int", {4, false, true}},
    {"int32", {4, false, true}},   {"uint", {4, false, false}},   {"uint32", {4, false, false}},
    {"float", {4, true, true}},    {"float32", {4, true, true}},  {"double", {8, true, true}},
    {"float64", {8, true, true}},
};

struct Property {
  std::string_view name;
  Type type;
  std::optional<Type> count;  // of a list
};

struct Element {
  std::string_view name;
  size_t items;
  std::vector<Property> properties;
  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
};

enum class Encoding { kText, kLittleEndian, kBigEndian };

struct Header {
  Encoding encoding = Encoding::kText;
  std::vector<Element> elements;
  size_t end = 0;  // offset of the first element
  size_t points = 0;
};

bool IsCoordinate(const Property& p) { return p.name == "x" || p.name == "y" || p.name == "z"; }
bool IsCorners(const Property& p) { return p.name == "vertex_indices" || p.name == "vertex_index"; }

Type ReadType(const TextLines& lines, std::string_view word, const std::string& what) {
  const auto found = kTypes.find(word);
  if (found == kTypes.end()) lines.Fail(what, "\"" + std::string(word) + "\"");
  return found->second;
}

void ReadProperty(const TextLines& lines, Element* element) {
  const auto& words = lines.words();
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (!is_list && words.size() != 3) lines.Fail("\"property TYPE NAME\" or \"property list TYPE TYPE NAME\"");
  Property property{words.back(), ReadType(lines, words[is_list ? 3 : 1], "a number type"), std::nullopt};
  if (is_list) property.count = ReadType(lines, words[2], "a whole number type");
  if (is_list && property.count->is_float) lines.Fail("a whole number type for the length of a list");
  for (const Property& other : element->properties) {
    if (other.name == property.name) lines.Fail("each property once");
  }
  if (element->is_vertex() && IsCoordinate(property) && (is_list || !property.type.is_float)) {
    lines.Fail("coordinates of type float or double");
  }
  const bool is_index = is_list && !property.type.is_float && property.type.bytes == 4;
  if (element->is_face() && IsCorners(property) && !is_index)
    lines.Fail("vertex indices as a list of int or uint");
  element->properties.push_back(property);
}

void CheckElements(const TextLines& lines, Header* header) {
  int vertices = 0, faces = 0;
  for (const Element& element : header->elements) {
    size_t coordinates = 0, corners = 0;
    for (const Property& property : element.properties) {
      coordinates += IsCoordinate(property) ? 1 : 0;
      corners += IsCorners(property) ? 1 : 0;
    }
    const std::string place = " before \"end_header\"";
    if (element.properties.empty()) lines.Fail("properties of element " + std::string(element.name) + place);
    // The reader makes assumptions about half-edges that a file need not keep.
    if (element.name == "halfedge") lines.Fail("elements vertex and face", "halfedge");
    if (element.is_vertex()) {
      ++vertices;
      header->points = element.items;
      if (coordinates != 3) lines.Fail("vertex properties x, y and z" + place);
    } else if (element.is_face()) {
      ++faces;
      if (corners != 1) lines.Fail("one face property vertex_indices" + place);
      if (element.items == 0) lines.Fail("at least one face", "none");
    }
  }
  if (vertices != 1) lines.Fail("exactly one element vertex before \"end_header\"");
  if (faces != 1) lines.Fail("exactly one element face before \"end_header\"");
}

Header ReadHeader(TextLines* lines) {
  Header header;
  if (!lines->Next() || lines->words()[0] != "ply" || lines->line() != 1) lines->Fail("\"ply\"");
  if (!lines->Next() || lines->words().size() != 3 || lines->words()[0] != "format" || lines->line() != 2) {
    lines->Fail("\"format ascii 1.0\" or another format");
  }
  const std::string_view encoding = lines->words()[1];
  if (encoding == "binary_little_endian") {
    header.encoding = Encoding::kLittleEndian;
  } else if (encoding == "binary_big_endian") {
    header.encoding = Encoding::kBigEndian;
  } else if (encoding != "ascii") {
    lines->Fail("format ascii, binary_little_endian or binary_big_endian");
  }
  while (lines->Next() && lines->words()[0] != "end_header") {
    const auto& words = lines->words();
    if (words[0] == "element" && words.size() == 3) {
      const long long items = lines->Whole(words[2], 0, std::numeric_limits<int>::max(), "a number of items");
      header.elements.push_back({words[1], static_cast<size_t>(items), {}});
    } else if (words[0] == "property" && !header.elements.empty()) {
      ReadProperty(*lines, &header.elements.back());
    } else if (words[0] != "comment" && words[0] != "obj_info") {
      lines->Fail("an element, a property, a comment or \"end_header\"");
    }
  }
  if (lines->words().empty()) lines->Fail("\"end_header\"");
  CheckElements(*lines, &header);
  header.end = lines->offset();
  return header;
}

// The header without comments, as the reader wants it.
std::string PlainHeader(const Header& header, std::string_view contents) {
  std::string text;
  TextLines lines(contents.substr(0, header.end), "", false);
  while (lines.Next()) {
    const auto& words = lines.words();
    if (words[0] == "comment" || words[0] == "obj_info") continue;
    for (size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : " ") + std::string(words[i]);
    text += '\n';
  }
  return text;
}

void ScreenTextElements(const Header& header, TextLines* lines, ScreenedMesh* mesh) {
  for (const Element& element : header.elements) {
    for (size_t i = 0; i < element.items; ++i) {
      const std::string item =
          std::string(element.name) + " " + std::to_string(i + 1) + " of " + std::to_string(element.items);
      if (!lines->Next()) lines->Fail(item);
      const auto& words = lines->words();
      size_t w = 0;
      const auto next = [&]() {
        if (w == words.size()) lines->Fail("more numbers for " + item);
        return words[w++];
      };
      for (const Property& property : element.properties) {
        size_t count = 1;
        if (property.count) {
          count =
              static_cast<size_t>(lines->Whole(next(), 0, property.count->High(), "the length of a list"));
        }
        const bool is_corners = element.is_face() && IsCorners(property);
        for (size_t k = 0; k < count; ++k) {
          const std::string_view word = next();
          if (property.type.is_float) {
            lines->CheckNumber(word, element.is_vertex() && IsCoordinate(property) ? &mesh->notes : nullptr);
          } else if (is_corners) {
            lines->Whole(word, 0, static_cast<long long>(header.points) - 1, "a vertex, counted");
          } else {
            lines->Whole(word, property.type.Low(), property.type.High(), "a number");
          }
        }
        if (!is_corners) continue;
        mesh->corners.push_back(count);
        mesh->polygon_lines.push_back(lines->line());
      }
      if (w != words.size()) lines->Fail(std::to_string(w) + " numbers for " + item);
      AppendLine(words, &mesh->contents);
    }
  }
  if (lines->Next()) lines->Fail("the end of the file after the last element");
}

class Bytes {
 public:
  Bytes(std::string_view contents, size_t offset, Encoding encoding, const std::string& name)
      : contents_(contents), offset_(offset), encoding_(encoding), name_(name) {}

  // The next bytes of a type as a whole number, or as its bit pattern for a float.
  uint64_t Raw(const Type& type, const std::string& item) {
    if (contents_.size() - offset_ < type.bytes) {
      throw InputError(name_ + ": expected " + item + ", got the end of the file");
    }
    uint64_t value = 0;
    for (size_t i = 0; i < type.bytes; ++i) {
      const size_t place = encoding_ == Encoding::kBigEndian ? i : type.bytes - 1 - i;
      value = value << 8 | static_cast<unsigned char>(contents_[offset_ + place]);
    }
    offset_ += type.bytes;
    return value;
  }

  size_t left() const { return contents_.size() - offset_; }

 private:
  std::string_view contents_;
  size_t offset_;
  Encoding encoding_;
  const std::string& name_;
};

void ScreenBytes(const Header& header, std::string_view contents, const std::string& name,
                 ScreenedMesh* mesh) {
  Bytes bytes(contents, header.end, header.encoding, name);
  for (const Element& element : header.elements) {
    for (size_t i = 0; i < element.items; ++i) {
      const std::string item =
          std::string(element.name) + " " + std::to_string(i + 1) + " of " + std::to_string(element.items);
      for (const Property& property : element.properties) {
        const uint64_t count = property.count ? bytes.Raw(*property.count, item) : 1;
        if (property.count && count > static_cast<uint64_t>(property.count->High())) {
          throw InputError(name + ": " + item + ": expected the length of a list, got a negative number");
        }
        const bool is_corners = element.is_face() && IsCorners(property);
        for (uint64_t k = 0; k < count; ++k) {
          const uint64_t raw = bytes.Raw(property.type, item);
          if (is_corners && raw >= header.points) {
            throw InputError(name + ": " + item + ": expected a vertex, counted from 0 to " +
                             std::to_string(header.points - 1) + ", got " + std::to_string(raw));
          }
          if (!element.is_vertex() || !IsCoordinate(property)) continue;
          const double value = property.type.bytes == 4 ? std::bit_cast<float>(static_cast<uint32_t>(raw))
                                                        : std::bit_cast<double>(raw);
          if (!std::isfinite(value)) {
            throw InputError(name + ": " + item + ": expected finite coordinates, got NaN or infinity");
          }
        }
        if (is_corners) mesh->corners.push_back(count);
      }
    }
  }
  if (bytes.left() > 0) {
    throw InputError(name + ": expected the end of the file after the last element, got " +
                     std::to_string(bytes.left()) + " more bytes");
  }
  mesh->contents += contents.substr(header.end);
}

}  // namespace

ScreenedMesh ScreenPly(std::string_view contents, const std::string& name) {
  TextLines lines(contents, name, false);
  const Header header = ReadHeader(&lines);
  ScreenedMesh mesh;
  mesh.contents = PlainHeader(header, contents);
  mesh.points = header.points;
  mesh.single_precision = true;
  for (const Element& element : header.elements) {
    for (const Property& property : element.properties) {
      if (element.is_vertex() && IsCoordinate(property) && property.type.bytes == 8) {
        mesh.single_precision = false;
      }
    }
  }
  if (header.encoding == Encoding::kText) {
    ScreenTextElements(header, &lines, &mesh);
  } else {
    ScreenBytes(header, contents, name, &mesh);
  }
  return mesh;
}

}  // namespace tact::cad
