// SPDX-License-Identifier: MIT
// Numbers and text as SVG has them, and how wide text is likely to be.
#pragma once

#include <string>
#include <vector>

namespace tress::svg {

std::string fixed(double v, int decimals);
/// A coordinate: at most two decimals, none of them an idle zero.
std::string coord(double v);
std::string point(double x, double y);

/// As XML; what is not ASCII becomes a reference, so that no page's encoding can spoil it.
std::string escaped(const std::u32string& text);
/// Of UTF-8; what XML and readers cannot take is left out.
std::string escaped(const std::string& text);

/// In at most `most` lines of `width` units; what does not fit is cut off.
std::vector<std::u32string> wrapped(const std::string& text, double width, double font, size_t most);

/// `content` is XML already; `more`: further attributes.
std::string text_at(double x, double y, const char* kind, const std::string& content, const std::string& more = {});
std::string path(const char* kind, const std::string& d);

}  // namespace tress::svg
