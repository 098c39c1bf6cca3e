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
  connect(close, &QToolButton::clicked, this, &MessageLine::clearAll);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 2, 4);
  layout->addWidget(area_, 1);
  layout->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageLine::showError(const QString& of, const QString& text) {
  add({of, QString::fromUtf8("\u2718 ") + text, true});
}

void MessageLine::showNote(const QString& of, const QString& text) { add({of, text, false}); }

void MessageLine::clear(const QString& of) {
  remove(of);
  show();
}

void MessageLine::clearAll() {
  messages_.clear();
  show();
}

QString MessageLine::text() const { return label_->text(); }

bool MessageLine::isError() const {
  return std::any_of(messages_.begin(), messages_.end(), [](const Message& each) { return each.error; });
}

void MessageLine::add(const Message& message) {
  remove(message.of);
  messages_.insert(messages_.begin(), message);
  show();
}

void MessageLine::remove(const QString& of) {
  messages_.erase(
      std::remove_if(messages_.begin(), messages_.end(), [&](const Message& each) { return each.of == of; }),
      messages_.end());
}

void MessageLine::show() {
  QStringList lines;
  for (const Message& each : messages_) lines << each.text;
  const bool error = isError();
  // Dark red on a pale ground: readable whatever the desktop's colours.
  QPalette colours = palette();
  const QColor ground = error ? QColor(255, 232, 230) : QColor(232, 240, 250);
  const QColor letters = error ? QColor(165, 0, 10) : QColor(20, 50, 90);
  colours.setColor(QPalette::Window, ground);
  colours.setColor(QPalette::WindowText, letters);
  colours.setColor(QPalette::ButtonText, letters);
  setPalette(colours);
  label_->setText(lines.join('\n'));
  setVisible(!messages_.empty());
  if (!messages_.empty()) fit();
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
