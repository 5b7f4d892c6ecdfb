// See cost_panel.h.
#include "app/gui/panels/cost_panel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/edit/probe_fields.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"
#include "filters/core/base/errors.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/technique_parameters.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/files/data_folder.h"
#include "filters/io/scene/pareto_front_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/reference/study/bench_technique.h"
#include "filters/vtk/charts/pareto_chart.h"

namespace boxprobe {

namespace {

/// The table of tests/bench/README.md, for scenes that nobody has measured yet.
constexpr const char* kShipped = "scenes/measured/gallery.json";

constexpr int kRedrawDelayMs = 150;  // while a splitter is dragged
constexpr int kLeastChartSide = 160;
enum Column { kTechnique, kCost, kError };

/// The same hues, with white as `ground` and black as nearly white.
QImage darkened(const QImage& chart, const QColor& ground) {
  constexpr int kBrightest = 235;
  QImage dark = chart.convertToFormat(QImage::Format_RGB32);
  const auto between = [](int from, int share) { return from + share * (kBrightest - from) / 255; };
  for (int y = 0; y < dark.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(dark.scanLine(y));
    for (int x = 0; x < dark.width(); ++x) {
      const int r = qRed(row[x]), g = qGreen(row[x]), b = qBlue(row[x]);
      const int turned = 255 - std::max({r, g, b}) - std::min({r, g, b});  // lightness the other way round
      row[x] = qRgb(between(ground.red(), r + turned), between(ground.green(), g + turned),
                    between(ground.blue(), b + turned));
    }
  }
  return dark;
}

// Sorts by value, not by text.
class Row : public QTreeWidgetItem {
 public:
  Row(const ParetoPoint& point, const ParetoPoint* hdrp) {
    setText(kTechnique, QString::fromStdString(point.label));
    setText(kCost, QString::number(point.cost, 'f', 2) + QChar(0x00d7));
    setText(kError, QString::number(point.error, 'f', 4));
    setData(kTechnique, Qt::UserRole, QString::fromStdString(point.id));
    setData(kCost, Qt::UserRole, point.cost);
    setData(kError, Qt::UserRole, point.error);
    setTextAlignment(kCost, Qt::AlignRight | Qt::AlignVCenter);
    setTextAlignment(kError, Qt::AlignRight | Qt::AlignVCenter);
    if (hdrp != nullptr && hdrp->error > 0.0) {
      setToolTip(kError, QObject::tr("%1 of HDRP's").arg(point.error / hdrp->error, 0, 'f', 2));
    }
  }
  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget()->sortColumn();
    if (column == kTechnique) return text(column) < other.text(column);
    return data(column, Qt::UserRole).toDouble() < other.data(column, Qt::UserRole).toDouble();
  }
};

}  // namespace

CostPanel::CostPanel(Workspace& workspace)
    : editor_(workspace.editor()),
      program_(QCoreApplication::applicationFilePath()),
      chart_(new QLabel(this)),
      state_(helpLabel(this)),
      table_(new QTreeWidget(this)),
      progress_(new QProgressBar(this)),
      quick_(new QPushButton(tr("Measure quickly"), this)),
      full_(new QPushButton(tr("Measure"), this)),
      stop_(new QPushButton(tr("Stop"), this)),
      redraw_(new QTimer(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  chart_->setAlignment(Qt::AlignCenter);
  chart_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  chart_->setMinimumHeight(kLeastChartSide);
  column->addWidget(chart_, 3);
  column->addWidget(state_);
  table_->setObjectName("costTable");
  table_->setHeaderLabels({tr("Technique"), tr("Frame"), tr("Error")});
  table_->headerItem()->setToolTip(kCost, tr("CPU time of a frame relative to plain box projection"));
  table_->headerItem()->setToolTip(kError, tr("RMSE of (x/(1+x))^(1/2.2) relative to the integral over the box"));
  table_->setRootIsDecorated(false);
  table_->setSortingEnabled(true);
  table_->sortByColumn(kError, Qt::AscendingOrder);
  table_->header()->setSectionResizeMode(kTechnique, QHeaderView::Stretch);
  table_->header()->setSectionResizeMode(kCost, QHeaderView::ResizeToContents);
  table_->header()->setSectionResizeMode(kError, QHeaderView::ResizeToContents);
  table_->header()->setStretchLastSection(false);
  table_->setToolTip(tr("Double-click to use this technique for the selected probe"));
  column->addWidget(table_, 2);
  auto* buttons = new QHBoxLayout;
  quick_->setObjectName("measureQuickly");
  full_->setObjectName("measure");
  stop_->setObjectName("stopMeasuring");
  quick_->setToolTip(tr("One camera and three roughnesses; takes about a minute"));
  full_->setToolTip(tr("Every camera and roughness; takes some minutes"));
  for (QPushButton* button : {quick_, full_, stop_}) buttons->addWidget(button);
  column->addLayout(buttons);
  chart_->setObjectName("costChart");
  progress_->setObjectName("costProgress");
  progress_->setRange(0, 100);
  column->addWidget(progress_);
  progress_->hide();
  stop_->hide();

  redraw_->setSingleShot(true);
  redraw_->setInterval(kRedrawDelayMs);
  connect(redraw_, &QTimer::timeout, this, &CostPanel::drawChart);
  connect(quick_, &QPushButton::clicked, this, [this] { measure(true); });
  connect(full_, &QPushButton::clicked, this, [this] { measure(false); });
  connect(stop_, &QPushButton::clicked, &process_, &QProcess::terminate);
  connect(&process_, &QProcess::readyReadStandardError, this, &CostPanel::readProgress);
  connect(&process_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this, &CostPanel::measured);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) emit failed(tr("the benchmark could not be started"));
  });
  connect(table_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item) {
    const auto technique = parseTechnique(item->data(kTechnique, Qt::UserRole).toString().toStdString());
    if (!technique) return;
    editor_.commitProbe(probeEditLabel(editor_, tr("technique")),
                        [id = shortTechniqueId(*technique)](Probe& probe) { probe.technique = id; });
  });
  workspace.listenTo(this);
  connect(&workspace, &Workspace::modelsReplaced, this, [this] { another_ = true; });
  using C = Changes;
  workspace.changes().add("cost panel", {&C::probeTechnique, &C::probeList, &C::selection, &C::file, &C::models},
                          [this](const C&) { update(); });
  load();
}

CostPanel::~CostPanel() {
  // Nobody is left to hear of it.
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.terminate();
  if (!process_.waitForFinished(3000)) process_.kill();
  process_.waitForFinished(1000);
}

std::string CostPanel::folderBeside(const std::string& scenePath) {
  const std::string probes = BakeFolder::besideScene(scenePath);  // "room.probes"
  return probes.substr(0, probes.rfind('.')) + ".bench";
}

bool CostPanel::measuring() const {
  return process_.state() != QProcess::NotRunning;
}

void CostPanel::useScene(const std::string& scenePath) {
  if (measuring()) {
    process_.terminate();
    ending_ = std::move(own_);  // still written into until it has ended
  }
  folder_ = scenePath.empty() ? std::string() : folderBeside(scenePath);
  own_.reset();
  load();
}

// What is on show is measured: where the file does not hold it, a copy.
QString CostPanel::sceneToMeasure() {
  editor_.finish();
  const Document& document = editor_.document();
  if (!document.path().empty() && !document.modified()) {
    own_.reset();
    folder_ = folderBeside(document.path());
    return QString::fromStdString(document.path());
  }
  auto own = std::make_unique<QTemporaryDir>();
  if (!own->isValid()) throw InputError(own->errorString().toStdString());
  const QString copy = own->filePath("shown.boxprobe.json");
  saveSceneFile(document.scene(), copy.toStdString());
  own_ = std::move(own);
  folder_ = own_->filePath("bench").toStdString();
  return copy;
}

void CostPanel::measure(bool quick) {
  if (measuring() || editor_.scene().models.empty()) return;
  QString scene;
  try {
    scene = sceneToMeasure();
  } catch (const Error& error) {
    return emit failed(QString::fromUtf8(error.what()));
  }
  QStringList arguments = {"bench", scene, "-o", QString::fromStdString(folder_), "--rooms", "0"};
  if (quick) arguments << "--quick";
  output_.clear();
  auto environment = QProcessEnvironment::systemEnvironment();
  environment.insert("BOXPROBE_PROGRESS", "lines");
  process_.setProcessEnvironment(environment);
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.start(program_, arguments);
  progress_->setValue(0);
  progress_->show();
  stop_->show();
  quick_->setEnabled(false);
  full_->setEnabled(false);
  emit message(tr("Measuring the scene as it is shown now; you can go on working"));
}

void CostPanel::readProgress() {
  output_ += process_.readAllStandardError();
  for (int end = output_.indexOf('\n'); end >= 0; end = output_.indexOf('\n')) {
    const QByteArray line = output_.left(end).trimmed();
    output_.remove(0, end + 1);
    if (line.startsWith("progress ")) {
      progress_->setValue(line.mid(9).toInt());
    } else if (line.startsWith("boxprobe: ") && !line.startsWith("boxprobe: warning")) {
      emit failed(QString::fromUtf8(line));
    }
  }
}

void CostPanel::measured(int exitCode, QProcess::ExitStatus status) {
  progress_->hide();
  stop_->hide();
  ending_.reset();
  if (status == QProcess::NormalExit && exitCode == 0) emit message(tr("%1 techniques measured").arg(points_.size()));
  load();
}

void CostPanel::load() {
  points_.clear();
  std::string path = folder_ + "/bench.json";
  shipped_ = folder_.empty() || !QFileInfo::exists(QString::fromStdString(path));
  if (shipped_) path = dataFile(kShipped);
  if (QFileInfo::exists(QString::fromStdString(path))) {
    try {
      points_ = loadParetoFront(path);
    } catch (const InputError& error) {
      emit failed(QString::fromUtf8(error.what()));
    }
  }
  enableButtons();
  fillTable();
  showCurrent(true);
}

void CostPanel::enableButtons() {
  for (QPushButton* button : {quick_, full_}) button->setEnabled(!measuring() && !editor_.scene().models.empty());
}

void CostPanel::fillTable() {
  const auto hdrp =
      std::find_if(points_.begin(), points_.end(), [](const ParetoPoint& p) { return p.id == kErrorBaseline; });
  table_->setSortingEnabled(false);
  table_->clear();
  for (const ParetoPoint& point : points_) {
    auto* row = new Row(point, hdrp != points_.end() ? &*hdrp : nullptr);
    QFont font = row->font(kTechnique);
    font.setBold(point.onParetoFront);
    row->setFont(kTechnique, font);
    table_->addTopLevelItem(row);
  }
  table_->setSortingEnabled(true);
}

// As the benchmark names what the selected probe draws with; with the parameters' defaults if it measured only those.
std::string CostPanel::currentLabel() const {
  const Probe* probe = editor_.probe();
  if (probe == nullptr) return {};
  const Technique technique = probeTechnique(*probe);
  BenchTechnique current;
  current.id = techniqueId(technique);
  for (const ParameterRow* row : parametersOf(technique)) {
    const auto set = probe->parameters.find(std::string(row->name));
    if (set != probe->parameters.end()) current.parameters[set->first] = set->second;
  }
  const auto known = [this](const std::string& label) {
    return std::any_of(points_.begin(), points_.end(), [&](const ParetoPoint& p) { return p.label == label; });
  };
  if (known(current.label())) return current.label();
  current.parameters.clear();
  return known(current.label()) ? current.label() : std::string();
}

void CostPanel::update() {
  if (another_) useScene(editor_.document().path());
  another_ = false;
  enableButtons();
  showCurrent(false);
}

void CostPanel::showCurrent(bool always) {
  const std::string label = currentLabel();
  if (label == shownLabel_ && !always) return;
  shownLabel_ = label;
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = table_->topLevelItem(i);
    item->setSelected(item->text(kTechnique).toStdString() == label);
  }
  const auto at = std::find_if(points_.begin(), points_.end(), [&](const ParetoPoint& p) { return p.label == label; });
  QString text;
  if (points_.empty()) {
    text =
        tr("Not measured yet in this scene. A measurement gives every technique's frame time and its error against the "
           "integral over the box.");
  } else if (at != points_.end()) {
    text = at->onParetoFront
               ? tr("%1 is on the Pareto front: no measured technique is both cheaper and more accurate.")
                     .arg(label.c_str())
               : tr("%1 is not on the Pareto front: another technique costs no more and has a lower error.")
                     .arg(label.c_str());
  } else {
    text = tr("The probe's technique is not among those measured.");
  }
  if (shipped_ && !points_.empty()) {
    text = tr("Measured in the example scene gallery, not in this one. Measure measures the scene on show. ") + text;
  }
  state_->setText(text);
  redraw_->start();
}

void CostPanel::setWatched(bool watched) {
  watched_ = watched;
  if (watched) redraw_->start();
}

void CostPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  redraw_->start();
}

void CostPanel::drawChart() {
  chart_->setVisible(!points_.empty());
  table_->setVisible(!points_.empty());
  if (!watched_ || points_.empty()) return;
  const int width = std::max(chart_->width(), kLeastChartSide), height = std::max(chart_->height(), kLeastChartSide);
  FrontChartText text;
  text.errorAxis = tr("Error").toStdString();
  text.costAxis = tr("Frame time relative to plain box projection").toStdString();
  text.current = shownLabel_;
  const ImageRgba8 picture = frontChartPicture(points_, text, width, height);
  onDark_ = palette().color(QPalette::Base).lightness() < 128;
  const QImage image(picture.pixels.data(), picture.width, picture.height, 4 * picture.width, QImage::Format_RGBA8888);
  chart_->setPixmap(QPixmap::fromImage(onDark_ ? darkened(image, palette().color(QPalette::Base)) : image));
}

void CostPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) redraw_->start();
}

}  // namespace boxprobe
