/// @file
/// Whether a text is well-formed XML, as far as tact writes XML: elements, attributes, entities, one doctype.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tact::provers {

/// What an XML text holds, or why it is none.
struct XmlContents {
  std::string error;                    // empty: well-formed
  std::map<std::string, int> elements;  // how many of each name
  std::set<std::string> ids;
  std::vector<std::string> links;  // href values
  std::string text;                // character data outside <style> and <script>, entities resolved
};

class XmlReader {
 public:
  explicit XmlReader(std::string_view xml) : rest_(xml) {}

  XmlContents Read() {
    if (rest_.starts_with("<!DOCTYPE html>\n")) rest_.remove_prefix(16);
    while (!rest_.empty() && out_.error.empty()) {
      if (rest_[0] == '<') {
        ReadTag();
      } else {
        ReadText();
      }
    }
    if (out_.error.empty() && !open_.empty()) Fail("unclosed " + open_.back());
    if (out_.error.empty() && roots_ != 1) Fail("expected one root element");
    return out_;
  }

 private:
  void Fail(const std::string& why) {
    if (out_.error.empty()) out_.error = why + " before: " + std::string(rest_.substr(0, 60));
  }

  std::string ReadName() {
    size_t end = 0;
    while (end < rest_.size() && (isalnum(static_cast<unsigned char>(rest_[end])) || rest_[end] == '-'))
      ++end;
    if (end == 0) Fail("expected a name");
    const std::string name(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return name;
  }

  std::string Resolve(std::string_view raw) {
    static const std::map<std::string_view, char> entities = {
        {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"#39", '\''}};
    std::string out;
    for (size_t i = 0; i < raw.size(); ++i) {
      const auto byte = static_cast<unsigned char>(raw[i]);
      if (byte < 0x20 && raw[i] != '\n' && raw[i] != '\t') Fail("control character");
      if (raw[i] != '&') {
        out += raw[i];
        continue;
      }
      const size_t end = raw.find(';', i);
      const auto entity = entities.find(raw.substr(i + 1, end == raw.npos ? 0 : end - i - 1));
      if (entity == entities.end()) {
        Fail("unknown entity");
        return out;
      }
      out += entity->second;
      i = end;
    }
    return out;
  }

  void ReadText() {
    const size_t end = std::min(rest_.find('<'), rest_.size());
    const std::string text = Resolve(rest_.substr(0, end));
    if (open_.empty() && text.find_first_not_of(" \n") != text.npos) Fail("text outside the root");
    if (!open_.empty() && open_.back() != "style" && open_.back() != "script") out_.text += text;
    rest_.remove_prefix(end);
  }

  void ReadTag() {
    rest_.remove_prefix(1);
    if (rest_.starts_with("/")) {
      rest_.remove_prefix(1);
      const std::string name = ReadName();
      if (open_.empty() || open_.back() != name) return Fail("unexpected end of " + name);
      open_.pop_back();
      if (!rest_.starts_with(">")) return Fail("expected >");
      rest_.remove_prefix(1);
      return;
    }
    const std::string name = ReadName();
    ++out_.elements[name];
    if (open_.empty()) ++roots_;
    std::set<std::string> attributes;
    while (rest_.starts_with(" ") || rest_.starts_with("\n")) {
      rest_.remove_prefix(1);
      if (rest_.starts_with("/") || rest_.starts_with(">")) break;
      const std::string attribute = ReadName();
      if (!out_.error.empty()) return;
      if (!attributes.insert(attribute).second) return Fail("attribute twice: " + attribute);
      if (!rest_.starts_with("=\"")) return Fail("expected =\"");
      rest_.remove_prefix(2);
      const size_t end = rest_.find('"');
      if (end == rest_.npos) return Fail("unclosed attribute");
      if (rest_.substr(0, end).find('<') != rest_.npos) return Fail("< in an attribute");
      const std::string value = Resolve(rest_.substr(0, end));
      rest_.remove_prefix(end + 1);
      if (attribute == "href") out_.links.push_back(value);
      if (attribute == "id" && !out_.ids.insert(value).second) return Fail("id twice: " + value);
    }
    if (rest_.starts_with("/>")) {
      rest_.remove_prefix(2);
    } else if (rest_.starts_with(">")) {
      open_.push_back(name);
      rest_.remove_prefix(1);
    } else {
      Fail("expected the end of " + name);
    }
  }

  std::string_view rest_;
  std::vector<std::string> open_;
  int roots_ = 0;
  XmlContents out_;
};

inline XmlContents ReadXml(std::string_view xml) { return XmlReader(xml).Read(); }

}  // namespace tact::provers
