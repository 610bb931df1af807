#include "robot/input/json_stream.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

namespace tact::input {
namespace {

bool IsBlank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

void RefuseIfBroken(const std::istream& in, const std::string& source) {
  if (in.bad())
    throw InputError(source + ": expected a readable file, got an error of the system while reading");
}

void AppendRest(std::istream& in, std::string& text) {
  char block[1 << 16];
  while (in.read(block, sizeof block) || in.gcount() > 0)
    text.append(block, static_cast<size_t>(in.gcount()));
}

}  // namespace

InputFile::InputFile(const std::string& path) : name_(path == "-" ? "<stdin>" : path) {
  if (path == "-") return;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(path + ": expected a file, got a folder");
  }
  errno = 0;
  file_.open(path, std::ios::binary);
  if (!file_) {
    throw InputError(path +
                     ": expected a readable file, got: " + (errno == 0 ? "no access" : std::strerror(errno)));
  }
}

std::istream& InputFile::stream() { return file_.is_open() ? static_cast<std::istream&>(file_) : std::cin; }

bool JsonStream::ReadLine() {
  while (!has_line_ && std::getline(in_, line_)) {
    ++line_number_;
    has_line_ = !IsBlank(line_);
  }
  RefuseIfBroken(in_, source_);
  return has_line_;
}

bool JsonStream::HasMore() { return ReadLine(); }

JsonDocument JsonStream::ParseFirst() {
  const size_t first_line = line_number_;
  if (in_.eof()) return JsonDocument::Parse(std::move(line_), source_, first_line);
  std::string text = line_;
  try {
    return JsonDocument::Parse(std::move(line_), source_, first_line);
  } catch (const CutShortError&) {
    text += '\n';
    AppendRest(in_, text);
    RefuseIfBroken(in_, source_);
  }
  return JsonDocument::Parse(std::move(text), source_, first_line);
}

std::optional<JsonDocument> JsonStream::Next() {
  if (!ReadLine()) {
    if (!started_) throw InputError(source_ + ":1:1: expected a JSON value, got an empty file");
    return std::nullopt;
  }
  has_line_ = false;
  if (std::exchange(started_, true)) return JsonDocument::Parse(std::move(line_), source_, line_number_);
  return ParseFirst();
}

JsonDocument ReadJsonFile(const std::string& path) {
  InputFile file(path);
  std::string text;
  AppendRest(file.stream(), text);
  RefuseIfBroken(file.stream(), file.name());
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(file.name() + ":1:1: expected a JSON value, got an empty file");
  }
  return JsonDocument::Parse(std::move(text), file.name());
}

}  // namespace tact::input
