// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/edge_collapse.h"

#include <cmath>

// CGAL copies a matrix of which it has set, and reads, the last column only.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace qmesh {

namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using OptionalPoint = boost::optional<Point>;
using OptionalCost = boost::optional<double>;

/// What the policies of one run share. CGAL copies policies, so they hold a pointer to this.
class Session {
 public:
  Session(const CollapseRule& rule, const VertexRounding& rounding, const StarJudge& judge,
          CollapseMesh& start)
      : rule_(rule), rounding_(rounding), judge_(judge), start_(start) {}

  Point pointOf(const CollapseVertex& vertex) const {
    return {vertex.corner.u * rule_.perU, vertex.corner.v * rule_.perV,
            vertex.corner.height * rule_.perMetre};
  }

  /// CGAL asks for the placement of an edge to find its cost and again when its turn has come; only
  /// then it is judged, and where the best place is refused the ends are tried.
  void select() { isTurn_ = true; }
  void collapsing() { isTurn_ = false; }
  void collapsed(Vertex kept) { start_.vertices[kept] = placed_; }

  template <class Profile, class Base>
  OptionalPoint place(const Profile& profile, const Base& base);

 private:
  const CollapseVertex& at(Vertex v) const { return start_.vertices[v]; }

  template <class Profile, class Base> void findPlaces(const Profile& profile, const Base& base);
  template <class Profile, class Base>
  CollapseVertex bestInner(const Profile& profile, const Base& base) const;
  template <class Profile> bool accepts(const Profile& profile, const CollapseVertex& placed);

  const CollapseRule& rule_;
  const VertexRounding& rounding_;
  const StarJudge& judge_;
  CollapseMesh& start_;
  bool isTurn_ = false;
  CollapseVertex placed_;
  std::vector<CollapseVertex> places_;
  std::vector<TinTriangle> star_;
};

template <class Profile, class Base>
CollapseVertex Session::bestInner(const Profile& profile, const Base& base) const {
  OptionalPoint best = base(profile);
  if (!best || !std::isfinite(best->x()) || !std::isfinite(best->y()) || !std::isfinite(best->z()))
    best = CGAL::midpoint(profile.p0(), profile.p1());
  return rounding_.inner(best->x() / rule_.perU, best->y() / rule_.perV,
                         best->z() / rule_.perMetre);
}

/// The places an edge may collapse to, the one it should first.
template <class Profile, class Base>
void Session::findPlaces(const Profile& profile, const Base& base) {
  const CollapseVertex &a = at(profile.v0()), &b = at(profile.v1());
  places_.clear();
  if (a.mobility == Mobility::inner && b.mobility == Mobility::inner) {
    places_.push_back(bestInner(profile, base));
    if (isTurn_ && !rule_.edges) {
      places_.push_back(a);
      places_.push_back(b);
    }
    return;
  }
  if (a.mobility == Mobility::inner || b.mobility == Mobility::inner) {
    places_.push_back(a.mobility == Mobility::inner ? b : a);
    return;
  }
  const bool alongBorder = profile.is_v0_v1_a_border() || profile.is_v1_v0_a_border();
  if (!alongBorder)
    return;
  if (b.mobility == Mobility::edge)
    places_.push_back(a);
  if (a.mobility == Mobility::edge)
    places_.push_back(b);
  if (places_.size() == 2 && base.cost(profile, pointOf(b)) < base.cost(profile, pointOf(a)))
    std::swap(places_[0], places_[1]);
}

template <class Profile>
bool Session::accepts(const Profile& profile, const CollapseVertex& placed) {
  star_.clear();
  for (const auto& t : profile.triangles())
    star_.push_back({t.v0, t.v1, t.v2});
  return judge_.accepts(profile.v0(), profile.v1(), placed, star_);
}

template <class Profile, class Base>
OptionalPoint Session::place(const Profile& profile, const Base& base) {
  findPlaces(profile, base);
  for (const CollapseVertex& placed : places_) {
    if (!isTurn_)
      return pointOf(placed);
    if (accepts(profile, placed)) {
      placed_ = placed;
      return pointOf(placed);
    }
  }
  return {};
}

/// Lindstrom & Turk, "Fast and memory efficient polygonal simplification" (1998).
class LindstromTurk {
 public:
  LindstromTurk(const CollapseRule& rule, Mesh&)
      : placement_({rule.volumeWeight, rule.boundaryWeight, rule.shapeWeight}),
        cost_({rule.volumeWeight, rule.boundaryWeight, rule.shapeWeight}) {}

  template <class Profile> OptionalPoint operator()(const Profile& profile) const {
    return placement_(profile);
  }
  template <class Profile>
  OptionalCost cost(const Profile& profile, const OptionalPoint& placed) const {
    return cost_(profile, placed);
  }

 private:
  sms::LindstromTurk_placement<Mesh> placement_;
  sms::LindstromTurk_cost<Mesh> cost_;
};

/// Garland & Heckbert, "Surface simplification using quadric error metrics" (1997).
class GarlandHeckbert {
 public:
  using Update_tag = CGAL::Tag_true;

  GarlandHeckbert(const CollapseRule&, Mesh& mesh) : policies_(mesh) {}

  /// The optimum; on level ground there is none or it is anywhere: then the best of both ends and
  /// their middle.
  template <class Profile> OptionalPoint operator()(const Profile& profile) const {
    const Point middle = CGAL::midpoint(profile.p0(), profile.p1());
    const OptionalPoint best = policies_(profile);
    if (best &&
        CGAL::squared_distance(*best, middle) <= CGAL::squared_distance(profile.p0(), profile.p1()))
      return best;
    Point chosen = middle;
    for (const Point& end : {profile.p0(), profile.p1()}) {
      if (cost(profile, end) < cost(profile, chosen))
        chosen = end;
    }
    return chosen;
  }
  template <class Profile>
  OptionalCost cost(const Profile& profile, const OptionalPoint& placed) const {
    return policies_(profile, placed);
  }
  template <class Points>
  void initialize(const Mesh& mesh, const Points& points, const Kernel& kernel) const {
    policies_.initialize(mesh, points, kernel);
  }
  template <class Profile> void update_after_collapse(const Profile& profile, Vertex kept) const {
    policies_.update_after_collapse(profile, kept);
  }

 private:
  sms::GarlandHeckbert_plane_policies<Mesh, Kernel> policies_;
};

/// A rule's cost at the place that will be written. Inherits what CGAL looks for in a cost.
template <class Base> class Cost : public Base {
 public:
  explicit Cost(const Base& base) : Base(base) {}

  template <class Profile>
  OptionalCost operator()(const Profile& profile, const OptionalPoint& placed) const {
    if (!placed)
      return {};
    const OptionalCost cost = Base::cost(profile, placed);
    return cost && std::isfinite(*cost) ? cost : OptionalCost();
  }
};

template <class Base> class Placement {
 public:
  Placement(const Base& base, Session& session) : base_(base), session_(&session) {}

  template <class Profile> OptionalPoint operator()(const Profile& profile) const {
    return session_->place(profile, base_);
  }

 private:
  Base base_;
  Session* session_;
};

/// Tells the session what CGAL is about.
class Visitor : public sms::Edge_collapse_visitor_base<Mesh> {
 public:
  explicit Visitor(Session& session) : session_(&session) {}

  void OnSelected(const Profile&, boost::optional<double>, std::size_t, std::size_t) {
    session_->select();
  }
  void OnCollapsing(const Profile&, const OptionalPoint&) { session_->collapsing(); }
  void OnCollapsed(const Profile&, const Vertex& kept) { session_->collapsed(kept); }

 private:
  Session* session_;
};

/// A collapse takes three edges, so a count is met to within one.
class Stop {
 public:
  explicit Stop(const std::optional<std::size_t>& edges) : edges_(edges) {}

  template <class Profile>
  bool operator()(double, const Profile&, std::size_t, std::size_t current) const {
    return edges_ && current <= *edges_ + 1;
  }

 private:
  std::optional<std::size_t> edges_;
};

Mesh meshOf(const CollapseMesh& start, const Session& session) {
  Mesh mesh;
  const auto vertices = Mesh::size_type(start.vertices.size());
  const auto faces = Mesh::size_type(start.triangles.size());
  mesh.reserve(vertices, vertices + faces, faces);
  for (const CollapseVertex& vertex : start.vertices)
    mesh.add_vertex(session.pointOf(vertex));
  for (const TinTriangle& t : start.triangles)
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  return mesh;
}

template <class Base> void run(const CollapseRule& rule, Session& session, Mesh& mesh) {
  const Base base(rule, mesh);
  sms::edge_collapse(mesh, Stop(rule.edges),
                     CGAL::parameters::get_cost(Cost<Base>(base))
                         .get_placement(Placement<Base>(base, session))
                         .visitor(Visitor(session)));
}

void write(const Mesh& mesh, const CollapseMesh& vertices, Tin& out) {
  out.clear();
  std::vector<std::uint32_t> index(vertices.vertices.size());
  for (const Vertex v : mesh.vertices()) {
    const CollapseVertex& vertex = vertices.vertices[v];
    index[v] = std::uint32_t(out.vertices.size());
    out.vertices.push_back(
        {std::uint16_t(vertex.corner.u), std::uint16_t(vertex.corner.v), vertex.q});
  }
  for (const auto face : mesh.faces()) {
    TinTriangle triangle;
    std::size_t k = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
      triangle[k++] = index[v];
    out.triangles.push_back(triangle);
  }
}

} // namespace

void collapseEdges(const CollapseRule& rule, const VertexRounding& rounding, const StarJudge& judge,
                   CollapseMesh& mesh, Tin& out) {
  Session session(rule, rounding, judge, mesh);
  Mesh surface = meshOf(mesh, session);
  if (rule.cost == CollapseCost::lindstromTurk)
    run<LindstromTurk>(rule, session, surface);
  else
    run<GarlandHeckbert>(rule, session, surface);
  write(surface, mesh, out);
}

} // namespace qmesh
