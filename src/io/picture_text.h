// Text in pictures: valid UTF-8, escaped, and no wider than its place.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace oblast::io {

/// Bytes that are no UTF-8 become U+FFFD, and control characters become spaces: names of files and values of columns
/// may be anything, and XML refuses both.
std::string readable(const std::string& text);

/// For XML: & < > and quotes are escaped. REQUIRES readable text.
std::string escaped(const std::string& text);

/// The width of a text in pixels, estimated from the number of characters.
double text_width(const std::string& text, double font_size);

/// The text, or its beginning and "…", so that it is at most `width` pixels wide.
std::string fitted(const std::string& text, double font_size, double width);

/// Lines of at most `width` pixels, broken at spaces. What does not fit into `most` lines is left out, with "…".
std::vector<std::string> wrapped(const std::string& text, double font_size, double width, std::size_t most);

/// "1 contour", "1,234 contours"; "1 vertex", "4 vertices".
std::string counted_in_picture(std::uint64_t number, const std::string& noun, const std::string& plural);

}  // namespace oblast::io
