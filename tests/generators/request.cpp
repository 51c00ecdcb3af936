// The options and checks of a hostile case.
#include "generators/request.h"

#include "generators/random.h"

namespace oblast::generators {
namespace {

FillRule draw_rule(Random& random) {
  switch (random.below(8)) {
    case 0:
      return FillRule::even_odd();
    case 1:
      return FillRule::nonzero();
    case 2:
      return FillRule::positive();
    case 3:
      return FillRule::negative();
    case 4:
      return FillRule::at_least(random.between(1, 3));
    default:
      return FillRule::polygons();
  }
}

std::string to_text(const FillRule& rule) {
  switch (rule.kind) {
    case FillRule::Kind::polygons:
      return "polygons";
    case FillRule::Kind::at_least:
      return "atleast:" + std::to_string(rule.depth);
    case FillRule::Kind::even_odd:
      return "evenodd";
    case FillRule::Kind::nonzero:
      return "nonzero";
    case FillRule::Kind::positive:
      return "positive";
    case FillRule::Kind::negative:
      return "negative";
  }
  return "";
}

}  // namespace

Request draw_request(std::uint64_t seed) {
  Random random(seed ^ 0x5eed5eed5eed5eedu);
  Request request;
  request.fill_a = draw_rule(random);
  request.fill_b = random.one_in(3) ? draw_rule(random) : request.fill_a;
  request.contours = random.one_in(3) ? ContourConvention::leonov_nikitin : ContourConvention::ogc;
  request.collinear = random.one_in(6) ? CollinearVertices::drop : CollinearVertices::keep;
  request.seed = random.next();
  request.other_threads = random.one_in(16);
  request.other_engines = random.one_in(4);
  request.recompute = random.one_in(256);
  request.chosen = static_cast<Operation>(random.below(4));
  return request;
}

Options options_of(const Request& request) {
  Options options;
  options.fill_a = request.fill_a;
  options.fill_b = request.fill_b;
  options.contours = request.contours;
  options.collinear = request.collinear;
  options.threads = 1;
  return options;
}

std::string to_text(const Request& request) {
  return "fill_a=" + to_text(request.fill_a) + " fill_b=" + to_text(request.fill_b) +
         (request.contours == ContourConvention::ogc ? " ogc" : " leonov_nikitin") +
         (request.collinear == CollinearVertices::keep ? "" : " drop_collinear") +
         (request.other_threads ? " threads=2" : "");
}

}  // namespace oblast::generators
