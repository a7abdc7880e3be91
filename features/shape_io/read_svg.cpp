#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <rapidxml_ns/rapidxml_ns.hpp>
#include <svgpp/policy/xml/rapidxml_ns.hpp>
#include <svgpp/svgpp.hpp>

#include "features/core/errors.h"
#include "features/shape_io/flatten_curves.h"
#include "features/shape_io/read_planar_domain.h"

namespace mdbd {
namespace {

namespace element = svgpp::tag::element;
using Absolute = svgpp::tag::coordinate::absolute;

// Takes what SVG++ tells of the paths of a drawing; its names are SVG++'s.
class Drawing {
 public:
  void on_enter_element(element::any) { transforms_.push_back(transforms_.back()); }
  void on_exit_element() { transforms_.pop_back(); }

  void transform_matrix(const boost::array<double, 6>& m) {
    Eigen::Affine2d transform = Eigen::Affine2d::Identity();
    transform.linear() << m[0], m[2], m[1], m[3];
    transform.translation() << m[4], m[5];
    transforms_.back() = transforms_.back() * transform;
  }

  void path_move_to(double x, double y, Absolute) {
    finish_outline();
    outline_ = {{x, y}};
  }
  void path_line_to(double x, double y, Absolute) { outline_.emplace_back(x, y); }
  void path_quadratic_bezier_to(double x1, double y1, double x, double y, Absolute) {
    const std::array<Eigen::Vector2d, 3> control = {outline_.back(), {x1, y1}, {x, y}};
    add_bezier(control, outline_);
  }
  void path_cubic_bezier_to(double x1, double y1, double x2, double y2, double x, double y,
                            Absolute) {
    const std::array<Eigen::Vector2d, 4> control = {outline_.back(), {x1, y1}, {x2, y2}, {x, y}};
    add_bezier(control, outline_);
  }
  void path_elliptical_arc_to(double rx, double ry, double degrees, bool is_large, bool is_sweep,
                              double x, double y, Absolute) {
    add_arc({.radii = {rx, ry},
             .rotation = degrees * std::numbers::pi / 180.0,
             .is_large = is_large,
             .is_sweep = is_sweep,
             .end = {x, y}},
            outline_);
  }
  // A path may go on from where the closed part began.
  void path_close_subpath() {
    const Eigen::Vector2d first = outline_.front();
    finish_outline();
    outline_ = {first};
  }
  void path_exit() { finish_outline(); }

  PlanarDomain take_domain() { return std::move(domain_); }

 private:
  void finish_outline() {
    if (outline_.size() > 2) {
      for (Eigen::Vector2d& point : outline_) point = transforms_.back() * point;
      domain_.push_back(std::move(outline_));
    }
    outline_.clear();
  }

  std::vector<Eigen::Affine2d> transforms_ = {Eigen::Affine2d::Identity()};
  Outline outline_;
  PlanarDomain domain_;
};

// Programs write elements and attributes of their own into their drawings.
struct IgnoreUnknown : svgpp::policy::error::raise_exception<Drawing> {
  template <typename... Arguments>
  static bool unknown_element(const Drawing&, const Arguments&...) {
    return true;
  }
  template <typename... Arguments>
  static bool unexpected_element(const Drawing&, const Arguments&...) {
    return true;
  }
  template <typename... Arguments>
  static bool unknown_attribute(const Drawing&, const Arguments&...) {
    return true;
  }
  template <typename... Arguments>
  static bool unexpected_attribute(const Drawing&, const Arguments&...) {
    return true;
  }
};

using Elements =
    boost::mpl::insert<boost::mpl::insert<svgpp::traits::shape_elements, element::svg>::type,
                       element::g>::type;
using Attributes = boost::mpl::insert<svgpp::traits::shapes_attributes_by_element,
                                      svgpp::tag::attribute::transform>::type;

}  // namespace

PlanarDomain read_svg(const std::string& text) {
  try {
    rapidxml_ns::xml_document<> document;
    document.parse<rapidxml_ns::parse_no_string_terminators>(const_cast<char*>(text.c_str()));
    const auto* root = document.first_node("svg");
    if (root == nullptr) throw InvalidInput("it is no SVG document");
    Drawing drawing;
    svgpp::document_traversal<svgpp::processed_elements<Elements>,
                              svgpp::processed_attributes<Attributes>,
                              svgpp::error_policy<IgnoreUnknown>>::load_document(root, drawing);
    return drawing.take_domain();
  } catch (const rapidxml_ns::parse_error& error) {
    throw InvalidInput(fmt::format("damaged XML: {}", error.what()));
  } catch (const svgpp::exception_base& error) {
    throw InvalidInput(fmt::format("damaged SVG: {}", error.what()));
  }
}

}  // namespace mdbd
