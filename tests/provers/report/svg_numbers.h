/// @file
/// What a test reads off an SVG.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace tact::provers {

inline int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The area in square pixels that the closed loops of the first path with this style enclose, each counted
/// for itself; zero without such a path.
inline double AreaOfPath(const std::string& svg, const std::string& style) {
  const size_t end = svg.find("\" " + style);
  if (end == std::string::npos) return 0;
  const size_t start = svg.rfind("d=\"", end) + 3;
  double total = 0, twice = 0;
  std::vector<double> numbers;
  for (const char* at = svg.c_str() + start; at < svg.c_str() + end;) {
    if (*at == 'Z') {
      const size_t n = numbers.size();
      for (size_t i = 0; i < n; i += 2) {
        twice += numbers[i] * numbers[(i + 3) % n] - numbers[i + 1] * numbers[(i + 2) % n];
      }
      total += std::abs(twice) / 2;
      twice = 0;
      numbers.clear();
      ++at;
    } else if (*at == 'M' || *at == 'L' || *at == ' ') {
      ++at;
    } else {
      char* next = nullptr;
      numbers.push_back(std::strtod(at, &next));
      at = next;
    }
  }
  return total;
}

}  // namespace tact::provers
