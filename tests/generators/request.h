// What a hostile case asks for: options and checks, drawn from its seed.
#pragma once

#include <oblast/options.h>

#include <cstdint>
#include <string>

namespace oblast::generators {

/// What a case asks for; drawn from the case's seed.
struct Request {
  FillRule fill_a;
  FillRule fill_b;
  ContourConvention contours = ContourConvention::ogc;
  CollinearVertices collinear = CollinearVertices::keep;
  std::uint64_t seed = 0;      ///< of the shuffling
  bool other_threads = false;  ///< compare with two threads (costly)
  bool other_engines = false;  ///< compare with every engine that is present
  bool far = false;            ///< the chosen operation once more with others far away (far.h); not drawn
  bool against = false;        ///< the chosen operation's result against exact arithmetic (recomputation.h); not drawn
  bool recompute = false;      ///< the same, and the noded arrangement by exact arithmetic (costly)
  Operation chosen = Operation::unite;
  double patience = 0;  ///< seconds after which a call is cancelled, and counts as an exception; 0: never
};

Request draw_request(std::uint64_t seed);
std::string to_text(const Request& request);

/// The options of a call on one thread that asks for it.
Options options_of(const Request& request);

}  // namespace oblast::generators
