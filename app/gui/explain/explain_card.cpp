// See explain_card.h.
#include "app/gui/explain/explain_card.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSplitter>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/explain/explanation_html.h"
#include "app/gui/explain/footprint_view.h"
#include "app/gui/widgets/phrase_words.h"
#include "app/session/explanation_json.h"
#include "filters/explain/explanation_text.h"

namespace boxprobe {

namespace {

QToolButton* button(const QString& text, const QString& toolTip, QWidget* parent) {
  auto* made = new QToolButton(parent);
  made->setText(text);
  made->setToolTip(toolTip);
  return made;
}

}  // namespace

ExplainCard::ExplainCard(MapsOf mapsOf, QWidget* parent)
    : QWidget(parent),
      mapsOf_(std::move(mapsOf)),
      state_(new QLabel(this)),
      follow_(button(tr("Follow the pointer"), tr("Unpins the card (Esc)"), this)),
      copyText_(button(tr("Copy text"), tr("Copies the whole calculation as text"), this)),
      copyJson_(button(tr("Copy JSON"),
                       tr("Copies the explanation as the command `boxprobe explain` prints it as JSON"), this)),
      sentence_(new QLabel(this)),
      mend_(new QPushButton(tr("Mend"), this)),
      text_(new QTextBrowser(this)),
      footprint_(new FootprintView(this)) {
  setObjectName("explainCard");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  auto* row = new QHBoxLayout;
  row->addWidget(state_, 1);
  for (QToolButton* each : {follow_, copyText_, copyJson_}) row->addWidget(each);
  layout->addLayout(row);
  sentence_->setObjectName("verdict");
  sentence_->setWordWrap(true);
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  mend_->setObjectName("mend");
  mend_->setToolTip(
      tr("Changes the probe; undo takes it back. It mends this pixel: the lookup error in the debug view "
         "shows what it does to the others."));
  layout->addWidget(sentence_);
  layout->addWidget(mend_, 0, Qt::AlignLeft);
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->addWidget(text_);
  splitter->addWidget(footprint_);
  splitter->setStretchFactor(0, 1);
  splitter->setCollapsible(0, false);
  splitter->setSizes({420, 260});
  layout->addWidget(splitter, 1);
  text_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  text_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // its coming and going would lay the text out twice
  text_->setOpenLinks(false);
  connect(follow_, &QToolButton::clicked, this, &ExplainCard::unpinRequested);
  connect(copyText_, &QToolButton::clicked, this, &ExplainCard::copyText);
  connect(copyJson_, &QToolButton::clicked, this, &ExplainCard::copyJson);
  connect(mend_, &QPushButton::clicked, this, [this] {
    if (verdict_.mend) emit mendRequested(*verdict_.mend);
  });
  setPinned(false);
  showHint({});
}

void ExplainCard::show(const Explanation& explanation, const Verdict& verdict, double exposure, Tone tone) {
  explanation_ = explanation;
  verdict_ = verdict;
  exposure_ = exposure;
  tone_ = tone;
  stale_ = true;
  if (isVisible()) fill();
}

void ExplainCard::showHint(const QString& hint) {
  explanation_.reset();
  stale_ = false;
  verdict_ = {};
  showVerdict();
  footprint_->hide();
  text_->setHtml("<p>" + hint.toHtmlEscaped() + "</p>");
  copyText_->setEnabled(false);
  copyJson_->setEnabled(false);
}

void ExplainCard::setPinned(bool pinned) {
  state_->setText(pinned ? tr("Pinned") : tr("Under the pointer"));
  follow_->setVisible(pinned);
}

ExplanationDetail ExplainCard::detail() const {
  ExplanationDetail detail;
  detail.texelValue = [this](const ProbeExplanation& probe, const TexelShare& t) -> std::optional<glm::vec3> {
    const auto maps = mapsOf_(probe.name);
    if (!maps || t.level >= maps->radiance.levels()) return std::nullopt;
    return glm::vec3(maps->radiance.texel(t.level, t.face, t.column, t.row));
  };
  return detail;
}

void ExplainCard::fill() {
  stale_ = false;
  const Explanation& e = *explanation_;
  showVerdict();
  // Who reads further down keeps his place while the numbers change.
  const int scrolled = text_->verticalScrollBar()->value();
  text_->setHtml(explanationHtml(e, detail(), exposure_, tone_));
  text_->verticalScrollBar()->setValue(scrolled);
  footprint_->setVisible(e.dominant >= 0);
  if (e.dominant >= 0) {
    const ProbeExplanation& probe = e.probes[static_cast<std::size_t>(e.dominant)];
    footprint_->show(probe, mapsOf_(probe.name), exposure_);
  }
  copyText_->setEnabled(true);
  copyJson_->setEnabled(true);
}

void ExplainCard::showVerdict() {
  sentence_->setVisible(!verdict_.sentence.empty());
  QString text = phraseWords(verdict_.sentence);
  if (verdict_.mend) text += "\n" + tr("%1.").arg(phraseWords(verdict_.mend->words));
  sentence_->setText(text);
  mend_->setVisible(verdict_.mend.has_value());
}

void ExplainCard::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) fill();
}

void ExplainCard::copyText() const {
  if (explanation_)
    QApplication::clipboard()->setText(QString::fromStdString(explanationText(*explanation_, detail(), verdict_)));
}

void ExplainCard::copyJson() const {
  if (!explanation_) return;
  QApplication::clipboard()->setText(QString::fromStdString(explanationJson(*explanation_, verdict_)));
}

QString ExplainCard::text() const {
  return text_->toPlainText();
}

}  // namespace boxprobe
