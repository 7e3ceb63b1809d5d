// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Surfaces of a part of a cloud: first the pieces of its faces, then what faces around
// it are like.

#include "geometry/vectors.h"
#include "surfaces/surface_classification.h"

#include <pcl/segmentation/cloud_reach.h>
#include <pcl/segmentation/faces_of_parts.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace pcl {
namespace {

using namespace detail;
using namespace segmentation;

using Place = std::array<float, 3>;

FacePiece
pieceOf(const FaceLevel& level, std::size_t node, const float* first)
{
  const FaceNode& from = level.nodes[node];
  FacePiece piece;
  std::copy_n(first, piece.first.size(), piece.first.begin());
  piece.position = toArray(from.position);
  piece.normal = toArray(from.normal);
  piece.count = from.count;
  piece.spacing = from.spacing;
  std::copy_n(level.scatters[node].data(), piece.scatter.size(), piece.scatter.begin());
  return piece;
}

FaceNode
nodeOf(const FacePiece& piece)
{
  FaceNode node;
  node.position = toVector(piece.position);
  node.normal = toVector(piece.normal);
  node.count = piece.count;
  node.spacing = piece.spacing;
  return node;
}

/** Gives numbers to nodes: first to those of the part, then to others when they are
 * asked for. */
class PieceNumbers {
public:
  PieceNumbers(std::size_t nodes) : numbers_(nodes, PartOfFaces::none) {}

  void
  number(std::uint32_t node)
  {
    numbers_[node] = next_++;
  }

  /** \param[in] useNew called for a node that had no number */
  template <typename UseNew>
  std::uint32_t
  numberOf(std::uint32_t node, const UseNew& useNew)
  {
    if (numbers_[node] == PartOfFaces::none) {
      number(node);
      useNew(node);
    }
    return numbers_[node];
  }

private:
  std::vector<std::uint32_t> numbers_;
  std::uint32_t next_ = 0;
};

/** A box, grown along each axis; that of no places stays empty. */
struct GrownBox {
  GrownBox(const FacesAround::Box& box, double by)
  : low(toVector(box.low).cast<double>().array() - by)
  , high(toVector(box.high).cast<double>().array() + by)
  {}

  bool
  holds(const Place& place) const
  {
    const Eigen::Array3d p = toVector(place).cast<double>().array();
    return (low <= p).all() && (p <= high).all();
  }

  Eigen::Array3d low, high;
};

/** The first point of a piece of the part, or of another one. */
Place
firstOf(const LinkedPieces& all, std::uint32_t piece)
{
  const std::size_t count = all.pieces.size();
  return piece < count ? all.pieces[piece].first : all.others[piece - count];
}

/** The pieces that are wanted. \param[out] numbers of all in the result */
template <typename IsWanted>
LinkedPieces
chosenOf(const LinkedPieces& all, const IsWanted& is_wanted, PieceNumbers& numbers)
{
  LinkedPieces some;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t k = 0; k < all.pieces.size(); ++k)
    if (is_wanted(k)) {
      numbers.number(k);
      kept.push_back(k);
      some.pieces.push_back(all.pieces[k]);
    }
  const auto addOther = [&](std::uint32_t k) {
    some.others.push_back(firstOf(all, k));
  };
  some.link_begins.push_back(0);
  for (const std::uint32_t k : kept) {
    for (std::uint32_t l = all.link_begins[k]; l < all.link_begins[k + 1]; ++l)
      some.links.push_back(numbers.numberOf(all.links[l], addOther));
    some.link_begins.push_back(static_cast<std::uint32_t>(some.links.size()));
  }
  return some;
}

/** The pieces whose first points are in a box. */
LinkedPieces
piecesIn(const GrownBox& box, const LinkedPieces& all)
{
  PieceNumbers numbers(all.pieces.size() + all.others.size());
  const auto is_inside = [&](std::uint32_t k) {
    return box.holds(all.pieces[k].first);
  };
  return chosenOf(all, is_inside, numbers);
}

/** The nodes that pieces are, in the order that the whole cloud has them in. */
class Assembly {
public:
  Assembly(const std::vector<LinkedPieces>& parts, float cell)
  : parts_(parts)
  , cell_(cell)
  {
    for (std::uint32_t part = 0; part < parts.size(); ++part)
      for (std::uint32_t k = 0; k < parts[part].pieces.size(); ++k)
        order_.push_back({inOrder(parts[part].pieces[k].first, cell), part, k});
    std::sort(order_.begin(), order_.end(), [](const Entry& a, const Entry& b) {
      return a.first < b.first;
    });
    for (const LinkedPieces& part : parts)
      nodes_.emplace_back(part.pieces.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i)
      nodes_[order_[i].part][order_[i].piece] = i;
  }

  /** \brief Of the pieces of a part. */
  const std::vector<std::uint32_t>&
  nodesOf(std::size_t part) const
  {
    return nodes_[part];
  }

  /** \brief The node of a piece with this first point, or none. */
  std::uint32_t
  nodeAt(const Place& first) const
  {
    const PlaceInOrder place = inOrder(first, cell_);
    const auto found = std::lower_bound(
        order_.begin(), order_.end(), place, [](const Entry& entry, const auto& p) {
          return entry.first < p;
        });
    return found != order_.end() && found->first == place
               ? static_cast<std::uint32_t>(found - order_.begin())
               : FacePyramid::none;
  }

  FaceLevel
  level() const
  {
    FaceLevel level;
    level.cell = cell_;
    for (const Entry& entry : order_) {
      const FacePiece& piece = parts_[entry.part].pieces[entry.piece];
      level.nodes.push_back(nodeOf(piece));
      level.scatters.emplace_back(
          Eigen::Map<const Eigen::Matrix3f>(piece.scatter.data()));
    }
    std::vector<FaceLink> links;
    for (std::size_t part = 0; part < parts_.size(); ++part)
      addLinks(part, links);
    setLinks(links, level);
    return level;
  }

private:
  struct Entry {
    PlaceInOrder first; ///< point of the piece
    std::uint32_t part, piece;
  };

  /** Links to pieces that are not there are left out. */
  void
  addLinks(std::size_t part, std::vector<FaceLink>& links) const
  {
    const LinkedPieces& from = parts_[part];
    std::vector<std::uint32_t> numbered = nodes_[part];
    for (const Place& other : from.others)
      numbered.push_back(nodeAt(other));
    for (std::size_t k = 0; k < from.pieces.size(); ++k)
      for (std::uint32_t l = from.link_begins[k]; l < from.link_begins[k + 1]; ++l)
        if (numbered[from.links[l]] != FacePyramid::none)
          links.emplace_back(numbered[k], numbered[from.links[l]]);
  }

  const std::vector<LinkedPieces>& parts_;
  float cell_;
  std::vector<Entry> order_;
  std::vector<std::vector<std::uint32_t>> nodes_;
};

/** What windows and fits have in common: all of a fit. */
constexpr std::pair<float FacesAround::Window::*, float FaceFit::*> of_fit[] = {
    {&FacesAround::Window::residual, &FaceFit::residual},
    {&FacesAround::Window::freedom, &FaceFit::freedom},
    {&FacesAround::Window::half_width, &FaceFit::half_width},
    {&FacesAround::Window::bulge, &FaceFit::bulge},
    {&FacesAround::Window::bulge_error, &FaceFit::bulge_error},
    {&FacesAround::Window::inliers, &FaceFit::inliers},
    {&FacesAround::Window::center_offset, &FaceFit::center_offset},
    {&FacesAround::Window::center_cosine, &FaceFit::center_cosine}};
static_assert(sizeof(FaceFit) == std::size(of_fit) * sizeof(float));
static_assert(sizeof(FacesAround::Window) == sizeof(std::uint32_t) + sizeof(FaceFit));

FacesAround::Window
windowOf(std::uint32_t node, const FaceFit& fit)
{
  FacesAround::Window window;
  window.node = node;
  for (const auto& [of_window, value] : of_fit)
    window.*of_window = fit.*value;
  return window;
}

FaceFit
fitOf(const FacesAround::Window& window)
{
  FaceFit fit;
  for (const auto& [of_window, value] : of_fit)
    fit.*value = window.*of_window;
  return fit;
}

void
checkPlaces(std::size_t places, const PartOfFaces& part)
{
  const std::size_t expected = part.piece_of_place.size();
  if (places != expected)
    throw std::invalid_argument("there are " + std::to_string(places) +
                                " places; expected the part's own, " +
                                std::to_string(expected));
}

void
checkWindows(const FacesAround::Windows& windows, const FacePyramid& faces)
{
  for (std::size_t l = 0; l < windows.size(); ++l) {
    const std::size_t nodes = faces.levels[l].nodes.size();
    if (windows[l].nodes != nodes)
      throw std::invalid_argument("the windows of level " + std::to_string(l) +
                                  " are of " + std::to_string(windows[l].nodes) +
                                  " nodes, and there are " + std::to_string(nodes) +
                                  ": the part, its box or the parts around it differ");
  }
}

/** Nodes of all levels that some of the first are in. \param[in] of_first whether only
 * a node's first child, and its first child, and so on, tells: each node of the cloud
 * then belongs to one part. */
std::vector<std::vector<bool>>
withParents(const FacePyramid& faces, std::vector<bool> chosen, bool of_first = false)
{
  std::vector<std::vector<bool>> all{std::move(chosen)};
  for (std::size_t l = 0; l + 1 < faces.levels.size(); ++l) {
    const std::size_t size = faces.levels[l + 1].nodes.size();
    std::vector<bool> parents(size), is_known(size);
    for (std::size_t i = 0; i < all[l].size(); ++i) {
      const std::uint32_t parent = faces.levels[l].parents[i];
      if (all[l][i] && !(of_first && is_known[parent]))
        parents[parent] = true;
      is_known[parent] = true;
    }
    all.push_back(std::move(parents));
  }
  return all;
}

static_assert(FacesAround::levels == face_levels);

} // namespace

PartOfFaces
facesOfPart(const ShapeField& edges,
            const CloudNumbers& numbers,
            const std::vector<bool>& is_own,
            unsigned threads)
{
  if (!(numbers.spacing > 0.0f))
    throw std::invalid_argument("the spacing of the cloud is " +
                                std::to_string(numbers.spacing) +
                                ": it must be above 0 for faces");
  const XYZView& points = edges.points;
  const Neighborhoods neighborhoods(points, threads);
  const FieldInput input{neighborhoods, points, {}, threads, false, &numbers};
  const FacePyramid faces = firstFaces(points, edges, numbers.spacing, threads);
  const std::vector<float> of_model =
      modelDifferences(input, edges, ShapeModel::defaultSurfaces(), faces);
  const FaceLevel& level = faces.levels.front();
  LinkedPieces all{{}, {}, level.link_begins, level.links};
  for (std::uint32_t node = 0; node < level.nodes.size(); ++node)
    all.pieces.push_back(pieceOf(level, node, points[faces.point_of_node[node]]));
  PieceNumbers numbers_of_pieces(all.pieces.size());
  const auto is_of_part = [&](std::uint32_t node) {
    return is_own[faces.point_of_node[node]];
  };
  PartOfFaces part;
  part.linked = chosenOf(all, is_of_part, numbers_of_pieces);
  const auto addOther = [&](std::uint32_t node) {
    part.linked.others.push_back(firstOf(all, node));
  };
  for (std::size_t i = 0; i < points.size; ++i) {
    if (!is_own[i])
      continue;
    const std::uint32_t node = faces.node_of_point[i];
    part.piece_of_place.push_back(node == FacePyramid::none
                                      ? PartOfFaces::none
                                      : numbers_of_pieces.numberOf(node, addOther));
    part.of_model.push_back(of_model[i]);
  }
  return part;
}

struct FacesAround::State {
  const PartOfFaces& own;
  Box box; ///< of its own places
  const CloudNumbers& numbers;
  unsigned threads;
  GrownBox around;                 ///< it
  std::vector<LinkedPieces> parts; ///< the own one first

  float
  cell() const
  {
    return firstCell(numbers.noise, numbers.spacing);
  }

  FacePyramid
  pyramid(const Assembly& assembly) const
  {
    FacePyramid faces;
    faces.levels.push_back(assembly.level());
    addLevels(face_levels, faces, threads);
    return faces;
  }

  std::vector<bool>
  ownNodes(const Assembly& assembly, const FacePyramid& faces) const
  {
    std::vector<bool> is_own(faces.levels.front().nodes.size());
    for (const std::uint32_t node : assembly.nodesOf(0))
      is_own[node] = true;
    return is_own;
  }

  /** The part's own nodes of all levels. */
  std::vector<std::vector<bool>>
  ownOfLevels(const Assembly& assembly, const FacePyramid& faces) const
  {
    return withParents(faces, ownNodes(assembly, faces), true);
  }

  /** The nodes whose evidence is asked for. */
  std::vector<bool>
  nearNodes(const FacePyramid& faces) const
  {
    const GrownBox near(box, evidenceReach(numbers));
    std::vector<bool> is_near;
    for (const FaceNode& node : faces.levels.front().nodes)
      is_near.push_back(near.holds(toArray(node.position)));
    return is_near;
  }
};

FacesAround::Box
FacesAround::Box::of(const XYZView& places)
{
  const Bounds bounds = Bounds::of(places);
  return {toArray(bounds.low), toArray(bounds.high)};
}

FacesAround::FacesAround(const PartOfFaces& own,
                         const Box& box,
                         const CloudNumbers& numbers,
                         unsigned threads)
: state_(new State{own,
                   box,
                   numbers,
                   threads,
                   GrownBox(box, reachOf(numbers, ShapeModel::defaultEdges()).surfaces),
                   {own.linked}})
{}

FacesAround::~FacesAround() = default;

void
FacesAround::add(const LinkedPieces& other)
{
  state_->parts.push_back(piecesIn(state_->around, other));
}

FacesAround::Windows
FacesAround::windows() const
{
  const Assembly assembly(state_->parts, state_->cell());
  const FacePyramid faces = state_->pyramid(assembly);
  const auto own = state_->ownOfLevels(assembly, faces);
  Windows windows;
  for (std::size_t l = 0; l < levels; ++l) {
    windows[l].nodes = faces.levels[l].nodes.size();
    const FaceFits fits = fitsOf(faces, l, own[l], state_->threads);
    for (std::uint32_t node = 0; node < fits.size(); ++node)
      if (fits[node])
        windows[l].windows.push_back(windowOf(node, *fits[node]));
  }
  return windows;
}

std::vector<std::vector<float>>
FacesAround::likelihoods(const XYZView& places,
                         const Noise& noise,
                         const Windows& windows) const
{
  checkPlaces(places.size, state_->own);
  const Assembly assembly(state_->parts, state_->cell());
  FacePyramid faces = state_->pyramid(assembly);
  checkWindows(windows, faces);
  const float spacing = state_->numbers.spacing;
  const auto near = withParents(faces, state_->nearNodes(faces));
  const auto own_nodes = state_->ownOfLevels(assembly, faces);
  std::vector<FaceFits> fits;
  for (std::size_t l = 0; l < levels; ++l) {
    const std::vector<bool> wanted = nodesAround(faces.levels[l], near[l], spacing);
    std::vector<bool> of_others = wanted;
    for (std::size_t node = 0; node < wanted.size(); ++node)
      of_others[node] = wanted[node] && !own_nodes[l][node];
    fits.push_back(fitsOf(faces, l, of_others, state_->threads));
    for (const Window& window : windows[l].windows)
      if (wanted.at(window.node))
        fits[l][window.node] = fitOf(window);
  }
  const FaceEvidence of_nodes = faceEvidence(
      faces, std::move(fits), {noise.begin(), noise.end()}, spacing, state_->threads);
  const PartOfFaces& own = state_->own;
  const std::size_t own_pieces = own.linked.pieces.size();
  for (const std::uint32_t piece : own.piece_of_place)
    faces.node_of_point.push_back(
        piece == PartOfFaces::none ? FacePyramid::none
        : piece < own_pieces       ? assembly.nodesOf(0)[piece]
                             : assembly.nodeAt(own.linked.others[piece - own_pieces]));
  const FaceEvidence of_faces =
      evidenceOfFaces(places, faces, of_nodes, spacing, state_->threads);
  std::vector<float> values = joinedEvidence(own.of_model, of_faces);
  const ShapeModel& model = ShapeModel::defaultSurfaces();
  toPosteriors(model, values);
  std::vector<std::vector<float>> likelihoods(model.classes().size());
  for (std::size_t i = 0; i < values.size(); ++i)
    likelihoods[i % likelihoods.size()].push_back(values[i]);
  return likelihoods;
}

std::uint64_t
FacesAround::rankOfNoise(std::uint64_t residuals)
{
  return segmentation::rankOfNoise(residuals);
}

} // namespace pcl
