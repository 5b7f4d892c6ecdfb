// See outliner_model.h.
#include "app/gui/panels/outliner_model.h"

#include <QFont>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <algorithm>
#include <cctype>
#include <functional>
#include <unordered_map>
#include <utility>

#include "app/gui/widgets/axis_colors.h"
#include "filters/core/scene/material_override.h"

namespace boxprobe {

namespace {

using Kind = OutlinerModel::Kind;
using Part = ViewState::Part;

using Test = std::function<bool(const std::string&)>;

bool groupOf(Kind kind) {
  return kind <= Kind::Room;
}

std::optional<Part> partOf(Kind kind) {
  if (kind == Kind::Probe || kind == Kind::Probes || kind == Kind::Room) return Part::Probe;
  if (kind == Kind::Object || kind == Kind::Objects || kind == Kind::Lamp || kind == Kind::Lamps) return Part::Object;
  return std::nullopt;
}

/// "kitchen" of "kitchen a" and of "kitchen 2"; "" where the last word is neither.
std::string stemOf(const std::string& name, bool letter) {
  const std::size_t space = name.rfind(' ');
  if (space == std::string::npos || space == 0 || space + 1 == name.size()) return {};
  const auto first = name.begin() + static_cast<std::ptrdiff_t>(space) + 1;
  const bool number = std::all_of(first, name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  const bool single = space + 2 == name.size() && std::islower(static_cast<unsigned char>(name.back())) != 0;
  return (letter ? single : number) ? name.substr(0, space) : std::string();
}

/// Less is light that was baked into a material, or keeps shadows from being black.
bool shines(const Material& given, const Scene& scene) {
  constexpr float kLeast = 0.5f;
  const glm::vec3 light = overriddenMaterial(given, scene).emissive;
  return std::max({light.x, light.y, light.z}) >= kLeast;
}

}  // namespace

std::vector<std::string> probeGroups(const std::vector<Probe>& probes) {
  std::unordered_map<std::string, int> lettered;
  std::unordered_map<std::string, bool> named;
  for (const Probe& probe : probes) {
    named[probe.name] = true;
    if (const std::string stem = stemOf(probe.name, true); !stem.empty()) ++lettered[stem];
  }
  std::vector<std::string> groups;
  std::unordered_map<std::string, bool> numbered;
  for (const Probe& probe : probes) {
    const std::size_t slash = probe.name.find('/');
    const std::string letter = stemOf(probe.name, true), number = stemOf(probe.name, false);
    std::string group;
    if (slash != std::string::npos && slash > 0 && slash + 1 < probe.name.size()) {
      group = probe.name.substr(0, slash);
    } else if (!letter.empty() && lettered[letter] > 1) {
      group = letter;
    } else if (!number.empty() && named.count(number) > 0) {
      group = number;
      numbered[number] = true;
    }
    groups.push_back(std::move(group));
  }
  // What others are numbered after stands with them.
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (groups[i].empty() && numbered.count(probes[i].name) > 0) groups[i] = probes[i].name;
  }
  return groups;
}

OutlinerModel::OutlinerModel(const ViewState& state, QObject* parent) : QAbstractItemModel(parent), state_(state) {}

/// In a square of 16 units.
void OutlinerModel::draw(QPainter& p, Sign sign) {
  switch (sign) {
    case Sign::Eye:
    case Sign::EyeShut: {
      QPainterPath lid(QPointF(1.5, 8.0));
      lid.quadTo(8.0, sign == Sign::Eye ? 1.0 : 13.0, 14.5, 8.0);
      if (sign == Sign::Eye) lid.quadTo(8.0, 15.0, 1.5, 8.0);
      p.drawPath(lid);
      if (sign == Sign::EyeShut) break;
      p.setBrush(p.pen().color());
      p.drawEllipse(QPointF(8.0, 8.0), 1.8, 1.8);
      break;
    }
    case Sign::Lock:
    case Sign::LockOpen:
      p.drawArc(QRectF(sign == Sign::Lock ? 5.0 : 8.0, 2.0, 6.0, 8.0), 0, 180 * 16);
      if (sign == Sign::Lock) p.setBrush(p.pen().color());
      p.drawRect(QRectF(3.5, 7.0, 9.0, 6.5));
      break;
    case Sign::Object:
      p.drawPolygon(QPolygonF({{8.0, 1.5}, {14.0, 5.0}, {14.0, 11.5}, {8.0, 15.0}, {2.0, 11.5}, {2.0, 5.0}}));
      p.drawPolyline(QPolygonF({{2.0, 5.0}, {8.0, 8.0}, {14.0, 5.0}}));
      p.drawLine(QPointF(8.0, 8.0), QPointF(8.0, 15.0));
      break;
    case Sign::Lamp:
      p.drawPolygon(QPolygonF({{5.5, 2.0}, {10.5, 2.0}, {13.5, 9.0}, {2.5, 9.0}}));
      p.drawLine(QPointF(8.0, 9.0), QPointF(8.0, 14.0));
      p.drawLine(QPointF(5.0, 14.0), QPointF(11.0, 14.0));
      break;
    case Sign::Light:
      p.drawEllipse(QPointF(8.0, 8.0), 3.0, 3.0);
      for (const auto& [x, y] : {std::pair(1.0, 0.0), {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
        p.drawLine(QPointF(8.0 + 4.8 * x, 8.0 + 4.8 * y), QPointF(8.0 + 7.0 * x, 8.0 + 7.0 * y));
      }
      break;
    case Sign::Camera:
      p.drawRect(QRectF(1.5, 4.5, 8.5, 7.5));
      p.drawPolygon(QPolygonF({{10.0, 8.0}, {14.5, 5.0}, {14.5, 11.5}}));
      break;
  }
}

QIcon OutlinerModel::signIcon(Sign sign, bool faint) const {
  const QColor color = QGuiApplication::palette().color(QPalette::Text);
  const quint64 key = (static_cast<quint64>(color.rgba()) << 8) | (static_cast<quint64>(sign) << 1) | (faint ? 1 : 0);
  const auto found = icons_.constFind(key);
  if (found != icons_.constEnd()) return *found;
  QIcon icon;
  for (const auto mode : {QIcon::Normal, QIcon::Selected}) {
    constexpr int kSize = 16, kFine = 2;
    QPixmap picture(kFine * kSize, kFine * kSize);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(kFine, kFine);
    if (faint) painter.setOpacity(0.45);
    const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::Text;
    painter.setPen(QPen(QGuiApplication::palette().color(role), 1.3));
    painter.setBrush(Qt::NoBrush);
    draw(painter, sign);
    painter.end();
    picture.setDevicePixelRatio(kFine);
    icon.addPixmap(picture, mode);
  }
  icons_.insert(key, icon);
  return icon;
}

void OutlinerModel::setModels(const std::vector<std::shared_ptr<const Model>>& models) {
  models_ = models;
  shown_.reset();
  nodes_.clear();
  for (const auto& model : models_) {
    for (const Instance& instance : model->instances) {
      if (!instance.node.empty()) nodes_.insert(instance.node);
    }
  }
}

bool OutlinerModel::found(const std::string& name, const QString& words) {
  ++examined_;
  return words.isEmpty() || QString::fromStdString(name).contains(words, Qt::CaseInsensitive);
}

int OutlinerModel::add(Items& items, int parent, Kind kind, std::string name, std::size_t place) {
  Item item;
  item.kind = kind;
  item.name = std::move(name);
  item.place = place;
  item.parent = parent;
  const int at = static_cast<int>(items.size());
  if (parent >= 0) {
    auto& children = items[static_cast<std::size_t>(parent)].children;
    item.row = static_cast<int>(children.size());
    children.push_back(at);
  }
  items.push_back(std::move(item));
  return at;
}

void OutlinerModel::addProbes(Items& items, const std::vector<Probe>& probes, const std::vector<std::size_t>& found) {
  const std::vector<std::string> groups = probeGroups(probes);
  const int all = add(items, -1, Kind::Probes, {}, 0);
  std::unordered_map<std::string, int> rooms;  // where their first probe stands
  for (const std::size_t i : found) {
    int parent = all;
    if (!groups[i].empty()) {
      const auto known = rooms.find(groups[i]);
      parent = known != rooms.end() ? known->second : add(items, all, Kind::Room, groups[i], 0);
      rooms.emplace(groups[i], parent);
    }
    add(items, parent, Kind::Probe, probes[i].name, i);
  }
}

OutlinerModel::Basis OutlinerModel::basisOf(const Scene& scene, const QString& words) const {
  Basis basis;
  basis.words = words;
  for (const Probe& probe : scene.probes) basis.probes.push_back(probe.name);
  for (const Camera& camera : scene.cameras) basis.cameras.push_back(camera.name);
  for (const Light& light : scene.lights) basis.lights.push_back(light.type);
  for (const auto& model : models_) {
    basis.shining.emplace_back();
    for (const Material& material : model->materials) {
      basis.shining.back().push_back(shines(material, scene) ? 1 : 0);
    }
  }
  return basis;
}

void OutlinerModel::addObjects(Items& items, const Basis& basis) {
  ViewState::Names lamps;
  for (std::size_t i = 0; i < models_.size(); ++i) {
    const Model& model = *models_[i];
    for (const Instance& instance : model.instances) {
      const int material = model.meshes[static_cast<std::size_t>(instance.mesh)].material;
      if (material >= 0 && basis.shining[i][static_cast<std::size_t>(material)] != 0) lamps.insert(instance.node);
    }
  }
  std::vector<std::string> objects, shining;
  for (const std::string& node : nodes_) {
    if (found(node, basis.words)) (lamps.count(node) > 0 ? shining : objects).push_back(node);
  }
  const auto addAll = [&items](const std::vector<std::string>& names, Kind group, Kind kind) {
    if (names.empty()) return;
    const int parent = add(items, -1, group, {}, 0);
    for (const std::string& name : names) add(items, parent, kind, name, 0);
  };
  addAll(objects, Kind::Objects, Kind::Object);
  addAll(shining, Kind::Lamps, Kind::Lamp);
}

bool OutlinerModel::show(const Scene& scene, const QString& words) {
  Basis basis = basisOf(scene, words);
  if (shown_ == basis) return false;
  shown_ = std::move(basis);
  Items items;
  std::vector<std::size_t> probes;
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    if (found(scene.probes[i].name, words)) probes.push_back(i);
  }
  addProbes(items, scene.probes, probes);
  addObjects(items, *shown_);
  int lights = -1, cameras = -1;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const QString name = scene.lights[i].type == LightType::Directional ? tr("directional %1")
                         : scene.lights[i].type == LightType::Point     ? tr("point %1")
                                                                        : tr("spot %1");
    const std::string text = name.arg(static_cast<int>(i) + 1).toStdString();
    if (!found(text, words)) continue;
    if (lights < 0) lights = add(items, -1, Kind::Lights, {}, 0);
    add(items, lights, Kind::Light, text, i);
  }
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    if (!found(scene.cameras[i].name, words)) continue;
    if (cameras < 0) cameras = add(items, -1, Kind::Cameras, {}, 0);
    add(items, cameras, Kind::Camera, scene.cameras[i].name, i);
  }
  return take(std::move(items));
}

// Names alone may change in place: what is open, and where it is scrolled to, stays.
bool OutlinerModel::take(Items items) {
  std::vector<int> top;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].parent >= 0) continue;
    items[i].row = static_cast<int>(top.size());
    top.push_back(static_cast<int>(i));
  }
  if (items == items_) return false;
  probeItems_.clear();
  objectItems_.clear();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Kind kind = items[i].kind;
    if (kind == Kind::Probe) probeItems_[items[i].place] = static_cast<int>(i);
    if (kind == Kind::Object || kind == Kind::Lamp) objectItems_[items[i].name] = static_cast<int>(i);
  }
  const bool sameShape = items.size() == items_.size() &&
                         std::equal(items.begin(), items.end(), items_.begin(), [](const Item& a, const Item& b) {
                           return a.kind == b.kind && a.parent == b.parent && a.place == b.place;
                         });
  if (sameShape) {
    items_ = std::move(items);
    everyRowChanged({Qt::DisplayRole, Qt::EditRole, Qt::DecorationRole, Qt::ToolTipRole});
    return true;
  }
  beginResetModel();
  items_ = std::move(items);
  top_ = std::move(top);
  endResetModel();
  return false;
}

// A signal per group, not per row.
void OutlinerModel::everyRowChanged(const QVector<int>& roles) {
  const auto tell = [&](const std::vector<int>& rows) {
    if (!rows.empty()) emit dataChanged(indexOf(rows.front()), indexOf(rows.back(), kColumns - 1), roles);
  };
  tell(top_);
  for (const Item& item : items_) tell(item.children);
}

void OutlinerModel::showStates(const std::vector<BakeStateLook>& looks) {
  if (looks == looks_) return;
  looks_ = looks;
  everyRowChanged({Qt::DecorationRole, Qt::ToolTipRole});
}

void OutlinerModel::markShown(int probe) {
  if (probe == bold_) return;
  bold_ = probe;
  everyRowChanged({Qt::FontRole});
}

void OutlinerModel::stateChanged() {
  everyRowChanged({Qt::DecorationRole, Qt::ForegroundRole, Qt::ToolTipRole});
}

const OutlinerModel::Item* OutlinerModel::item(const QModelIndex& index) const {
  const auto at = static_cast<std::size_t>(index.internalId());
  return index.isValid() && at < items_.size() ? &items_[at] : nullptr;
}

QModelIndex OutlinerModel::indexOf(int item, int column) const {
  return createIndex(items_[static_cast<std::size_t>(item)].row, column, static_cast<quintptr>(item));
}

OutlinerModel::Kind OutlinerModel::kind(const QModelIndex& row) const {
  const Item* of = item(row);
  return of != nullptr ? of->kind : Kind::Probes;
}

bool OutlinerModel::isGroup(const QModelIndex& row) const {
  return groupOf(kind(row));
}

std::size_t OutlinerModel::place(const QModelIndex& row) const {
  const Item* of = item(row);
  return of != nullptr ? of->place : 0;
}

std::string OutlinerModel::name(const QModelIndex& row) const {
  const Item* of = item(row);
  return of != nullptr ? of->name : std::string();
}

ViewState::Names OutlinerModel::namesUnder(const QModelIndex& row, Part part) const {
  ViewState::Names names;
  const Item* of = item(row);
  if (of == nullptr || partOf(of->kind) != part) return names;
  if (!groupOf(of->kind)) return {of->name};
  for (const int child : of->children) {
    const auto below = namesUnder(indexOf(child), part);
    names.insert(below.begin(), below.end());
  }
  return names;
}

QModelIndex OutlinerModel::probe(std::size_t place) const {
  const auto found = probeItems_.find(place);
  return found != probeItems_.end() ? indexOf(found->second) : QModelIndex();
}

QModelIndex OutlinerModel::object(const std::string& node) const {
  const auto found = objectItems_.find(node);
  return found != objectItems_.end() ? indexOf(found->second) : QModelIndex();
}

QModelIndex OutlinerModel::group(Kind kind) const {
  for (const int at : top_) {
    if (items_[static_cast<std::size_t>(at)].kind == kind) return indexOf(at);
  }
  return {};
}

std::vector<std::size_t> OutlinerModel::probesShown() const {
  std::vector<std::size_t> places;
  for (const Item& each : items_) {
    if (each.kind == Kind::Probe) places.push_back(each.place);
  }
  std::sort(places.begin(), places.end());
  return places;
}

QModelIndex OutlinerModel::index(int row, int column, const QModelIndex& parent) const {
  const Item* of = item(parent);
  if (parent.isValid() && of == nullptr) return {};
  const std::vector<int>& rows = of != nullptr ? of->children : top_;
  if (row < 0 || column < 0 || column >= kColumns || row >= static_cast<int>(rows.size())) return {};
  return indexOf(rows[static_cast<std::size_t>(row)], column);
}

QModelIndex OutlinerModel::parent(const QModelIndex& child) const {
  const Item* of = item(child);
  return of != nullptr && of->parent >= 0 ? indexOf(of->parent) : QModelIndex();
}

int OutlinerModel::rowCount(const QModelIndex& parent) const {
  if (parent.column() > 0) return 0;
  const Item* of = item(parent);
  return static_cast<int>(of != nullptr ? of->children.size() : top_.size());
}

int OutlinerModel::columnCount(const QModelIndex&) const {
  return kColumns;
}

QString OutlinerModel::title(const Item& item) const {
  const int count = static_cast<int>(item.children.size());
  switch (item.kind) {
    case Kind::Probes:
      return tr("Probes");
    case Kind::Objects:
      return tr("Objects (%1)").arg(count);
    case Kind::Lamps:
      return tr("Lamps (%1)").arg(count);
    case Kind::Lights:
      return tr("Lights (%1)").arg(count);
    case Kind::Cameras:
      return tr("Cameras (%1)").arg(count);
    default:
      return QString::fromStdString(withoutGroup(item));
  }
}

std::string OutlinerModel::withoutGroup(const Item& item) const {
  if (item.kind != Kind::Probe || item.parent < 0) return item.name;
  const Item& group = items_[static_cast<std::size_t>(item.parent)];
  const std::string prefix = group.name + "/";
  const bool repeated = group.kind == Kind::Room && item.name.compare(0, prefix.size(), prefix) == 0;
  return repeated ? item.name.substr(prefix.size()) : item.name;
}

QVariant OutlinerModel::nameData(const Item& item, int role) const {
  const BakeStateLook* look = item.kind == Kind::Probe && item.place < looks_.size() ? &looks_[item.place] : nullptr;
  switch (role) {
    case Qt::DisplayRole:
      return title(item);
    case Qt::EditRole:
      return QString::fromStdString(item.name);
    case Qt::DecorationRole:
      if (look != nullptr) return stateIcon(*look);
      if (item.kind == Kind::Object) return signIcon(Sign::Object, false);
      if (item.kind == Kind::Lamp) return signIcon(Sign::Lamp, false);
      if (item.kind == Kind::Light) return signIcon(Sign::Light, false);
      if (item.kind == Kind::Camera) return signIcon(Sign::Camera, false);
      return {};
    case Qt::ToolTipRole:
      if (look != nullptr) {
        const std::string shown = withoutGroup(item);
        return shown == item.name ? look->text : QString::fromStdString(item.name) + ": " + look->text;
      }
      if (item.kind == Kind::Lamp) return tr("An object whose material shines");
      return {};
    case Qt::FontRole: {
      QFont font = QGuiApplication::font();
      font.setBold(groupOf(item.kind) || (item.kind == Kind::Probe && static_cast<int>(item.place) == bold_));
      return font;
    }
    case Qt::ForegroundRole: {
      const auto part = partOf(item.kind);
      if (!part || groupOf(item.kind) || state_.shown(*part, item.name)) return {};
      return QGuiApplication::palette().brush(QPalette::PlaceholderText);
    }
    default:
      return {};
  }
}

// Of a group: whether anything in it is shown, and whether all of it is locked.
QVariant OutlinerModel::markData(const Item& item, int column, int role) const {
  const auto part = partOf(item.kind);
  if (!part || (role != Qt::DecorationRole && role != Qt::AccessibleTextRole && role != Qt::ToolTipRole)) return {};
  if (groupOf(item.kind) && item.children.empty()) return {};
  const std::function<bool(const Item&, const Test&)> holdsFor = [&](const Item& of, const Test& test) {
    if (!groupOf(of.kind)) return test(of.name);
    return std::all_of(of.children.begin(), of.children.end(),
                       [&](int child) { return holdsFor(items_[static_cast<std::size_t>(child)], test); });
  };
  const auto holds = [&](const Test& test) { return holdsFor(item, test); };
  const QString name = title(item);
  if (column == kEye) {
    const bool off = holds([&](const std::string& each) { return !state_.shown(*part, each); });
    if (role == Qt::DecorationRole) return signIcon(off ? Sign::EyeShut : Sign::Eye, off);
    if (role == Qt::AccessibleTextRole) return off ? tr("%1 is hidden").arg(name) : tr("%1 is shown").arg(name);
    return role == Qt::ToolTipRole
               ? tr("Shows or hides it in this window (H). Ctrl+click isolates it (/). The scene file, "
                    "captures, exported pictures and errors still include it.")
               : QVariant();
  }
  const bool locked = holds([&](const std::string& each) { return state_.locked(*part, each); });
  if (role == Qt::DecorationRole) return signIcon(locked ? Sign::Lock : Sign::LockOpen, !locked);
  if (role == Qt::AccessibleTextRole) return locked ? tr("%1 is locked").arg(name) : tr("%1 is free").arg(name);
  return role == Qt::ToolTipRole ? tr("Clicks in the view pass through it and its handles do not move. In this window "
                                      "only; not saved in the "
                                      "scene file.")
                                 : QVariant();
}

QVariant OutlinerModel::data(const QModelIndex& index, int role) const {
  const Item* of = item(index);
  if (of == nullptr) return {};
  return index.column() == kName ? nameData(*of, role) : markData(*of, index.column(), role);
}

bool OutlinerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable)) return false;
  emit renamed(index, value.toString());
  return false;  // the scene tells what it is called now
}

Qt::ItemFlags OutlinerModel::flags(const QModelIndex& index) const {
  const Item* of = item(index);
  if (of == nullptr) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (index.column() == kName && (of->kind == Kind::Probe || of->kind == Kind::Camera)) flags |= Qt::ItemIsEditable;
  return flags;
}

}  // namespace boxprobe
