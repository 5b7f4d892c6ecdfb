// The scene as a tree of names: probes in groups by room, objects, lamps, lights and cameras, with an eye and a lock
// for what the picture shows. One model and no widget per row; made anew in one pass when names change. Called by the
// outliner.
#pragma once

#include <QAbstractItemModel>
#include <QHash>
#include <QIcon>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "app/gui/edit/view_state.h"
#include "app/gui/panels/bake_state_look.h"
#include "filters/core/scene/model.h"

class QPainter;

namespace boxprobe {

class OutlinerModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { kName, kEye, kLock, kColumns };
  enum class Kind { Probes, Objects, Lamps, Lights, Cameras, Room, Probe, Object, Lamp, Light, Camera };

  explicit OutlinerModel(const ViewState& state, QObject* parent = nullptr);

  void setModels(const std::vector<std::shared_ptr<const Model>>& models);
  /// Names of the scene that have `words` in them, whatever the case; empty: all. Emits modelReset if other rows
  /// result. True: rows have got other names in place.
  bool show(const Scene& scene, const QString& words);
  /// In the scene's order.
  void showStates(const std::vector<BakeStateLook>& looks);
  /// That probe's name is set in bold: of several selected, the one whose fields are shown. -1: none.
  void markShown(int probe);
  /// What is hidden or locked has changed.
  void stateChanged();

  Kind kind(const QModelIndex& row) const;
  bool isGroup(const QModelIndex& row) const;
  /// Place in the scene's list: probes, lights, cameras.
  std::size_t place(const QModelIndex& row) const;
  /// Of a probe, an object, a camera; what a group is called.
  std::string name(const QModelIndex& row) const;
  /// All of that part at or below the row.
  ViewState::Names namesUnder(const QModelIndex& row, ViewState::Part part) const;
  /// Invalid where the row is not there, or filtered out.
  QModelIndex probe(std::size_t place) const;
  QModelIndex object(const std::string& node) const;
  QModelIndex group(Kind kind) const;
  /// Of all probes in rows, ascending.
  std::vector<std::size_t> probesShown() const;
  /// All objects' nodes, lamps too.
  const ViewState::Names& nodes() const { return nodes_; }
  /// Names looked at by show() so far: what filling and finding cost.
  std::size_t namesExamined() const { return examined_; }

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  /// A name was typed into the row of a probe or a camera.
  void renamed(const QModelIndex& row, const QString& name);

 private:
  struct Item {
    Kind kind = Kind::Probes;
    std::string name;
    std::size_t place = 0;  ///< in the scene's list
    int parent = -1;        ///< -1: at the top
    int row = 0;
    std::vector<int> children;
    bool operator==(const Item& o) const {
      return kind == o.kind && name == o.name && place == o.place && parent == o.parent && children == o.children;
    }
  };
  using Items = std::vector<Item>;
  /// All that the rows are made of, beside the models.
  struct Basis {
    QString words;
    std::vector<std::string> probes, cameras;
    std::vector<LightType> lights;
    std::vector<std::vector<char>> shining;  ///< of each model, its materials
    bool operator==(const Basis& o) const {
      return words == o.words && probes == o.probes && cameras == o.cameras && lights == o.lights &&
             shining == o.shining;
    }
  };
  Basis basisOf(const Scene& scene, const QString& words) const;
  static int add(Items& items, int parent, Kind kind, std::string name, std::size_t place);
  void addProbes(Items& items, const std::vector<Probe>& probes, const std::vector<std::size_t>& found);
  void addObjects(Items& items, const Basis& basis);
  bool found(const std::string& name, const QString& words);
  bool take(Items items);
  const Item* item(const QModelIndex& index) const;
  QModelIndex indexOf(int item, int column = kName) const;
  enum class Sign { Eye, EyeShut, Lock, LockOpen, Object, Lamp, Light, Camera };
  static void draw(QPainter& painter, Sign sign);
  QIcon signIcon(Sign sign, bool faint) const;
  QVariant nameData(const Item& item, int role) const;
  QVariant markData(const Item& item, int column, int role) const;
  QString title(const Item& item) const;
  /// "ceiling" of a probe "hall/ceiling", which stands under "hall".
  std::string withoutGroup(const Item& item) const;
  void everyRowChanged(const QVector<int>& roles);

  const ViewState& state_;
  std::vector<std::shared_ptr<const Model>> models_;
  ViewState::Names nodes_;
  Items items_;
  std::vector<int> top_;
  std::optional<Basis> shown_;
  std::unordered_map<std::size_t, int> probeItems_;  ///< by place
  std::unordered_map<std::string, int> objectItems_;
  std::vector<BakeStateLook> looks_;
  int bold_ = -1;
  mutable QHash<quint64, QIcon> icons_;
  std::size_t examined_ = 0;
};

/// The group of each probe, or "" for none: what stands before a "/" in its name; else what several names begin with
/// before a single letter ("kitchen a", "kitchen b"), as placing names them; else the probe that it is numbered after
/// ("kitchen 2", where there is a "kitchen"). Linear.
std::vector<std::string> probeGroups(const std::vector<Probe>& probes);

}  // namespace boxprobe
