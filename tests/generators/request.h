// The options and checks of a hostile case, drawn from its seed.
#pragma once

#include <oblast/options.h>

#include <cstdint>
#include <string>

namespace oblast::generators {

/// The options and checks of a case.
struct Request {
  FillRule fill_a;
  FillRule fill_b;
  ContourConvention contours = ContourConvention::ogc;
  CollinearVertices collinear = CollinearVertices::keep;
  std::uint64_t seed = 0;      ///< seed for shuffling
  bool other_threads = false;  ///< compare with two threads (costly)
  bool other_engines = false;  ///< compare with every other engine
  bool far = false;            ///< repeat the chosen operation with others far away (far.h); not drawn
  bool against = false;        ///< compare the result of the chosen operation with exact arithmetic; not drawn
  bool recompute = false;      ///< the same, and recompute the noded arrangement with exact arithmetic (costly)
  Operation chosen = Operation::unite;
  double patience = 0;  ///< seconds after which a call is cancelled, and counts as an exception; 0: never
};

Request draw_request(std::uint64_t seed);
std::string to_text(const Request& request);

/// The options of a call on one thread for this request.
Options options_of(const Request& request);

}  // namespace oblast::generators
