#include <rviz_plugins/panel/message_line.h>

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>

namespace cable_variation_rviz {

namespace {

constexpr int kMostLines = 7;

}  // namespace

MessageLine::MessageLine(QWidget* parent) : QFrame(parent), area_(new QScrollArea), label_(new QLabel) {
  setObjectName("message");
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  area_->setWidget(label_);
  area_->setWidgetResizable(true);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* close = new QToolButton;
  close->setText(QString::fromUtf8("\u00d7"));
  close->setAutoRaise(true);
  close->setToolTip("Close");
  connect(close, &QToolButton::clicked, this, &MessageLine::clear);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 2, 4);
  layout->addWidget(area_, 1);
  layout->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageLine::showError(const QString& text) { show(QString::fromUtf8("\u2718 ") + text, true); }

void MessageLine::showNote(const QString& text) { show(text, false); }

void MessageLine::clear() {
  label_->clear();
  error_ = false;
  hide();
}

QString MessageLine::text() const { return label_->text(); }

void MessageLine::show(const QString& text, bool error) {
  error_ = error;
  // Dark red on a pale ground: readable whatever the desktop's colours.
  QPalette colours = palette();
  const QColor ground = error ? QColor(255, 232, 230) : QColor(232, 240, 250);
  const QColor letters = error ? QColor(165, 0, 10) : QColor(20, 50, 90);
  colours.setColor(QPalette::Window, ground);
  colours.setColor(QPalette::WindowText, letters);
  colours.setColor(QPalette::ButtonText, letters);
  setPalette(colours);
  label_->setText(text);
  setVisible(true);
  fit();
}

void MessageLine::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit();
}

void MessageLine::fit() {
  const int wanted = label_->heightForWidth(std::max(60, area_->viewport()->width()));
  area_->setFixedHeight(std::min(wanted + 2, kMostLines * fontMetrics().lineSpacing()));
}

}  // namespace cable_variation_rviz
